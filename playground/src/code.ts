// The programs that plan what the page shows, in C, C++ and Rust.
import { AXIS_NAMES, axisKey, plannedAxisLimits, plannedLimits, slopes } from "./profiles";
import type { Command, State, Values } from "./state";

export type Language = "C" | "C++" | "Rust";

export const LANGUAGES: Language[] = ["C", "C++", "Rust"];

/** The program that plans `state`. Its last line tells the duration and where the axis is then. */
export function code(language: Language, state: State): string {
    const { profile, values, commands } = state;
    const write = { C: cWriter(C), "C++": cWriter(CPP), Rust: rust }[language];
    switch (profile) {
        case "bell":
        case "liba-bell":
            return write.bell(profile === "bell", values);
        case "trap":
        case "liba-trap":
            return write.trap(profile === "trap", values);
        case "poly3":
        case "poly5":
        case "poly7":
            return write.poly(Number(profile.slice(4)), values);
        case "sync":
        case "line":
            return write.axes(profile, values);
        default:
            return write.move(values, commands);
    }
}

interface Writer {
    bell(fastest: boolean, values: Values): string;
    trap(fastest: boolean, values: Values): string;
    poly(degree: number, values: Values): string;
    move(values: Values, commands: Command[]): string;
    axes(plan: "sync" | "line", values: Values): string;
}

const bellArguments = ({ jm, am, vm, p0, p1, v0, v1 }: Values) => [jm, am, vm, p0, p1, v0, v1];
const trapArguments = (values: Values) => [values.vm, ...slopes(values), values.p0, values.p1, values.v0, values.v1];
const polyArguments = (degree: number, { ts, p0, p1, v0, v1, a0, a1, j0, j1 }: Values) =>
    [ts, p0, p1, v0, v1, a0, a1, j0, j1].slice(0, degree + 2);
const BELL_ORDER = "jerk, acceleration, velocity; from, to; velocity at the start, at the end";
const TRAP_ORDER = "velocity; acceleration before and after the cruise; from, to; velocity at the start, at the end";
const POLY_ORDER = "duration; from, to; then each derivative at the start, at the end";
const MOVE_ORDER = "velocity, acceleration, jerk: the highest, the lowest";
const STATE_ORDER = "position, velocity, acceleration";

/** The numbers of one axis. */
function ofAxis(values: Values, axis: number, ...keys: string[]): number[] {
    return keys.map((key) => values[axisKey(axis, key)]);
}

/** One entry for each axis. */
function eachAxis(entry: (axis: number) => string): string[] {
    return AXIS_NAMES.map((_, axis) => entry(axis));
}

/** A list in one line, or an entry in each line if it is long. */
function wrapped(before: string, entries: string[], after: string): string[] {
    const line = before + entries.join(", ") + after;
    if (line.length < 88) {
        return [line];
    }
    const indent = " ".repeat(before.search(/\S/));
    return [before, ...`${indent}    ${entries.join(`,\n${indent}    `)}`.split("\n"), indent + after];
}

const body = (...lines: (string | string[])[]) => lines.flat().map((line) => line && `    ${line}`).join("\n");

/** How C or C++ says what both say. */
interface Dialect {
    head: string;
    print: string;
    /** The types `limits`, `state` and `move` begin so. */
    types: string;
    type(struct: string): string;
    /** liba's plan, and the position at `t`. */
    generate(struct: string, operands: string): string;
    position(struct: string): string;
    /** A call of a move's function. */
    call(name: string, operands: string[]): string;
    state(time: string): string;
}

/** A number is passed as it is, a struct by its address. */
const byAddress = (operand: string) => (/^-?[\d.]/.test(operand) ? operand : `&${operand}`);

const C: Dialect = {
    head: '#include "atraj.h"\n#include <stdio.h>\n\nint main(void)',
    print: "printf",
    types: "atraj_",
    type: (struct) => `a_${struct}`,
    generate: (struct, operands) => `a_${struct}_gen(&axis, ${operands})`,
    position: (struct) => (struct === "move" ? "atraj_move_pos(&axis, t)" : `a_${struct}_pos(&axis, t)`),
    call: (name, operands) => `atraj_move_${name}(&axis, ${operands.map(byAddress).join(", ")})`,
    state: (time) => `atraj_move_state(&axis, ${time}, &now.p, &now.v, &now.a, NULL);`,
};

const CPP: Dialect = {
    head: '#include "atraj.h"\n#include <cstdio>\n\nint main()',
    print: "std::printf",
    types: "atraj::",
    type: (struct) => `a::${struct}`,
    generate: (_, operands) => `axis.gen(${operands})`,
    position: () => "axis.pos(t)",
    call: (name, operands) => `axis.${name}(${operands.join(", ")})`,
    state: (time) => `now = axis.state(${time});`,
};

const braces = (...numbers: number[]) => `{${numbers.join(", ")}}`;

