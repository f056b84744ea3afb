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

/** What a length was before it was converted, and in which unit. */
const origins = new Map<string, [value: number, unit: string]>();

/** A length in another unit, to six digits; the number that it was, if it comes back. */
export function converted(value: number, from: string, to: string): number {
    const [original, unit] = origins.get(`${value} ${from}`) ?? [value, from];
    const result = unit === to ? original : Number(((original * SCALES[to]) / SCALES[unit]).toPrecision(6));
    origins.set(`${result} ${to}`, [original, unit]);
    return result;
}
