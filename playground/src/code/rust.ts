// The programs in Rust.
import { AXIS_NAMES, axisKey, plannedAxisLimits, plannedLimits, slopes } from "../profiles";
import type { Values } from "../state";
import { body, eachAxis, hasZones, ofAxis, PATH_ORDER, STATE_ORDER, wrapped, type Writer } from "./writer";

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
        path: (values, points) => {
            const n = points.length - 1;
            const [near, tolerances] = hasZones(values, points) ? ["_near", " &tolerances,"] : ["", ""];
            const limits = [0, 1].map((axis) => `Limits::symmetric(${reals(...plannedAxisLimits(values, axis))})`);
            const states = points.map(([x, y]) => `${rustState(x, 0, 0)}, ${rustState(y, 0, 0)}`);
            return rustMain(
                [`axes::{path_size${near}, plan_path${near}, synchronise}`, "State", "online::{Limits, Move}"],
                "// jerk, acceleration, velocity",
                wrapped("let limits = [", limits, "];", ","),
                `// ${STATE_ORDER} ${PATH_ORDER}`,
                wrapped("let mut states = [", states, "];", ","),
                `let mut durations = [0.0; ${n}];`,
                near ? [`let tolerances = [${real(values.zone)}; ${2 * n - 2}];`] : [],
                `let mut work = vec![0.0; path_size${near}(2, ${n}).expect("a short path")];`,
                `plan_path${near}(&mut states, &mut durations, &limits,${tolerances} 2, 0, &mut work).expect("a path");`,
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
            );
        },
    };
}