function cWriter({ head, print, types, type, generate, position, call, state }: Dialect): Writer {
    const main = (...lines: string[]) => `${head}\n{\n${body(...lines, "return 0;")}\n}\n`;
    const unless = (planned: string) => `if (${planned} < 0) { return 1; }`;

    /** Prints eleven setpoints: the time `t` is from 0 to `duration`, `since` is the start of the plan. */
    const setpoints = (duration: string, since: string, ...positions: string[]) => {
        const format = `"%.4f s:${" %.4f".repeat(positions.length)} m\\n"`;
        const gap = positions.length > 1 ? `,\n${" ".repeat(print.length + 5)}` : ", ";
        return [
            "for (int k = 0; k <= 10; ++k) {",
            `    double const t = ${duration} * k / 10;`,
            ...`    ${print}(${format}, ${since}t${gap}${positions.join(", ")});`.split("\n"),
            "}",
        ];
    };

    const planned = (struct: string, order: string, plan: string) =>
        main(
            `${type(struct)} axis;`,
            `/* ${order} */`,
            `double const duration = ${plan};`,
            "if (!(duration > 0)) { return 1; }",
            ...setpoints("duration", "", position(struct)),
        );

    const replan = ({ time, kind, target }: Command, i: number, all: Command[]) => [
        "",
        `/* at ${time} s */`,
        state(i > 0 ? `${time} - ${all[i - 1].time}` : String(time)),
        ...(kind === "to" ? [`${types}state const target${i + 1} = ${braces(target, 0, 0)};`] : []),
        unless(
            kind === "to" ? call("plan", ["limits", "now", `target${i + 1}`])
            : kind === "jog" ? call("reach", ["limits", "now", String(target), "0"])
            : call("stop", ["limits", "now"]),
        ),
    ];

    return {
        bell(fastest, values) {
            const operands = bellArguments(values).join(", ");
            return planned("trajbell", BELL_ORDER, fastest ? `atraj_bell_gen(&axis, ${operands})` : generate("trajbell", operands));
        },
        trap(fastest, values) {
            const operands = trapArguments(values).join(", ");
            return planned("trajtrap", TRAP_ORDER, fastest ? `atraj_trap_gen(&axis, ${operands})` : generate("trajtrap", operands));
        },
        poly(degree, values) {
            const struct = `trajpoly${degree}`;
            return main(
                `${type(struct)} axis;`,
                `/* ${POLY_ORDER} */`,
                `${generate(struct, polyArguments(degree, values).join(", "))};`,
                ...setpoints(real(values.ts), "", position(struct)),
            );
        },
        move(values, commands) {
            const { p0, v0, a0, p1, v1, a1 } = values;
            return main(
                `/* ${MOVE_ORDER} */`,
                `${types}limits const limits = ${braces(...plannedLimits(values))};`,
                `/* ${STATE_ORDER} */`,
                `${types}state ${commands.length ? "now" : "const now"} = ${braces(p0, v0, a0)};`,
                `${types}state const target = ${braces(p1, v1, a1)};`,
                `${types}move axis;`,
                unless(call("plan", ["limits", "now", "target"])),
                ...commands.flatMap(replan),
                "",
                ...setpoints("axis.t", commands.length ? `${commands.at(-1)!.time} + ` : "", position("move")),
            );
        },
        axes(plan, values) {
            const n = AXIS_NAMES.length;
            const from = eachAxis((axis) => braces(...ofAxis(values, axis, "p0", "v0"), 0));
            const to = eachAxis((axis) => braces(...ofAxis(values, axis, "p1"), 0, 0));
            const limits = eachAxis((axis) => plannedAxisLimits(values, axis).join(", "));
            return main(
                `${types}limits limits[${n}];`,
                `/* ${STATE_ORDER} */`,
                `${types}state const from[${n}] = {${from.join(", ")}};`,
                `${types}state const to[${n}] = {${to.join(", ")}};`,
                `${types}move axes[${n}];`,
                "/* jerk, acceleration, velocity */",
                ...limits.map((operands, axis) => `atraj_limits_init(&limits[${axis}], ${operands});`),
                "/* the least duration, and the clock */",
                unless(`atraj_moves_${plan}(axes, limits, from, to, ${n}, ${values.least}, ${values.cycle})`),
                ...setpoints("axes[0].t", "", ...eachAxis((axis) => `atraj_move_pos(&axes[${axis}], t)`)),
            );
        },
    };
}

/** A number that no compiler takes for an integer. */
const real = (value: number) => (Number.isInteger(value) && !String(value).includes("e") ? `${value}.0` : String(value));
const reals = (...values: number[]) => values.map(real).join(", ");
const rustMain = (uses: string[], ...lines: (string | string[])[]) =>
    `${uses.map((path) => `use atraj::${path};\n`).join("")}\nfn main() {\n${body(...lines)}\n}\n`;
