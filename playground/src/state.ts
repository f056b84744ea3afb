// What the page shows, and how its address says so.

export type Values = Record<string, number>;

/** A plan in motion: at `time` the axis goes to the position or the velocity `target`, or it stops. */
export interface Command {
    time: number;
    kind: "to" | "jog" | "stop";
    target: number;
}

/** A waypoint in the plane of two axes. */
export type Point = [x: number, y: number];

export interface State {
    profile: string;
    /** Of position. */
    unit: string;
    values: Values;
    /** In the order of time. */
    commands: Command[];
    /** At least two. */
    points: Point[];
    /** Whether the other planner is shown too. */
    compare: boolean;
    /** The axis that leads, counted from 0. */
    axis: number;
    language: string;
    /** The time whose values are shown, s. */
    moment: number;
}

/** What an address may say. */
export interface Known {
    profiles: string[];
    units: string[];
    languages: string[];
    axes: number;
    commands: number;
    points: number;
}

/** The address of a state. Only the fields named in `keys` belong to it. */
export function write(state: State, keys: string[]): string {
    const hash = new URLSearchParams({ profile: state.profile, unit: state.unit });
    for (const key of keys) {
        hash.set(key, String(state.values[key]));
    }
    if (state.commands.length > 0) {
        hash.set("then", state.commands.map(({ time, kind, target }) => [time, kind, target].join("~")).join("_"));
    }
    if (state.profile === "path") {
        hash.set("points", state.points.map((point) => point.join("~")).join("_"));
    }
    if (!state.compare) {
        hash.set("compare", "no");
    }
    hash.set("axis", String(state.axis));
    hash.set("language", state.language);
    hash.set("moment", String(state.moment));
    return `#${hash}`;
}

/** The state of an address. Whatever the address leaves out, or says wrongly, is as in `initial`. */
export function read(address: string, initial: State, known: Known): State {
    const hash = new URLSearchParams(address.replace(/^#/, ""));
    const choice = (key: string, choices: string[], otherwise: string) =>
        choices.find((name) => name === hash.get(key)) ?? otherwise;
    const axes = Array.from({ length: known.axes }, (_, axis) => String(axis));
    const values = Object.entries(initial.values).map(([key, value]) => [key, number(hash.get(key)) ?? value]);
    return {
        profile: choice("profile", known.profiles, initial.profile),
        unit: choice("unit", known.units, initial.unit),
        values: Object.fromEntries(values),
        commands: commands(hash.get("then") ?? "").slice(0, known.commands),
        points: points(hash.get("points") ?? "", known.points) ?? initial.points,
        compare: hash.get("compare") !== "no",
        axis: Number(choice("axis", axes, String(initial.axis))),
        language: choice("language", known.languages, initial.language),
        moment: number(hash.get("moment")) ?? initial.moment,
    };
}

/** The commands up to the first that is none, or is before another. */
function commands(text: string): Command[] {
    const read: Command[] = [];
    for (const entry of text.split("_")) {
        const [time, kind, target] = entry.split("~");
        const [at, to] = [number(time), number(target)];
        const known = kind === "to" || kind === "jog" || kind === "stop";
        if (!known || at === undefined || to === undefined || at < (read.at(-1)?.time ?? 0)) {
            break;
        }
        read.push({ time: at, kind, target: to });
    }
    return read;
}

/** All points of a text, unless one of them is none, or they are too few or too many. */
function points(text: string, most: number): Point[] | undefined {
    const all = text.split("_").map((entry) => entry.split("~").map(number));
    const isRead = all.every(([x, y, more]) => x !== undefined && y !== undefined && more === undefined);
    return isRead && all.length >= 2 && all.length <= most ? (all as Point[]) : undefined;
}

function number(text: string | null | undefined): number | undefined {
    return text && Number.isFinite(Number(text)) ? Number(text) : undefined;
}
