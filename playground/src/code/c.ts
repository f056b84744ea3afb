// The programs in C and C++.
import { AXIS_NAMES, plannedAxisLimits, plannedLimits, startOf } from "../profiles";
import { type Change, PERIOD } from "../run";
import type { Command, Values } from "../state";
import {
    bellArguments, body, changeName, eachAxis, hasZones, lastChange, MACHINE, MOVE_ORDER, BELL_ORDER, ofAxis, ofMachine, PATH_ORDER, POLY_ORDER, polyArguments, STATE_ORDER, TRAP_ORDER, trapArguments,
    workSize, wrapped, type Writer,
} from "./writer";

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
    /** A call of a group's function. */
    ask(name: string, ...operands: (string | number)[]): string;
}

/** A number is passed as it is, a struct by its address. */
const byAddress = (operand: string) => (/^-?[\d.]/.test(operand) ? operand : `&${operand}`);

export const C: Dialect = {
    head: '#include "atraj.h"\n#include <stdio.h>\n\nint main(void)',
    print: "printf",
    types: "atraj_",
    type: (struct) => `a_${struct}`,
    generate: (struct, operands) => `a_${struct}_gen(&axis, ${operands})`,
    position: (struct) => (struct === "move" ? "atraj_move_pos(&axis, t)" : `a_${struct}_pos(&axis, t)`),
    call: (name, operands) => `atraj_move_${name}(&axis, ${operands.map(byAddress).join(", ")})`,
    state: (time) => `atraj_move_state(&axis, ${time}, &now.p, &now.v, &now.a, NULL);`,
    ask: (name, ...operands) => `atraj_group_${name}(${["&group", ...operands].join(", ")})`,
};

export const CPP: Dialect = {
    head: '#include "atraj.h"\n#include <cstdio>\n\nint main()',
    print: "std::printf",
    types: "atraj::",
    type: (struct) => `a::${struct}`,
    generate: (_, operands) => `axis.gen(${operands})`,
    position: () => "axis.pos(t)",
    call: (name, operands) => `axis.${name}(${operands.join(", ")})`,
    state: (time) => `now = axis.state(${time});`,
    ask: (name, ...operands) => `group.${name}(${operands.join(", ")})`,
};

const cReal = (value: number) => (Number.isInteger(value) && !String(value).includes("e") ? `${value}.0` : String(value));
const braces = (...numbers: number[]) => `{${numbers.join(", ")}}`;

