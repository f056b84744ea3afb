// Moves that a clock runs: whatever the rate was, is and will be, they stay on their path.
import { c, Clocked, CLOCKS, type Layout, Motion } from "./library";

/** The one call of the library that changes the rate. The limits are at the places of the limits, axis by axis. */
function changeRate(clock: number, { axes, sections }: Layout, x: number, rate: number): number {
    return c.atraj_clock_rate(clock, c.move_at(0), c.limits_at(0), axes, sections, x, rate);
}

/** The library's places hold the moves until the next plan. */
export class Run {
    /** When the rate changed, s. Each change has a clock of its own, so what has been run stays. */
    private readonly changes = [0];
    private readonly layout: Layout;
    /** 1: as planned. */
    rate = 1;

    /** The moves of the axes, which end together. Their limits are those of the machine. */
    constructor(private readonly moves: Motion[]) {
        this.layout = { axes: moves.length, sections: moves[0].pieces.length };
        c.atraj_clock_start(c.clock_at(0));
    }

    get isFull(): boolean {
        return this.changes.length === CLOCKS;
    }

    /** Goes to another rate from the time `x` on. Negative: the library refuses, and the run goes on as before. */
    change(x: number, rate: number): number {
        const [now, next] = [this.clock, c.clock_at(this.changes.length)];
        this.moves.forEach(({ limits }, axis) => {
            c.set_limits(c.limits_at(axis), ...limits.slice(1).flatMap((range) => [range![1], range![0]]));
        });
        c.copy_clock(next, now);
        const code = changeRate(next, this.layout, x, rate);
        if (code >= 0) {
            this.changes.push(x);
            this.rate = rate;
        }
        return code;
    }

    /** The highest rate up to `rate`, in hundredths, that is reached before the path ends; the present one if there is none. */
    highest(x: number, rate: number): number {
        const present = this.rate;
        let [possible, above] = [Math.round(100 * present), Math.round(100 * rate) + 1];
        while (possible + 1 < above) {
            const middle = Math.floor((possible + above) / 2);
            const code = this.change(x, middle / 100);
            if (code >= 0) {
                [possible, above] = code === 0 ? [middle, above] : [possible, middle];
                this.changes.pop();
                this.rate = present;
            } else {
                above = middle;
            }
        }
        return possible / 100;
    }

    /** When the rate is reached, s. */
    get until(): number {
        return c.atraj_clock_until(this.clock);
    }

    /** When the path ends, s; infinite while it is held. */
    get end(): number {
        const { clock, until, rate } = this;
        const rest = this.moves[0].duration - c.atraj_clock_time(clock, until);
        return rest > 0 ? (rate > 0 ? until + rest / rate : Infinity) : until;
    }

    /** What the axes do until the time `to`, if the rate stays. */
    motions(to: number): Motion[] {
        return this.moves.map(({ name, limits, pieces: [{ plan }] }) => {
            const pieces = this.changes.map((start, i) => {
                const end = this.changes[i + 1] ?? to;
                return { start, plan: new Clocked(plan.place, this.layout, c.clock_at(i), start, end - start) };
            });
            return new Motion(name, pieces, limits);
        });
    }

    private get clock(): number {
        return c.clock_at(this.changes.length - 1);
    }
}
