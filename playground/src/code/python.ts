// The programs in Python.
import { AXIS_NAMES, plannedAxisLimits, plannedLimits, startOf } from "../profiles";
import { type Change, PERIOD } from "../run";
import type { Values } from "../state";
import {
    BELL_ORDER, bellArguments, changeName, eachAxis, hasZones, lastChange, MACHINE, MOVE_ORDER, ofAxis, ofMachine, POLY_ORDER, polyArguments, STATE_ORDER, TRAP_ORDER, trapArguments, wrapped, type Writer,
} from "./writer";

const script = (...lines: (string | string[])[]) => `import atraj\n\n${lines.flat().join("\n")}\n`;
const LIMITS = ["vmax", "vmin", "amax", "amin", "jmax", "jmin"];
const state = (...numbers: number[]) => `atraj.State(${numbers.join(", ")})`;
const symmetric = (limits: number[]) => `atraj.Limits.symmetric(${limits.join(", ")})`;

export function pythonWriter(unit: string): Writer {
    const setpoints = (duration: string, since: string, ...positions: string[]) => [
        "for k in range(11):",
        `    t = ${duration} * k / 10`,
        `    print(f"{${since}t:.4f} s:${positions.map((position) => ` {${position}:.4f}`).join("")} ${unit}")`,
    ];
    const planned = (order: string, plan: string) =>
        script(`# ${order}`, `axis = atraj.${plan}`, setpoints("axis.t", "", "axis.position(t)"));
    const ofAxes = (name: string, entries: string[]) => wrapped(`${name} = [`, entries, "]", ",");

    const moveLimits = (values: Values) => `atraj.Limits(${plannedLimits(values).map((limit, i) => `${LIMITS[i]}=${limit}`).join(", ")})`;
    const axisLimits = (n: number, name: string, values: Values) =>
        ofAxes(name, eachAxis((axis) => symmetric(plannedAxisLimits(values, axis))).slice(0, n));
    const machine = (n: number, values: Values) => axisLimits(n, "machine", { ...values, reserve: 0 });

    /** Runs in a group what `start` starts, with the changes, until it is at its end. `machine` has the limits without the reserve. */
    const runs = (n: number, states: string, start: string, machine: string[], values: Values, changes: Change[]) => {
        const told = `print(f"{tick * ${PERIOD}:.4f} s:${Array.from({ length: n }, (_, axis) => ` {now[${axis}].position:.4f}`).join("")} ${unit}")`;
        return [
            ...(values.reserve ? [`# ${MACHINE}`, ...machine] : []),
            `group = atraj.Group(${PERIOD}, ${states})`,
            `group.${start}`,
            "tick = -1",
            `while tick < ${lastChange(changes)} or not group.done:`,
            "    tick += 1",
            ...changes.flatMap((change) => [
                `    if tick == ${change.tick}:`,
                `        group.${change.rate === undefined ? `stop(${ofMachine(values)})` : `rate(${ofMachine(values)}, ${change.rate})`}  # ${changeName(change)}`,
            ]),
            "    now = group.tick()",
            "    if tick % 100 == 0:",
            `        ${told}`,
            told,
        ];
    };

    return {
        bell: (fastest, values) => planned(BELL_ORDER, `Bell${fastest ? ".fastest" : ""}(${bellArguments(values).join(", ")})`),
        trap: (fastest, values) => planned(TRAP_ORDER, `Trap${fastest ? ".fastest" : ""}(${trapArguments(values).join(", ")})`),
        poly: (degree, values) => planned(POLY_ORDER, `Poly${degree}(${polyArguments(degree, values).join(", ")})`),
        move(values, commands, changes) {
            const { p0, v0, a0, p1, v1, a1 } = values;
            if (changes) {
                const start = `go(limits, [${state(p1, v1, a1)}])`;
                return script(
                    `# ${MOVE_ORDER}`,
                    `limits = [${moveLimits(values)}]`,
                    `# ${STATE_ORDER}`,
                    runs(1, `[${state(p0, v0, a0)}]`, start, [`machine = [${moveLimits({ ...values, reserve: 0 })}]`], values, changes),
                );
            }
            const last = commands.at(-1);
            return script(
                `# ${MOVE_ORDER}`,
                `limits = ${moveLimits(values)}`,
                `# ${STATE_ORDER}`,
                `axis = atraj.Move.plan(limits, ${state(p0, v0, a0)}, ${state(p1, v1, a1)})`,
                commands.flatMap(({ time, kind, target }, i) => {
                    const now = `axis.state_at(${i > 0 ? `${time} - ${commands[i - 1].time}` : time})`;
                    const plan = {
                        to: `plan(limits, ${now}, ${state(target)})`,
                        jog: `reach(limits, ${now}, ${target})`,
                        stop: `stop(limits, ${now})`,
                    }[kind];
                    return [`axis = atraj.Move.${plan}  # at ${time} s`];
                }),
                setpoints("axis.t", last ? `${last.time} + ` : "", "axis.position(t)"),
            );
        },
        axes(plan, values, changes) {
            const least = `duration=${values.least}, cycle=${values.cycle}`;
            const call = plan === "sync" ? "synchronise" : "line";
            const isPlain = startOf(plan, values) === plan;
            const start = isPlain ? `${call}(limits, end)` : "path(limits, moves)";
            return script(
                "# jerk, acceleration, velocity",
                axisLimits(AXIS_NAMES.length, "limits", values),
                `# ${STATE_ORDER}`,
                ofAxes("start", eachAxis((axis) => state(...ofAxis(values, axis, "p0", "v0")))),
                ofAxes("end", eachAxis((axis) => state(...ofAxis(values, axis, "p1")))),
                changes && isPlain ? [] : `moves = atraj.${call}(limits, start, end, ${least})`,
                changes
                    ? runs(AXIS_NAMES.length, "start", start, machine(AXIS_NAMES.length, values), values, changes)
                    : setpoints("moves[0].t", "", ...eachAxis((axis) => `moves[${axis}].position(t)`)),
            );
        },
        path: (values, points, changes) =>
            script(
                "# jerk, acceleration, velocity",
                axisLimits(2, "limits", values),
                ofAxes("points", points.map(([x, y]) => `[${x}, ${y}]`)),
                `path = atraj.path(points=points, limits=limits${hasZones(values, points) ? `, tolerances=[${values.zone}, ${values.zone}]` : ""})`,
                changes
                    ? runs(2, "points[0]", "path(limits, path)", machine(2, values), values, changes)
                    : [
                        "for k in range(11):",
                        "    t = path.t * k / 10",
                        "    x, y = path.position(t)",
                        `    print(f"{t:.4f} s: {x:.4f} {y:.4f} ${unit}")`,
                    ],
            ),
    };
}
