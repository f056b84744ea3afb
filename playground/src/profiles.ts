// The profiles of the page: their fields, and how the library plans them.
import { AXES, bell, c, message, MOVES, Motion, move, Plan, type Quantities, type Range, trap } from "./library";
import { PERIOD, type Start } from "./run";
import type { Command, Point, State, Values } from "./state";

export interface Field {
    key: string;
    label: string;
    /** Empty: a choice, 0 or 1. */
    unit: string;
    min: number;
    max: number;
    initial: number;
}

export interface Group {
    title: string;
    fields: Field[];
    /** Shown for this axis only. */
    axis?: number;
    /** Shown if the field of this key is 1. */
    when?: string;
}

export interface Remark {
    kind: "good" | "note" | "bad";
    text: string;
}

/** What came of a plan. The motions are drawn on top of each other. */
export interface Outcome {
    motions: Motion[];
    remarks: Remark[];
    /** The first command that the library refuses, counted from 0. */
    refused?: number;
}

export interface Profile {
    id: string;
    name: string;
    note: string;
    groups: Group[];
    /** The planner to compare with. */
    rival?: string;
    /** The axes have names, and each has fields of its own. */
    axes?: string[];
    /** The axis can be retargeted in motion. */
    live?: boolean;
    /** A group can run the moves. */
    runs?: boolean;
    /** What the dashed lines on the plots mark. */
    marks?: string;
    /** Two axes pass waypoints. */
    points?: boolean;
    plan(state: State): Outcome;
}

export const AXIS_NAMES = ["X", "Y", "Z"].slice(0, AXES);

const field = (key: string, label: string, unit: string, min: number, max: number, initial: number): Field => {
    return { key, label, unit, min, max, initial };
};
const JERK = field("jm", "Jerk", "m/s³", 0, 100, 30);
const ACCELERATION = field("am", "Acceleration", "m/s²", 0, 30, 10);
const VELOCITY = field("vm", "Velocity", "m/s", 0, 10, 5);
const START = field("p0", "Position", "m", -20, 20, 0);
const END = field("p1", "Position", "m", -20, 20, 10);
const ends = (...labels: [key: string, label: string, unit: string][]): Group[] =>
    ["Start", "End"].map((title, i) => ({
        title,
        fields: [[START, END][i], ...labels.map(([key, label, unit]) => field(`${key}${i}`, label, unit, -10, 10, 0))],
    }));
const V: [string, string, string] = ["v", "Velocity", "m/s"];
const A: [string, string, string] = ["a", "Acceleration", "m/s²"];
const J: [string, string, string] = ["j", "Jerk", "m/s³"];
/** How far each axis may pass a waypoint. */
const ZONE = field("zone", "Around each waypoint", "m", 0, 2, 0);
const DURATION: Group = { title: "Move", fields: [field("ts", "Duration", "s", 0, 10, 3)] };

/** Limits of velocity, acceleration and jerk that are the same in both directions. */
const symmetric = (...highest: number[]): Quantities<Range | undefined> => [
    undefined,
    ...highest.map((limit): Range => [-Math.abs(limit), Math.abs(limit)]),
];

const [STARTS_OUTSIDE, LIMITS, UNREACHABLE] = [c.starts_outside(), c.limits_refused(), c.unreachable()];

/** What a planner or a check returns, in words. */
function findings(subject: string, code: number, clean: string): Remark[] {
    if (code < 0) {
        return [{ kind: "bad", text: `${subject} refuses: ${message(code)}.` }];
    }
    const found: Remark[] = [];
    for (let rest = code; rest > 0; rest &= rest - 1) {
        const lowest = rest & -rest;
        found.push({ kind: c.is_fault(lowest) ? "bad" : "note", text: `${subject}: ${message(lowest)}.` });
    }
    const isClean = !(code & STARTS_OUTSIDE) && found.every(({ kind }) => kind === "note");
    return isClean ? [{ kind: "good", text: `${subject} ${clean}.` }, ...found] : found;
}

/** One of two planners that fill the same struct. */
interface Planner {
    name: "atraj" | "liba";
    generate(place: number): number;
    read(place: number, duration: number): Plan;
    check(place: number): number;
    /** Velocity at the end that was asked for, m/s. */
    v1: number;
    limits: Quantities<Range | undefined>;
    idle: boolean;
}

