// What the writers of programs share.
import { AXIS_NAMES, axisKey, slopes } from "../profiles";
import type { Change } from "../run";
import type { Command, Point, Values } from "../state";

/** Writes the program of a profile. Its last line tells the duration and where the axis is then. With changes, a group runs it. */
export interface Writer {
    bell(fastest: boolean, values: Values): string;
    trap(fastest: boolean, values: Values): string;
    poly(degree: number, values: Values): string;
    move(values: Values, commands: Command[], changes?: Change[]): string;
    axes(plan: "sync" | "line", values: Values, changes?: Change[]): string;
    path(values: Values, points: Point[], changes?: Change[]): string;
}

export const bellArguments = ({ jm, am, vm, p0, p1, v0, v1 }: Values) => [jm, am, vm, p0, p1, v0, v1];
export const trapArguments = (values: Values) => [values.vm, ...slopes(values), values.p0, values.p1, values.v0, values.v1];
export const polyArguments = (degree: number, { ts, p0, p1, v0, v1, a0, a1, j0, j1 }: Values) =>
    [ts, p0, p1, v0, v1, a0, a1, j0, j1].slice(0, degree + 2);
export const BELL_ORDER = "jerk, acceleration, velocity; from, to; velocity at the start, at the end";
export const TRAP_ORDER = "velocity; acceleration before and after the cruise; from, to; velocity at the start, at the end";
export const POLY_ORDER = "duration; from, to; then each derivative at the start, at the end";
export const MOVE_ORDER = "velocity, acceleration, jerk: the highest, the lowest";
export const PATH_ORDER = "of each point";
export const STATE_ORDER = "position, velocity, acceleration";

/** The numbers of one axis. */
export function ofAxis(values: Values, axis: number, ...keys: string[]): number[] {
    return keys.map((key) => values[axisKey(axis, key)]);
}

/** One entry for each axis. */
export function eachAxis(entry: (axis: number) => string): string[] {
    return AXIS_NAMES.map((_, axis) => entry(axis));
}

/** A list in one line, or an entry in each line if it is long, with this comma after the last one. */
export function wrapped(before: string, entries: string[], after: string, comma = ""): string[] {
    const line = before + entries.join(", ") + after;
    if (line.length < 88) {
        return [line];
    }
    const indent = " ".repeat(before.search(/\S/));
    return [before, ...`${indent}    ${entries.join(`,\n${indent}    `)}${comma}`.split("\n"), indent + after];
}

export const body = (...lines: (string | string[])[]) => lines.flat().map((line) => line && `    ${line}`).join("\n");

/** Whether a path has zones around its waypoints. */
export const hasZones = ({ zone }: Values, points: Point[]) => zone !== 0 && points.length > 2;

/** How many numbers of working memory the path of two axes needs: that of `atraj_path_size`, or with zones of `atraj_path_size_near`. */
export const workSize = (sections: number, zones: boolean) => (zones ? 169 * sections - 44 : 104 * sections - 20);

/** What is said next to a change of a run. */
export const changeName = ({ rate }: Change) => (rate === undefined ? "stop" : rate === 0 ? "hold" : `${Math.round(100 * rate)} %`);

/** From this tick on a run is over when its motion is. */
export const lastChange = (changes: Change[]) => changes.at(-1)?.tick ?? 0;

/** The limits of the machine, if the plans leave a reserve of them; else those of the plans. */
export const ofMachine = ({ reserve }: Values) => (reserve ? "machine" : "limits");
export const MACHINE = "the limits without the reserve, for hold and override";
