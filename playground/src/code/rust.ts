// The programs in Rust.
import { AXIS_NAMES, axisKey, plannedAxisLimits, plannedLimits, slopes, startOf } from "../profiles";
import { type Change, PERIOD } from "../run";
import type { Values } from "../state";
import { body, changeName, eachAxis, hasZones, lastChange, MACHINE, ofAxis, ofMachine, PATH_ORDER, STATE_ORDER, wrapped, type Writer } from "./writer";

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

export function rustWriter(unit: string): Writer {
    function rustSetpoints(duration: string, since: string, ...positions: string[]): string[] {
        const format = `"{:.4} s:${" {:.4}".repeat(positions.length)} ${unit}"`;
        return [
            "for k in 0..=10 {",
            `    let t = ${duration} * f64::from(k) / 10.0;`,
            ...wrapped("    println!(", [format, `${since}t`, ...positions], ");"),
            "}",
        ];
    }

    const rustPosition = (duration: string, since = "") => rustSetpoints(duration, since, "axis.position(t)");

    /** Runs in a group what `start` starts, with the changes, until it is at its end. `machine` has the limits without the reserve. */
    const runs = (n: number, states: string[], start: string, machine: string[], values: Values, changes: Change[]) => [
        ...wrapped("let mut states = [", states, "];", ","),
        `let (mut room, mut now) = ([Move::default(); ${3 * n}], states);`,
        ...(values.reserve ? [`// ${MACHINE}`, ...machine] : []),
        `let mut group = Group::new(${PERIOD}, &mut states, &mut room).expect("a group");`,
        "let (mut planner, mut ticker) = group.split();",
        `planner.${start}.expect("a motion");`,
        "let (mut tick, mut ends) = (0, false);",
        `while tick <= ${lastChange(changes)} || !ends {`,
        ...changes.flatMap((change) => [
            `    if tick == ${change.tick} {`,
            `        planner.${change.rate === undefined ? `stop(&${ofMachine(values)}, 1)` : `rate(&${ofMachine(values)}, ${real(change.rate)}, 1)`}.expect("${changeName(change)}");`,
            "    }",
        ]),
        "    ends = ticker.tick(&mut now).ends;",
        "    if tick % 100 == 0 || ends {",
        ...wrapped("        println!(", [
            `"{:.4} s:${" {:.4}".repeat(n)} ${unit}"`, `f64::from(tick) * ${PERIOD}`, ...Array.from({ length: n }, (_, axis) => `now[${axis}].position`),
        ], ");"),
        "    }",
        "    tick += 1;",
        "}",
    ];
    const moveLimits = (values: Values) => {
        const [vmax, vmin, amax, amin, jmax, jmin] = plannedLimits(values).map(real);
        return `Limits { vmax: ${vmax}, vmin: ${vmin}, amax: ${amax}, amin: ${amin}, jmax: ${jmax}, jmin: ${jmin} }`;
    };
    const axisLimits = (n: number, name: string, values: Values) =>
        wrapped(`let ${name} = [`, eachAxis((axis) => `Limits::symmetric(${reals(...plannedAxisLimits(values, axis))})`).slice(0, n), "];", ",");
    const machine = (n: number, values: Values) => axisLimits(n, "machine", { ...values, reserve: 0 });

    return {
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
        move: (values, commands, changes) => {
            const { p0, v0, a0, p1, v1, a1 } = values;
            if (changes) {
                return rustMain(
                    ["machine::Group", "State", "online::{Limits, Move}"],
                    `let limits = [${moveLimits(values)}];`,
                    `let target = [${rustState(p1, v1, a1)}];`,
                    runs(1, [rustState(p0, v0, a0)], "go(&limits, &target, 1)", [`let machine = [${moveLimits({ ...values, reserve: 0 })}];`], values, changes),
                );
            }
            return rustMain(
                ["State", "online::{Limits, Move}"],
                `let limits = ${moveLimits(values)};`,
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
        axes: (plan, values, changes) => {
            const n = AXIS_NAMES.length;
            const from = eachAxis((axis) => {
                const [p0, v0] = ofAxis(values, axis, "p0", "v0");
                return rustState(p0, v0, 0);
            });
            const to = eachAxis((axis) => rustState(values[axisKey(axis, "p1")], 0, 0));
            const isPlain = startOf(plan, values) === plan;
            const start = isPlain ? `${plan}(&limits, &to, 1)` : "path(&limits, &moves, 0.0, 1)";
            const moves = [
                ...wrapped("let from = [", from, "];"),
                `let mut moves = [Move::default(); ${n}];`,
                "// the least duration, and the clock",
                `axes::${plan === "sync" ? "synchronise" : "line"}(&mut moves, &limits, &from, &to, ${reals(values.least, values.cycle)})`,
                '    .expect("moves");',
            ];
            return rustMain(
                [...(changes ? ["machine::Group"] : []), ...(changes && isPlain ? [] : ["axes"]), "State", "online::{Limits, Move}"],
                "// jerk, acceleration, velocity",
                axisLimits(n, "limits", values),
                wrapped("let to = [", to, "];"),
                changes && isPlain ? [] : moves,
                changes
                    ? runs(n, from, start, machine(n, values), values, changes)
                    : rustSetpoints("moves[0].t", "", ...eachAxis((axis) => `moves[${axis}].position(t)`)),
            );
        },
        path: (values, points, changes) => {
            const n = points.length - 1;
            const [near, tolerances] = hasZones(values, points) ? ["_near", " &tolerances,"] : ["", ""];
            const states = points.map(([x, y]) => `${rustState(x, 0, 0)}, ${rustState(y, 0, 0)}`);
            const each = [
                "let mut start = 0.0;",
                "for (k, duration) in durations.into_iter().enumerate() {",
                "    let mut axes = [Move::default(); 2];",
                "    let (from, to) = (&states[2 * k..2 * k + 2], &states[2 * k + 2..2 * k + 4]);",
                '    synchronise(&mut axes, &limits, from, to, duration, 0.0).expect("moves");',
                "    for i in i32::from(k > 0)..=5 {",
                "        let t = axes[0].t * f64::from(i) / 5.0;",
                "        let [x, y] = axes.map(|axis| axis.position(t));",
                `        println!("{:.4} s: {x:.4} {y:.4} ${unit}", start + t);`,
                "    }",
                "    start += axes[0].t;",
                "}",
            ];
            return rustMain(
                [
                    `axes::{${changes ? "path_moves, " : ""}path_size${near}, plan_path${near}${changes ? "" : ", synchronise"}}`,
                    ...(changes ? ["machine::Group"] : []), "State", "online::{Limits, Move}",
                ],
                "// jerk, acceleration, velocity",
                axisLimits(2, "limits", values),
                `// ${STATE_ORDER} ${PATH_ORDER}`,
                wrapped(`let mut ${changes ? "points" : "states"} = [`, states, "];", ","),
                `let mut durations = [0.0; ${n}];`,
                near ? [`let tolerances = [${real(values.zone)}; ${2 * n - 2}];`] : [],
                `let mut work = vec![0.0; path_size${near}(2, ${n}).expect("a short path")];`,
                `plan_path${near}(&mut ${changes ? "points" : "states"}, &mut durations, &limits,${tolerances} 2, 0, &mut work).expect("a path");`,
                changes
                    ? [
                        `let mut moves = [Move::default(); ${2 * n}];`,
                        'path_moves(&mut moves, &limits, &points, &durations, 2).expect("moves");',
                        ...runs(2, ["points[0]", "points[1]"], "path(&limits, &moves, 0.0, 1)", machine(2, values), values, changes),
                    ]
                    : each,
            );
        },
    };
}