function outcomeOf(planner: Planner, place: number, compared: boolean): Outcome {
    const { name, limits, v1 } = planner;
    const duration = planner.generate(place);
    if (duration === 0 && planner.idle) {
        return { motions: [], remarks: [{ kind: "note", text: `${name}: there is nothing to do.` }] };
    }
    if (!(duration > 0)) {
        return { motions: [], remarks: findings(name, name === "liba" ? UNREACHABLE : LIMITS, "") };
    }
    const motion = new Motion(name, [{ start: 0, plan: planner.read(place, duration) }], limits, compared);
    const remarks = findings(name, planner.check(place), "keeps every limit");
    const reached = motion.state(duration)[1];
    if (Math.abs(reached - v1) > 1e-9 * Math.max(1, Math.abs(v1))) {
        remarks.push({ kind: "bad", text: `${name} ends with the velocity ${reached.toFixed(4)}, not with ${v1}.` });
    }
    return { motions: [motion], remarks };
}

/** The chosen planner, and the other one next to it. */
function bothOf(chosen: Planner, rival: Planner, compare: boolean): Outcome {
    const ours = outcomeOf(chosen, c.plan_at(0), false);
    if (!compare) {
        return ours;
    }
    const theirs = outcomeOf(rival, c.plan_at(1), true);
    const [motions, remarks] = [[...ours.motions, ...theirs.motions], [...ours.remarks, ...theirs.remarks]];
    if (motions.length === 2) {
        const longer = motions[1].duration - motions[0].duration;
        const amount = `${Math.abs(longer).toFixed(4)} s`;
        const text = Math.abs(longer) < 5e-5 ? "takes as long" : `takes ${amount} ${longer > 0 ? "longer" : "less"}`;
        remarks.push({ kind: "note", text: `${rival.name} ${text}.` });
    }
    return { motions, remarks };
}

function planBell(values: Values, chosen: "atraj" | "liba", compare: boolean): Outcome {
    const { jm, am, vm, p0, p1, v0, v1 } = values;
    const planner = (name: "atraj" | "liba"): Planner => {
        const generate = name === "atraj" ? c.atraj_bell_gen : c.a_trajbell_gen;
        return {
            name,
            generate: (place) => generate(place, jm, am, vm, p0, p1, v0, v1),
            read: bell,
            check: (place) => c.atraj_bell_check(place, jm, am, vm),
            v1: within(v1, vm),
            limits: symmetric(vm, am, jm),
            idle: p0 === p1 && v0 === v1,
        };
    };
    return bothOf(planner(chosen), planner(chosen === "atraj" ? "liba" : "atraj"), compare);
}

/** The accelerations of a trapezoid have signs: those of a forward or of a backward move. */
export function slopes({ ac, de, p0, p1 }: Values): [ac: number, de: number] {
    return p1 < p0 ? [-ac, de] : [ac, -de];
}

function planTrap(values: Values, chosen: "atraj" | "liba", compare: boolean): Outcome {
    const { vm, p0, p1, v0, v1 } = values;
    const [ac, de] = slopes(values);
    const planner = (name: "atraj" | "liba"): Planner => {
        const generate = name === "atraj" ? c.atraj_trap_gen : c.a_trajtrap_gen;
        return {
            name,
            generate: (place) => generate(place, vm, ac, de, p0, p1, v0, v1),
            read: trap,
            check: (place) => c.atraj_trap_check(place, vm, ac, de),
            v1: within(v1, vm),
            limits: [undefined, [-Math.abs(vm), Math.abs(vm)], [Math.min(ac, de), Math.max(ac, de)]],
            idle: p0 === p1 && v0 === v1,
        };
    };
    return bothOf(planner(chosen), planner(chosen === "atraj" ? "liba" : "atraj"), compare);
}

function within(velocity: number, limit: number): number {
    return Math.min(Math.max(velocity, -Math.abs(limit)), Math.abs(limit));
}

