// The unit of position. The library computes with numbers, so the unit is the caller's.

/** How many of the unit a slider has where it has one metre. */
const SCALES: Record<string, number> = { m: 1, mm: 1000, deg: 180 / Math.PI, rad: 1, steps: 1000 };

export const UNITS = Object.keys(SCALES);

const METRE = /^m(?=$|\/)/;

/** Whether a quantity in this unit of metres and seconds depends on the unit of position. */
export const isLength = (unit: string) => METRE.test(unit);

/** A unit of metres and seconds, with the unit of position for the metre. */
export const inUnit = (text: string, unit: string) => text.replace(METRE, unit);

/** How many of the unit a length of metres has on the sliders. */
export const scale = (unit: string) => SCALES[unit];

/** A length in another unit, to six digits. */
export function converted(value: number, from: string, to: string): number {
    return Number(((value * SCALES[to]) / SCALES[from]).toPrecision(6));
}
