// Position, velocity, acceleration and jerk over time, under each other.
import uPlot from "uplot";
import { type Motion, type Quantities, SAMPLES } from "./library";
import { inUnit } from "./units";

export const QUANTITIES = [
    { name: "Position", unit: "m" },
    { name: "Velocity", unit: "m/s" },
    { name: "Acceleration", unit: "m/s²" },
    { name: "Jerk", unit: "m/s³" },
];

/** What happens on the plots: times in s, values in the unit of the quantity. */
export interface Events {
    hover(time: number | undefined): void;
    click(time: number, quantity: number, value: number): void;
}

/** What the axis does from one sample to another. */
interface Stretch {
    from: number;
    to: number;
    kind: "faster" | "even" | "slower";
}

interface Panel {
    figure: HTMLElement;
    values: HTMLElement;
    plot: uPlot;
}

export function number(value: number): string {
    return value.toFixed(4).replace(/^-(0\.0*)$/, "$1").replace("-", "−");
}

export class Plots {
    private panels: Panel[] = [];
    private motions: Motion[] = [];
    private lead = 0;
    private unit = "m";
    private stretches: Stretch[] = [];
    private moment = 0;
    private colors = new Map<string, string>();
    private duration = 0;
    times = new Float64Array();
    /** When the phases of the motion that leads end, s. */
    borders: number[] = [];
    /** By motion, then by quantity. */
    samples: Quantities<Float64Array>[] = [];