function planPoly(family: "poly3" | "poly5" | "poly7", { ts, p0, p1, v0, v1, a0, a1, j0, j1 }: Values): Outcome {
    const place = c.plan_at(0);
    const borders = [p0, p1, v0, v1, ...(family === "poly3" ? [] : [a0, a1]), ...(family === "poly7" ? [j0, j1] : [])];
    c[`a_traj${family}_gen`](place, ts, ...borders);
    const motion = new Motion("atraj", [{ start: 0, plan: new Plan(family, place, ts) }], []);
    if (!(ts > 0) || !Number.isFinite(motion.state(ts / 2)[0])) {
        return { motions: [], remarks: [{ kind: "bad", text: "There is no such polynomial: the duration is not above 0." }] };
    }
    return { motions: [motion], remarks: [{ kind: "note", text: "A polynomial keeps its duration, and no limits." }] };
}

/** The limits of a plan, which leave the reserve to hold and override. */
function planned({ reserve }: Values, limits: number[]): number[] {
    return limits.map((limit) => (reserve ? Number((limit * (1 - reserve / 100)).toPrecision(12)) : limit));
}

/** The limits of the axis: highest and lowest velocity, acceleration, jerk. */
function moveLimits({ jm, am, vm, backward, jn, an, vn }: Values): number[] {
    return backward ? [vm, -vn, am, -an, jm, -jn] : [vm, -vm, am, -am, jm, -jm];
}

/** The limits that `atraj_move` is planned with. */
export const plannedLimits = (values: Values) => planned(values, moveLimits(values));

function planMove(values: Values, commands: Command[]): Outcome {
    const [limits, from, to] = [c.limits_at(0), c.from_at(0), c.to_at(0)];
    const [vmax, vmin, amax, amin, jmax, jmin] = moveLimits(values);
    c.set_limits(limits, ...plannedLimits(values));
    c.set_state(from, values.p0, values.v0, values.a0);
    c.set_state(to, values.p1, values.v1, values.a1);
    const lines: Quantities<Range | undefined> = [undefined, [vmin, vmax], [amin, amax], [jmin, jmax]];
    let refused: number | undefined;
    let code = c.atraj_move_plan(c.move_at(0), limits, from, to);
    if (code < 0) {
        return { motions: [], remarks: findings("atraj", code, "") };
    }
    const remarks: Remark[] = [];
    const motion = new Motion("atraj", [{ start: 0, plan: move(c.move_at(0)) }], lines);
    for (const [i, { time, kind, target }] of commands.entries()) {
        const [p, v, a] = motion.state(time);
        const place = c.move_at(i + 1);
        c.set_state(from, p, v, a);
        c.set_state(to, target, 0, 0);
        const next =
            kind === "to" ? c.atraj_move_plan(place, limits, from, to)
            : kind === "jog" ? c.atraj_move_reach(place, limits, from, target, 0)
            : c.atraj_move_stop(place, limits, from);
        if (next < 0) {
            refused = i;
            remarks.push({ kind: "bad", text: `atraj refuses the plan at ${time} s: ${message(next)}. The plan before it goes on.` });
            break;
        }
        code = next | (code & STARTS_OUTSIDE);
        motion.pieces.push({ start: time, plan: move(place) });
    }
    return { motions: [motion], remarks: [...findings("atraj", code, "keeps every limit"), ...remarks], refused };
}

/** The field of one axis. */
export function axisKey(axis: number, key: string): string {
    return `${AXIS_NAMES[axis].toLowerCase()}.${key}`;
}

/** The limits of one axis: jerk, acceleration, velocity. */
function axisLimits(values: Values, axis: number): number[] {
    return ["jm", "am", "vm"].map((key) => values[axisKey(axis, key)]);
}

/** The limits that one of several axes is planned with. */
export const plannedAxisLimits = (values: Values, axis: number) => planned(values, axisLimits(values, axis));

