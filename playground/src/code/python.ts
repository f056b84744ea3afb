// The programs in Python.
import { plannedAxisLimits, plannedLimits } from "../profiles";
import {
    BELL_ORDER, bellArguments, eachAxis, hasZones, MOVE_ORDER, ofAxis, POLY_ORDER, polyArguments, STATE_ORDER, TRAP_ORDER, trapArguments, wrapped, type Writer,
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

    return {
        bell: (fastest, values) => planned(BELL_ORDER, `Bell${fastest ? ".fastest" : ""}(${bellArguments(values).join(", ")})`),
        trap: (fastest, values) => planned(TRAP_ORDER, `Trap${fastest ? ".fastest" : ""}(${trapArguments(values).join(", ")})`),
        poly: (degree, values) => planned(POLY_ORDER, `Poly${degree}(${polyArguments(degree, values).join(", ")})`),
        move(values, commands) {
            const { p0, v0, a0, p1, v1, a1 } = values;
            const last = commands.at(-1);
            return script(
                `# ${MOVE_ORDER}`,
                `limits = atraj.Limits(${plannedLimits(values).map((limit, i) => `${LIMITS[i]}=${limit}`).join(", ")})`,
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
        axes(plan, values) {
            const least = `duration=${values.least}, cycle=${values.cycle}`;
            return script(
                "# jerk, acceleration, velocity",
                ofAxes("limits", eachAxis((axis) => symmetric(plannedAxisLimits(values, axis)))),
                `# ${STATE_ORDER}`,
                ofAxes("start", eachAxis((axis) => state(...ofAxis(values, axis, "p0", "v0")))),
                ofAxes("end", eachAxis((axis) => state(...ofAxis(values, axis, "p1")))),
                `moves = atraj.${plan === "sync" ? "synchronise" : "line"}(limits, start, end, ${least})`,
                setpoints("moves[0].t", "", ...eachAxis((axis) => `moves[${axis}].position(t)`)),
            );
        },
        path: (values, points) =>
            script(
                "# jerk, acceleration, velocity",
                ofAxes("limits", [0, 1].map((axis) => symmetric(plannedAxisLimits(values, axis)))),
                ofAxes("points", points.map(([x, y]) => `[${x}, ${y}]`)),
                `path = atraj.path(points=points, limits=limits${hasZones(values, points) ? `, tolerances=[${values.zone}, ${values.zone}]` : ""})`,
                "for k in range(11):",
                "    t = path.t * k / 10",
                "    x, y = path.position(t)",
                `    print(f"{t:.4f} s: {x:.4f} {y:.4f} ${unit}")`,
            ),
    };
}
