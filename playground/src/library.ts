// The library: its C functions in WebAssembly, and plans that are evaluated by them.
import bytes from "../../target/playground/atraj.wasm";

/** The C functions by name. Pointers are numbers, and a `double` is a number. */
type Functions = Record<string, (...numbers: number[]) => number>;

const { instance } = await WebAssembly.instantiate(bytes);
const { memory, ...functions } = instance.exports;
export const c = functions as Functions;

export const AXES = c.axis_count();
/** How many moves there are places for. */
export const MOVES = c.move_count();
/** How many waypoints there are places for. */
export const POINTS = c.point_count();
/** How many samples there is room for. */
export const SAMPLES = c.sample_count();

/** Position, velocity, acceleration and, if the profile has one, jerk. */
export type Quantities<T> = T[];

/** Lowest and highest. */
export type Range = [number, number];

export type Family = "bell" | "trap" | "poly3" | "poly5" | "poly7" | "move";

const QUANTITIES: Record<Family, number> = { bell: 4, trap: 3, poly3: 3, poly5: 3, poly7: 4, move: 4 };

/** The library's sentence for a code. */
export function message(code: number): string {
    const text = new Uint8Array((memory as WebAssembly.Memory).buffer, c.atraj_message(code));
    return new TextDecoder().decode(text.subarray(0, text.indexOf(0)));
}

/** The numbers at a place. */
export function numbers(place: number, n: number): Float64Array {
    return new Float64Array((memory as WebAssembly.Memory).buffer, place, n);
}

/** A planned struct at a place of the module's memory. The next plan at this place overwrites it. */
export class Plan {
    constructor(
        readonly family: Family,
        readonly place: number,
        /** s */
        readonly duration: number,
        /** When the phases end, s. */
        readonly borders: number[] = [],
    ) {}

    get quantities(): number {
        return QUANTITIES[this.family];
    }

    /** Samples at the times `x0 + k * dt`. */
    sample(x0: number, dt: number, n: number): Quantities<Float64Array> {
        const places = Array.from({ length: this.quantities }, (_, quantity) => c.samples_at(quantity));
        c[`atraj_${this.family}_sample`](this.place, x0, dt, n, ...places);
        return places.map((place) => numbers(place, n).slice());
    }
}

/** What an axis did or will do in each tick, from the tick `first` on. Between two ticks its quantities change evenly. */
export class Ticked extends Plan {
    constructor(
        private readonly curves: Quantities<number[]>,
        private readonly period: number,
        private readonly first: number,
        duration: number,
    ) {
        super("move", 0, duration);
    }

    override sample(x0: number, dt: number, n: number): Quantities<Float64Array> {
        const tick = (k: number) => this.first + (x0 + k * dt) / this.period;
        return this.curves.map((curve) => Float64Array.from({ length: n }, (_, k) => between(curve, tick(k))));
    }
}

function between(curve: number[], tick: number): number {
    const at = Math.max(0, Math.min(tick, curve.length - 1));
    const [before, after] = [curve[Math.floor(at)], curve[Math.ceil(at)]];
    return before + (at % 1) * (after - before);
}

/** What an axis does: one plan, or plans that follow each other when it is retargeted in motion. */
export class Motion {
    constructor(
        readonly name: string,
        readonly pieces: { start: number; plan: Plan }[],
        /** Lowest and highest value of a quantity. */
        readonly limits: Quantities<Range | undefined>,
        /** Shown for comparison only. */
        readonly compared = false,
    ) {}

    get duration(): number {
        const { start, plan } = this.pieces[this.pieces.length - 1];
        return start + plan.duration;
    }

    get quantities(): number {
        return this.pieces[0].plan.quantities;
    }

    /** When phases end, s. */
    get borders(): number[] {
        return this.pieces.flatMap(({ start, plan }, i) => {
            const next = this.pieces[i + 1]?.start ?? Infinity;
            return plan.borders.map((time) => start + time).filter((time) => time < next);
        });
    }

    /** Samples at the times `k * dt`. */
    sample(dt: number, n: number): Quantities<Float64Array> {
        const samples = Array.from({ length: this.quantities }, () => new Float64Array(n));
        this.pieces.forEach(({ start, plan }, i) => {
            const first = Math.min(Math.ceil(start / dt), n);
            const end = i + 1 < this.pieces.length ? Math.min(Math.ceil(this.pieces[i + 1].start / dt), n) : n;
            const piece = plan.sample(first * dt - start, dt, end - first);
            samples.forEach((all, quantity) => all.set(piece[quantity], first));
        });
        return samples;
    }

    /** The quantities at one time, s. */
    state(time: number): Quantities<number> {
        const { start, plan } = this.pieces.findLast((piece) => piece.start <= time) ?? this.pieces[0];
        return plan.sample(time - start, 0, 1).map(([value]) => value);
    }
}

/** The borders that `border(plan, 0 …)` tells, until it tells none. */
function borders(border: (plan: number, i: number) => number, place: number): number[] {
    const times = [];
    for (let time = border(place, 0); !Number.isNaN(time); time = border(place, times.length)) {
        times.push(time);
    }
    return times;
}

export function bell(place: number, duration: number): Plan {
    return new Plan("bell", place, duration, borders(c.bell_border, place));
}

export function trap(place: number, duration: number): Plan {
    return new Plan("trap", place, duration, borders(c.trap_border, place));
}

export function move(place: number): Plan {
    return new Plan("move", place, c.move_duration(place), borders(c.move_border, place));
}