    constructor(
        private readonly host: HTMLElement,
        private readonly events: Events,
    ) {
        new ResizeObserver(() => this.resize()).observe(host);
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.repaint());
        document.fonts.ready.then(() => this.repaint());
    }

    /** Draws motions on top of each other. Shading and phases are those of the motion that leads, and so is the room for limits. */
    show(motions: Motion[], lead: number, moment: number, unit: string): void {
        this.duration = Math.max(0, ...motions.map((motion) => motion.duration));
        const dt = this.duration / (SAMPLES - 1);
        this.times = Float64Array.from({ length: motions.length ? SAMPLES : 0 }, (_, k) => k * dt);
        this.samples = motions.map((motion) => motion.sample(dt, SAMPLES));
        const quantities = motions[0]?.quantities ?? QUANTITIES.length;
        this.host.classList.toggle("empty", motions.length === 0);
        const unchanged = this.panels.length === quantities && names(motions) === names(this.motions) && unit === this.unit;
        this.unit = unit;
        this.motions = motions;
        this.lead = lead;
        this.stretches = motions[lead] ? stretches(this.samples[lead][1], dt) : [];
        this.borders = motions[lead]?.borders ?? [];
        this.moment = moment;
        if (unchanged) {
            this.panels.forEach(({ plot }, quantity) => plot.setData(this.data(quantity)));
        } else {
            this.build(quantities);
        }
    }

    /** Shows the values at a time; `pinned` moves the line that marks it. */
    tell(time: number, pinned: boolean): void {
        const states = this.motions.map((motion) => motion.state(time));
        this.panels.forEach(({ values }, quantity) => {
            values.replaceChildren(
                ...states.map((state, i) => {
                    const value = document.createElement("span");
                    value.className = "value";
                    value.style.color = `var(${this.curve(i)})`;
                    value.textContent = number(state[quantity]);
                    value.title = this.motions[i].name;
                    return value;
                }),
            );
        });
        if (pinned && time !== this.moment) {
            this.moment = time;
            this.panels.forEach(({ plot }) => plot.redraw(false));
        }
    }

    /** Says in words what each plot shows. */
    describe(): void {
        this.panels.forEach(({ figure }, quantity) => {
            const { name } = QUANTITIES[quantity];
            const unit = inUnit(QUANTITIES[quantity].unit, this.unit);
            const curves = this.samples.map((all, i) => {
                const curve = all[quantity];
                const [lowest, highest] = [curve.reduce((a, b) => Math.min(a, b)), curve.reduce((a, b) => Math.max(a, b))];
                return `${this.motions[i].name} from ${number(curve[0])} to ${number(curve[curve.length - 1])} ${unit},`
                    + ` between ${number(lowest)} and ${number(highest)}`;
            });
            figure.setAttribute("aria-label", `${name} over time: ${curves.join("; ") || "nothing"}`);
        });
    }

    private data(quantity: number): uPlot.AlignedData {
        return [this.times, ...this.samples.map((all) => all[quantity])];
    }

    private build(quantities: number): void {
        this.panels.forEach(({ plot }) => plot.destroy());
        this.host.replaceChildren();
        this.panels = QUANTITIES.slice(0, quantities).map(({ name, unit }, quantity) => {
            const figure = document.createElement("figure");
            figure.innerHTML = `<div class="caption"><b>${name}</b> <span class="unit">${inUnit(unit, this.unit)}</span><span class="values"></span></div>`;
            figure.setAttribute("role", "img");
            this.host.append(figure);
            const last = quantity + 1 === quantities;
            const plot = new uPlot(this.options(quantity, last), this.data(quantity), figure);
            this.listen(plot, quantity);
            return { figure, values: figure.querySelector<HTMLElement>(".values")!, plot };
        });
        this.resize();
    }

    private options(quantity: number, last: boolean): uPlot.Options {
        const axis: uPlot.Axis = {
            stroke: () => this.color("--faint"),
            grid: { stroke: () => this.color("--grid"), width: 1 },
            ticks: { show: false },
            font: "11px Inter, system-ui, sans-serif",
        };
        return {
            width: 600,
            height: 120,
            legend: { show: false },
            padding: [6, 10, 0, 0],
            cursor: {
                sync: { key: "time" },
                y: false,
                drag: { x: false, y: false },
                points: { size: 7, width: 1.5, fill: (_, curve) => this.color(this.curve(curve - 1)) },
            },
            scales: {
                x: { time: false, range: () => [0, this.duration || 1] },
                y: { range: (_, low, high) => this.span(quantity, low, high) },
            },
            axes: [
                { ...axis, size: last ? 26 : 4, values: last ? (_, splits) => splits.map((time) => `${time} s`) : () => [] },
                { ...axis, size: 50, space: 28 },
            ],
            series: [
                {},
                ...this.motions.map(({ compared }, i): uPlot.Series => ({
                    stroke: () => this.color(this.curve(i)),
                    width: compared ? 1.5 : 2,
                    ...(compared && { dash: [5, 4] }),
                    points: { show: false },
                })),
            ],
            hooks: {
                drawClear: [(plot) => this.drawPhases(plot)],
                draw: [(plot) => this.drawLines(plot, quantity)],
            },
        };
    }

    /** Room for the curves, and for the limits if they are not far above. */
    private span(quantity: number, low: number | null, high: number | null): [number, number] {
        let [lowest, highest] = [low ?? 0, high ?? 1];
        const far = 2 * Math.max(Math.abs(lowest), Math.abs(highest));
        const limits = this.motions[this.lead]?.limits[quantity] ?? [];
        if (highest > 0 && limits[1]! <= far) {
            highest = Math.max(highest, limits[1]!);
        }
        if (lowest < 0 && limits[0]! >= -far) {
            lowest = Math.min(lowest, limits[0]!);
        }
        const margin = 0.08 * (highest - lowest) || 1;
        return [lowest - margin, highest + margin];
    }

    private drawPhases({ ctx, bbox, valToPos }: uPlot): void {
        for (const { from, to, kind } of this.stretches) {
            const [left, right] = [valToPos(from, "x", true), valToPos(to, "x", true)];
            ctx.fillStyle = this.color(`--${kind}`);
            ctx.fillRect(left, bbox.top, right - left, bbox.height);
        }
    }

    private drawLines({ ctx, bbox, valToPos, scales }: uPlot, quantity: number): void {
        const line = (color: string, dash: number[], ...ends: [number, number, number, number]) => {
            ctx.strokeStyle = this.color(color);
            ctx.lineWidth = devicePixelRatio;
            ctx.setLineDash(dash.map((length) => length * devicePixelRatio));
            ctx.beginPath();
            ctx.moveTo(ends[0], ends[1]);
            ctx.lineTo(ends[2], ends[3]);
            ctx.stroke();
        };
        const vertical = (time: number, color: string, dash: number[]) => {
            const x = Math.round(valToPos(time, "x", true)) + 0.5;
            line(color, dash, x, bbox.top, x, bbox.top + bbox.height);
        };
        ctx.save();
        this.borders.forEach((time) => vertical(time, "--border", []));
        this.motions[this.lead]?.pieces.slice(1).forEach(({ start }) => vertical(start, "--accent", [2, 2]));
        this.motions.forEach((motion, i) => {
            for (const limit of motion.compared ? [] : (motion.limits[quantity] ?? [])) {
                if (limit > scales.y.min! && limit < scales.y.max!) {
                    const y = Math.round(valToPos(limit, "y", true)) + 0.5;
                    line(this.limit(i), i === this.lead ? [5, 3] : [1, 4], bbox.left, y, bbox.left + bbox.width, y);
                }
            }
        });
        if (this.motions.length > 0) {
            vertical(this.moment, "--ink", []);
        }
        ctx.setLineDash([]);
        this.motions.forEach((motion, i) => {
            const value = motion.state(this.moment)[quantity];
            ctx.fillStyle = this.color(this.curve(i));
            ctx.beginPath();
            ctx.arc(valToPos(this.moment, "x", true), valToPos(value, "y", true), 4 * devicePixelRatio, 0, 2 * Math.PI);
            ctx.fill();
        });
        ctx.restore();
    }

    private listen(plot: uPlot, quantity: number): void {
        const { over } = plot;
        const at = (event: MouseEvent): [number, number] => {
            const { left, top } = over.getBoundingClientRect();
            return [plot.posToVal(event.clientX - left, "x"), plot.posToVal(event.clientY - top, "y")];
        };
        over.addEventListener("pointermove", (event) => this.events.hover(at(event)[0]));
        over.addEventListener("pointerleave", () => this.events.hover(undefined));
        over.addEventListener("click", (event) => {
            const [time, value] = at(event);
            this.events.click(time, quantity, value);
        });
    }

    private resize(): void {
        const width = this.host.clientWidth;
        this.panels.forEach(({ plot }, quantity) => {
            const last = quantity + 1 === this.panels.length;
            const height = parseFloat(getComputedStyle(this.host).getPropertyValue("--plots")) / this.panels.length;
            plot.setSize({ width, height: height + (last ? 22 : 0) });
        });
    }

    /** The name of a curve's colour. */
    private curve(i: number): string {
        return this.motions[i]?.compared ? "--compared" : `--curve-${i}`;
    }

    /** The name of the colour of limits: of several axes, each has its own. */
    private limit(i: number): string {
        return this.motions.some((motion, other) => other !== i && !motion.compared) ? this.curve(i) : "--limit";
    }

    /** A colour of the style sheet, as it is now. */
    private color(name: string): string {
        let color = this.colors.get(name);
        if (color === undefined) {
            color = getComputedStyle(this.host).getPropertyValue(name);
            this.colors.set(name, color);
        }
        return color;
    }

    private repaint(): void {
        this.colors.clear();
        this.panels.forEach(({ plot }) => plot.redraw());
    }
}

/** The curves that a plot has. */
function names(motions: Motion[]): string {
    return motions.map(({ name, compared }) => `${name} ${compared}`).join();
}

/** Where the speed grows, stays and falls. */
function stretches(velocity: Float64Array, dt: number): Stretch[] {
    const highest = velocity.reduce((most, v) => Math.max(most, Math.abs(v)), 0);
    const found: Stretch[] = [];
    for (let k = 0; k + 1 < velocity.length; k += 1) {
        const gain = Math.abs(velocity[k + 1]) - Math.abs(velocity[k]);
        const kind = Math.abs(gain) <= 1e-9 * highest ? "even" : gain > 0 ? "faster" : "slower";
        const last = found.at(-1);
        if (last?.kind === kind) {
            last.to = (k + 1) * dt;
        } else {
            found.push({ from: k * dt, to: (k + 1) * dt, kind });
        }
    }
    return found;
}
