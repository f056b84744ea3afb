// A group of axes, which the library moves tick by tick, and holds, overrides and stops.
import { c, Motion, numbers, Ticked } from "./library";

/** From one tick to the next, s. */
export const PERIOD = 0.001;
/** How many ticks are looked ahead at most: in motion, and while the axes stand. */
const [FAR, NEAR] = [60_000, 500];
const [GROUP, COPY, NOW, LIMITS, ENDS] = [c.group_at(0), c.group_at(1), c.now_at(), c.limits_at(0), c.tick_ends()];

/** The call of the group that starts a motion. */
export type Start = "go" | "sync" | "line" | "path";

/** What the group was asked for before a tick: another rate of the motion, or else a stop. */
export interface Change {
    tick: number;
    rate?: number;
}

/** The library's places hold the moves and the group until the next plan. */
export class Run {
    readonly changes: Change[] = [];
    /** Less than 0: the library refuses the start. */
    readonly code: number;
    /** 1: as planned. */
    rate = 1;
    /** In a hold. */
    stands = false;
    isOver = false;
    /** In each tick: position, velocity and acceleration of each axis. */
    private readonly past: number[][] = [];
    private ahead: number[][] = [];
    private holds = false;

    /** The moves, as they are planned now. Their limits are those of the machine, without the reserve of the plan. */
    constructor(private readonly moves: Motion[], start: Start) {
        moves.forEach((motion, axis) => c.set_state(c.own_at(axis), ...motion.state(0).slice(0, 3)));
        c.atraj_group_init(GROUP, PERIOD, c.own_at(0), c.room_at(), moves.length);
        const target = start === "path" ? [c.move_at(0), moves[0].pieces.length, 0] : [c.to_at(0)];
        this.code = c[`atraj_group_${start}`](GROUP, LIMITS, ...target, 1);
        moves.forEach(({ limits }, axis) => {
            c.set_limits(c.limits_at(axis), ...limits.slice(1).flatMap((range) => [range![1], range![0]]));
        });
        this.advance(0);
    }

    get time(): number {
        return (this.past.length - 1) * PERIOD;
    }

    /** How long until the motion is at its end or stands, s. */
    get rest(): number {
        return this.ahead.length * PERIOD;
    }

    /** Ticks until the time `to`, or until the motion is over. */
    advance(to: number): void {
        while (!this.isOver && this.time < to) {
            if (this.tick(GROUP, this.past)) {
                [this.stands, this.isOver] = [this.holds, !this.holds];
            }
        }
    }

    /** Goes to another rate from the next tick on, or stops. Less than 0: the library refuses, and the motion goes on as before. */
    change(rate?: number): number {
        const code = rate === undefined ? c.atraj_group_stop(GROUP, LIMITS, 1) : c.atraj_group_rate(GROUP, LIMITS, rate, 1);
        if (code >= 0) {
            this.changes.push({ tick: this.past.length, rate });
            [this.rate, this.stands, this.holds] = [rate ?? 0, false, rate === 0 && code === 0];
        }
        return code;
    }

    /** The highest rate up to `asked`, in hundredths, that is reached before the end; the present one if there is none. */
    highest(asked: number): number {
        let [possible, above] = [Math.round(100 * this.rate), Math.round(100 * asked) + 1];
        while (possible + 1 < above) {
            const middle = Math.floor((possible + above) / 2);
            c.copy_group(COPY, GROUP);
            const isReached = c.atraj_group_rate(COPY, LIMITS, middle / 100, 1) === 0;
            [possible, above] = isReached ? [middle, above] : [possible, middle];
        }
        return possible / 100;
    }

    /** What the axes did, and what follows if nothing is changed. */
    motions(): Motion[] {
        this.lookAhead();
        const ticks = [...this.past, ...this.ahead];
        const end = (ticks.length - 1) * PERIOD;
        const starts = [0, ...this.changes.map(({ tick }) => tick)];
        return this.moves.map(({ name, limits }, axis) => {
            const curves = [0, 1, 2].map((quantity) => ticks.map((states) => states[3 * axis + quantity]));
            const jerk = curves[2].map((a, k) => ((curves[2][k + 1] ?? a) - a) / PERIOD);
            const pieces = starts.map((tick) => {
                const start = tick * PERIOD;
                return { start, plan: new Ticked([...curves, jerk], PERIOD, tick, end - start) };
            });
            return new Motion(name, pieces, limits);
        });
    }

    /** Ticks a copy of the group to the end of the motion, or on while the axes stand. */
    private lookAhead(): void {
        this.ahead = [];
        c.copy_group(COPY, GROUP);
        const far = this.isOver ? 0 : this.stands ? NEAR : FAR;
        while (this.ahead.length < far && !this.tick(COPY, this.ahead)) {}
    }

    /** Whether the motion is at its end, or stands. */
    private tick(group: number, record: number[][]): boolean {
        const news = c.atraj_group_tick(group, NOW);
        record.push([...numbers(NOW, 3 * this.moves.length)]);
        return (news & ENDS) !== 0;
    }
}