function planAxes(values: Values, plan: "sync" | "line"): Outcome {
    AXIS_NAMES.forEach((_, axis) => {
        const value = (key: string) => values[axisKey(axis, key)];
        c.atraj_limits_init(c.limits_at(axis), ...plannedAxisLimits(values, axis));
        c.set_state(c.from_at(axis), value("p0"), value("v0"), 0);
        c.set_state(c.to_at(axis), value("p1"), 0, 0);
    });
    const code = c[`atraj_moves_${plan}`](
        c.move_at(0), c.limits_at(0), c.from_at(0), c.to_at(0), AXES, values.least, values.cycle,
    );
    if (code < 0) {
        return { motions: [], remarks: findings("atraj", code, "") };
    }
    const motions = AXIS_NAMES.map((name, axis) => {
        const limits = symmetric(...axisLimits(values, axis).reverse());
        return new Motion(name, [{ start: 0, plan: move(c.move_at(axis)) }], limits);
    });
    return { motions, remarks: findings("atraj", code, "keeps every limit of every axis") };
}

/** How a group starts what is planned. A least duration and another clock are those of moves, which it follows as a path. */
export function startOf(profile: string, { least, cycle }: Values): Start {
    const isPlain = (profile === "sync" || profile === "line") && least === 0 && cycle === PERIOD;
    return profile === "move" ? "go" : isPlain ? profile : "path";
}

/** The axes of a path. */
const PLANE = AXIS_NAMES.slice(0, 2);

function planPath(values: Values, points: Point[]): Outcome {
    PLANE.forEach((_, axis) => c.atraj_limits_init(c.limits_at(axis), ...plannedAxisLimits(values, axis)));
    points.forEach((point, k) => point.forEach((position, axis) => c.set_state(c.state_at(k, axis), position, 0, 0)));
    const sections = points.length - 1;
    const [into, after] = [[c.state_at(0, 0), c.durations_at(), c.limits_at(0)], [PLANE.length, sections, 0, c.work_at()]];
    const near = values.zone !== 0;
    const code = near ? c.atraj_path_plan_near(...into, c.zones_at(values.zone), ...after) : c.atraj_path_plan(...into, ...after);
    if (code < 0) {
        return { motions: [], remarks: findings("atraj", code, "") };
    }
    const motions = PLANE.map((name, axis) => new Motion(name, [], symmetric(...axisLimits(values, axis).reverse())));
    for (let [section, start] = [0, 0]; section < sections; section += 1) {
        const place = (axis: number) => c.move_at(PLANE.length * section + axis);
        c.atraj_moves_sync(place(0), c.limits_at(0), c.state_at(section, 0), c.state_at(section + 1, 0), PLANE.length, c.duration_of(section), 0);
        motions.forEach(({ pieces }, axis) => pieces.push({ start, plan: move(place(axis)) }));
        start += c.move_duration(place(0));
    }
    return { motions, remarks: findings("atraj", code, `passes every ${near ? "zone" : "point"} and keeps every limit`) };
}

const bellGroups = [{ title: "Limits", fields: [VELOCITY, ACCELERATION, JERK] }, ...ends(V)];
const trapGroups = [
    {
        title: "Limits",
        fields: [
            VELOCITY,
            field("ac", "Acceleration", "m/s²", 0, 30, 10),
            field("de", "Deceleration", "m/s²", 0, 30, 10),
        ],
    },
    ...ends(V),
];
const RESERVE: Group = { title: "Reserve for hold and override", fields: [field("reserve", "Of each limit", "%", 0, 75, 0)] };
const moveGroups: Group[] = [
    {
        title: "Limits",
        fields: [VELOCITY, ACCELERATION, JERK, field("backward", "Other limits backward", "", 0, 1, 0)],
    },
    {
        title: "Limits backward",
        when: "backward",
        fields: [
            { ...VELOCITY, key: "vn", initial: 2 },
            { ...ACCELERATION, key: "an", initial: 6 },
            { ...JERK, key: "jn", initial: 20 },
        ],
    },
    ...ends(V, A),
    RESERVE,
];
const own = (axis: number, shared: Field, initial: number): Field => ({ ...shared, key: axisKey(axis, shared.key), initial });
const limitGroups = AXIS_NAMES.map((name, axis): Group => {
    const [v, a, j] = [[5, 10, 30], [3, 8, 40], [4, 12, 60]][axis];
    return { title: `Limits of ${name}`, axis, fields: [own(axis, VELOCITY, v), own(axis, ACCELERATION, a), own(axis, JERK, j)] };
});
const axisGroups: Group[] = [
    ...AXIS_NAMES.flatMap((name, axis): Group[] => [
        limitGroups[axis],
        {
            title: `Way of ${name}`,
            axis,
            fields: [
                own(axis, { ...START, label: "Start" }, 0),
                own(axis, { ...END, label: "End" }, [10, 6, -3][axis]),
                own(axis, field("v0", "Initial velocity", "m/s", -10, 10, 0), 0),
            ],
        },
    ]),
    {
        title: "All axes",
        fields: [field("least", "Least duration", "s", 0, 10, 0), field("cycle", "Clock", "s", 0, 0.1, 0.001)],
    },
    RESERVE,
];

