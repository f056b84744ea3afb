// The table of a motion, to be saved.
import type { Motion } from "./library";
import { QUANTITIES } from "./plots";
import { inUnit } from "./units";

const MOST_ROWS = 100_000;

/** A row every `step` seconds, and one for the end. Undefined if the step is not above 0, or there are too many rows. */
export function table(motions: Motion[], step: number, unit: string): string | undefined {
    const duration = Math.max(0, ...motions.map((motion) => motion.duration));
    if (!(step > 0) || duration / step > MOST_ROWS) {
        return undefined;
    }
    const heads = motions.flatMap(({ name, quantities }) =>
        QUANTITIES.slice(0, quantities).map((quantity) => `${name} ${quantity.name.toLowerCase()} [${inUnit(quantity.unit, unit)}]`),
    );
    const times = Array.from({ length: Math.ceil(duration / step) }, (_, k) => k * step).concat(duration);
    const rows = times.map((time) => [time, ...motions.flatMap((motion) => motion.state(time))].join(","));
    return [["time [s]", ...heads].join(","), ...rows, ""].join("\n");
}