const rustState = (position: number, velocity: number, acceleration: number) =>
    velocity === 0 && acceleration === 0
        ? `State::at(${real(position)})`
        : `State { position: ${real(position)}, velocity: ${real(velocity)}, acceleration: ${real(acceleration)} }`;
const rustBoundary = ({ p0, p1, v0, v1 }: Values) =>
    `let ends = Boundary { p0: ${real(p0)}, p1: ${real(p1)}, v0: ${real(v0)}, v1: ${real(v1)} };`;

function rustSetpoints(duration: string, since: string, ...positions: string[]): string[] {
    const format = `"{:.4} s:${" {:.4}".repeat(positions.length)} m"`;
    return [
        "for k in 0..=10 {",
        `    let t = ${duration} * f64::from(k) / 10.0;`,
        ...wrapped("    println!(", [format, `${since}t`, ...positions], ");"),
        "}",
    ];
}

const rustPosition = (duration: string, since = "") => rustSetpoints(duration, since, "axis.position(t)");

const rust: Writer = {
    bell: (fastest, values) =>
        rustMain(
            ["{Bell, Boundary}"],
            rustBoundary(values),
            "// jerk, acceleration, velocity",
            `let axis = Bell::${fastest ? "fastest" : "new"}(${reals(values.jm, values.am, values.vm)}, ends).expect("a move");`,
            rustPosition("axis.t"),
        ),
    trap: (fastest, values) =>
        rustMain(
            ["{Boundary, Trap}"],
            rustBoundary(values),
            "// velocity; acceleration before and after the cruise",
            `let axis = Trap::${fastest ? "fastest" : "new"}(${reals(values.vm, ...slopes(values))}, ends).expect("a move");`,
            rustPosition("axis.t"),
        ),
    poly: (degree, values) => {
        const { ts, a0, a1, j0, j1 } = values;
        const more = [`[${reals(a0, a1)}]`, `[${reals(j0, j1)}]`].slice(0, (degree - 3) / 2);
        return rustMain(
            [`{Boundary, Poly${degree}}`],
            rustBoundary(values),
            "// duration, ends, then each higher derivative at the start and at the end",
            `let axis = Poly${degree}::new(${[real(ts), "ends", ...more].join(", ")}).expect("a duration");`,
            rustPosition(real(ts)),
        );
    },
    move: (values, commands) => {
        const { p0, v0, a0, p1, v1, a1 } = values;
        const [vmax, vmin, amax, amin, jmax, jmin] = plannedLimits(values).map(real);
        return rustMain(
            ["State", "online::{Limits, Move}"],
            `let limits = Limits { vmax: ${vmax}, vmin: ${vmin}, amax: ${amax}, amin: ${amin}, jmax: ${jmax}, jmin: ${jmin} };`,
            `let (now, target) = (${rustState(p0, v0, a0)}, ${rustState(p1, v1, a1)});`,
            "let mut axis = Move::default();",
            'axis.plan(&limits, now, target).expect("a move");',
            commands.flatMap(({ time, kind, target }, i) => [
                "",
                `// at ${time} s`,
                `let now = axis.state_at(${real(time)}${i > 0 ? ` - ${real(commands[i - 1].time)}` : ""});`,
                {
                    to: `axis.plan(&limits, now, ${rustState(target, 0, 0)}).expect("a move");`,
                    jog: `axis.reach(&limits, now, ${real(target)}, 0.0).expect("a move");`,
                    stop: 'axis.stop(&limits, now).expect("a move");',
                }[kind],
            ]),
            "",
            rustPosition("axis.t", commands.length ? `${real(commands.at(-1)!.time)} + ` : ""),
        );
    },
    axes: (plan, values) => {
        const n = AXIS_NAMES.length;
        const limits = eachAxis((axis) => `Limits::symmetric(${reals(...plannedAxisLimits(values, axis))})`);
        const from = eachAxis((axis) => {
            const [p0, v0] = ofAxis(values, axis, "p0", "v0");
            return rustState(p0, v0, 0);
        });
        const to = eachAxis((axis) => rustState(values[axisKey(axis, "p1")], 0, 0));
        return rustMain(
            ["axes", "State", "online::{Limits, Move}"],
            "// jerk, acceleration, velocity",
            wrapped("let limits = [", limits, "];"),
            wrapped("let from = [", from, "];"),
            wrapped("let to = [", to, "];"),
            `let mut moves = [Move::default(); ${n}];`,
            "// the least duration, and the clock",
            `axes::${plan === "sync" ? "synchronise" : "line"}(&mut moves, &limits, &from, &to, ${reals(values.least, values.cycle)})`,
            '    .expect("moves");',
            rustSetpoints("moves[0].t", "", ...eachAxis((axis) => `moves[${axis}].position(t)`)),
        );
    },
};