export const PROFILES: Profile[] = [
    {
        id: "move",
        name: "Move from any state to any state",
        note: "The fastest move within all limits, planned also in motion.",
        groups: moveGroups,
        live: true,
        runs: true,
        marks: "new plan",
        plan: ({ values, commands }) => planMove(values, commands),
    },
    {
        id: "bell",
        name: "Double-S that never fails",
        note: "The fastest plan there is, in liba’s struct: atraj_bell_gen.",
        groups: bellGroups,
        rival: "liba",
        plan: ({ values, compare }) => planBell(values, "atraj", compare),
    },
    {
        id: "liba-bell",
        name: "Double-S of liba",
        note: "a_trajbell_gen, with liba’s bits.",
        groups: bellGroups,
        rival: "atraj",
        plan: ({ values, compare }) => planBell(values, "liba", compare),
    },
    {
        id: "trap",
        name: "Trapezoid that never fails",
        note: "The fastest plan there is, in liba’s struct: atraj_trap_gen.",
        groups: trapGroups,
        rival: "liba",
        plan: ({ values, compare }) => planTrap(values, "atraj", compare),
    },
    {
        id: "liba-trap",
        name: "Trapezoid of liba",
        note: "a_trajtrap_gen, with liba’s bits.",
        groups: trapGroups,
        rival: "atraj",
        plan: ({ values, compare }) => planTrap(values, "liba", compare),
    },
    {
        id: "poly3",
        name: "Cubic polynomial",
        note: "Position and velocity are given at both ends.",
        groups: [DURATION, ...ends(V)],
        plan: ({ values }) => planPoly("poly3", values),
    },
    {
        id: "poly5",
        name: "Quintic polynomial",
        note: "Position, velocity and acceleration are given at both ends.",
        groups: [DURATION, ...ends(V, A)],
        plan: ({ values }) => planPoly("poly5", values),
    },
    {
        id: "poly7",
        name: "Septic polynomial",
        note: "Position, velocity, acceleration and jerk are given at both ends.",
        groups: [DURATION, ...ends(V, A, J)],
        plan: ({ values }) => planPoly("poly7", values),
    },
    {
        id: "sync",
        name: "Axes in step",
        note: "Each axis keeps its own profile, and all arrive together.",
        groups: axisGroups,
        axes: AXIS_NAMES,
        runs: true,
        plan: ({ values }) => planAxes(values, "sync"),
    },
    {
        id: "line",
        name: "Axes on a straight line",
        note: "The fastest motion on the line that keeps the limits of every axis.",
        groups: axisGroups,
        axes: AXIS_NAMES,
        runs: true,
        plan: ({ values }) => planAxes(values, "line"),
    },
    {
        id: "path",
        name: "Waypoints without stops",
        note: "Two axes pass every point, as fast as the limits of both allow. Drag a point or its zone, or move it by the arrow keys.",
        groups: [...limitGroups.slice(0, PLANE.length), { title: "Zones to fly by", fields: [ZONE] }, RESERVE],
        axes: PLANE,
        points: true,
        runs: true,
        marks: "waypoint",
        plan: ({ values, points }) => planPath(values, points),
    },
];

/** How many plans may follow the first. */
export const COMMANDS = MOVES - 1;

/** The fields of a profile that are in use. */
export function fields(profile: Profile, values: Values): Field[] {
    return profile.groups.filter(({ when }) => !when || values[when]).flatMap((group) => group.fields);
}

/** The initial value of every field. */
export function initial(): Values {
    const all = PROFILES.flatMap((profile) => profile.groups).flatMap((group) => group.fields);
    return Object.fromEntries(all.map((field) => [field.key, field.initial]));
}