export function cWriter({ head, print, types, type, generate, position, call, state, ask }: Dialect, unit: string): Writer {
    const main = (...lines: string[]) => `${head}\n{\n${body(...lines, "return 0;")}\n}\n`;
    const unless = (planned: string) => `if (${planned} < 0) { return 1; }`;

    /** Prints eleven setpoints: the time `t` is from 0 to `duration`, `since` is the start of the plan. */
    const setpoints = (duration: string, since: string, ...positions: string[]) => {
        const format = `"%.4f s:${" %.4f".repeat(positions.length)} ${unit}\\n"`;
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

    const axisLimits = (n: number, name: string, values: Values) => [
        "/* jerk, acceleration, velocity */",
        ...eachAxis((axis) => `atraj_limits_init(&${name}[${axis}], ${plannedAxisLimits(values, axis).join(", ")});`).slice(0, n),
    ];

    /** Runs in a group what `start` starts, with the changes, until it is at its end. `machine` has the limits without the reserve. */
    const runs = (n: number, states: string, start: string, machine: string[], values: Values, changes: Change[]) => [
        `${types}state now[${n}];`,
        `${types}move room[${3 * n}];`,
        `${types}group group;`,
        ...(values.reserve ? [`/* ${MACHINE} */`, ...machine] : []),
        unless(ask("init", PERIOD, states, "room", n)),
        unless(start),
        `for (int tick = 0, event = 0; tick <= ${lastChange(changes)} || !(event & ATRAJ_TICK_ENDS); ++tick) {`,
        ...changes.map((change) => {
            const limits = ofMachine(values);
            const asked = change.rate === undefined ? ask("stop", limits, 1) : ask("rate", limits, change.rate, 1);
            return `    if (tick == ${change.tick} && ${asked} < 0) { return 1; } /* ${changeName(change)} */`;
        }),
        `    event = ${ask("tick", "now")};`,
        "    if (tick % 100 == 0 || (event & ATRAJ_TICK_ENDS)) {",
        `        ${print}("%.4f s:${" %.4f".repeat(n)} ${unit}\\n", tick * ${PERIOD}, ${Array.from({ length: n }, (_, axis) => `now[${axis}].p`).join(", ")});`,
        "    }",
        "}",
    ];

    /** The move of one axis, in a group. */
    const moveInGroup = (values: Values, changes: Change[]) => {
        const { p0, v0, a0, p1, v1, a1 } = values;
        const limits = (name: string, given: Values) => `${types}limits const ${name}[1] = {${braces(...plannedLimits(given))}};`;
        return main(
            `/* ${MOVE_ORDER} */`,
            limits("limits", values),
            `/* ${STATE_ORDER} */`,
            `${types}state states[1] = {${braces(p0, v0, a0)}};`,
            `${types}state const target[1] = {${braces(p1, v1, a1)}};`,
            ...runs(1, "states", ask("go", "limits", "target", 1), [limits("machine", { ...values, reserve: 0 })], values, changes),
        );
    };

    const machine = (n: number, values: Values) => [`${types}limits machine[${n}];`, ...axisLimits(n, "machine", { ...values, reserve: 0 })];

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
                ...setpoints(cReal(values.ts), "", position(struct)),
            );
        },
        move(values, commands, changes) {
            if (changes) {
                return moveInGroup(values, changes);
            }
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
        axes(plan, values, changes) {
            const n = AXIS_NAMES.length;
            const from = eachAxis((axis) => braces(...ofAxis(values, axis, "p0", "v0"), 0));
            const to = eachAxis((axis) => braces(...ofAxis(values, axis, "p1"), 0, 0));
            const isPlain = startOf(plan, values) === plan;
            const moves = [
                `${types}move axes[${n}];`,
                "/* the least duration, and the clock */",
                unless(`atraj_moves_${plan}(axes, limits, from, to, ${n}, ${values.least}, ${values.cycle})`),
            ];
            const start = isPlain ? ask(plan, "limits", "to", 1) : ask("path", "limits", "axes", 1, 0, 1);
            return main(
                `${types}limits limits[${n}];`,
                `/* ${STATE_ORDER} */`,
                `${types}state ${changes ? "" : "const "}from[${n}] = {${from.join(", ")}};`,
                `${types}state const to[${n}] = {${to.join(", ")}};`,
                ...axisLimits(n, "limits", values),
                ...(changes && isPlain ? [] : moves),
                ...(changes
                    ? runs(n, "from", start, machine(n, values), values, changes)
                    : setpoints("axes[0].t", "", ...eachAxis((axis) => `atraj_move_pos(&axes[${axis}], t)`))),
            );
        },
        path(values, points, changes) {
            const n = points.length - 1;
            const zones = hasZones(values, points);
            const states = points.map(([x, y]) => `{${braces(x, 0, 0)}, ${braces(y, 0, 0)}}`);
            const format = `"%.4f s: %.4f %.4f ${unit}\\n"`;
            const each = [
                `for (int k = 0; k < ${n}; ++k) {`,
                `    ${types}move axes[2];`,
                `    ${unless("atraj_moves_sync(axes, limits, states[k], states[k + 1], 2, durations[k], 0)")}`,
                "    for (int i = k > 0; i <= 5; ++i) {",
                "        double const t = axes[0].t * i / 5;",
                `        ${print}(${format}, start + t, atraj_move_pos(&axes[0], t), atraj_move_pos(&axes[1], t));`,
                "    }",
                "    start += axes[0].t;",
                "}",
            ];
            return main(
                `${types}limits limits[2];`,
                `/* ${STATE_ORDER} ${PATH_ORDER} */`,
                ...wrapped(`${types}state states[${n + 1}][2] = {`, states, "};"),
                `double durations[${n}], work[${workSize(n, zones)}]${changes ? "" : ", start = 0"};`,
                ...(zones ? wrapped(`double const tolerances[${2 * n - 2}] = {`, Array(2 * n - 2).fill(values.zone), "};") : []),
                ...(changes ? [`${types}move axes[${2 * n}];`] : []),
                ...axisLimits(2, "limits", values),
                unless(`atraj_path_plan${zones ? "_near" : ""}(states[0], durations, limits,${zones ? " tolerances," : ""} 2, ${n}, 0, work)`),
                ...(changes
                    ? [
                        unless(`atraj_path_moves(axes, limits, states[0], durations, 2, ${n})`),
                        ...runs(2, "states[0]", ask("path", "limits", "axes", n, 0, 1), machine(2, values), values, changes),
                    ]
                    : each),
            );
        },
    };
}
