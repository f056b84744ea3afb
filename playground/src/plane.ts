// The path of two axes in their plane, whose waypoints are dragged or moved by the arrow keys.
import { number } from "./plots";
import type { Point } from "./state";

export interface Moves {
    /** A waypoint is to be there. */
    move(index: number, to: Point): void;
    remove(index: number): void;
    /** The zones are to be so large. */
    resize(zone: number): void;
}

/** Room around the path, and the most height, in pixels. */
const [MARGIN, HIGHEST] = [36, 320];
const KEYS: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

function drawn<Name extends keyof SVGElementTagNameMap>(name: Name, attributes: Record<string, string | number>): SVGElementTagNameMap[Name] {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, String(value)));
    return made;
}

export class Plane {
    private readonly grid = drawn("g", { class: "grid" });
    private readonly straight = drawn("polyline", { class: "straight" });
    private readonly path = drawn("polyline", { class: "path" });
    private readonly marker = drawn("circle", { class: "marker", r: 5 });
    private readonly zones = drawn("g", {});
    private handles: SVGCircleElement[] = [];
    private points: Point[] = [];
    private unit = "m";
    /** The waypoint, or a zone. */
    private dragged: number | "zone" | undefined;
    /** Width and height, in pixels. */
    private size: Point = [0, 0];
    /** Pixels for one unit of position in both directions, and the position in the middle. */
    private scale = 1;
    private middle: Point = [0, 0];
    /** Distance of the lines of the grid. */
    private tick = 1;

    constructor(
        private readonly host: SVGSVGElement,
        private readonly events: Moves,
    ) {
        host.append(this.grid, this.zones, this.straight, this.path, this.marker);
    }

    /** Shows the waypoints with their zones, and the path of two curves, if there is one. */
    show(points: Point[], zone: number, [xs, ys]: Float64Array[], unit: string): void {
        [this.points, this.unit] = [points, unit];
        const path = Array.from(xs ?? [], (x, k): Point => [x, ys[k]]);
        const inner = zone > 0 ? points.slice(1, -1) : [];
        this.marker.toggleAttribute("hidden", path.length === 0);
        if (this.dragged === undefined) {
            const corners = [-zone, zone].flatMap((off) => inner.map((point) => point.map((value) => value + off) as Point));
            this.fit([...points, ...path, ...corners]);
            this.drawGrid();
        }
        this.zones.replaceChildren(...inner.map((point) => this.zone(point, zone)));
        this.line(this.straight, points);
        this.line(this.path, path);
        while (this.handles.length > points.length) {
            this.handles.pop()!.remove();
        }
        while (this.handles.length < points.length) {
            this.handles.push(this.handle(this.handles.length));
        }
        this.handles.forEach((handle, i) => this.place(handle, i));
    }

    /** Moves the marker to where the axes are. */
    mark(place: Point): void {
        this.center(this.marker, place);
    }

    focus(index: number): void {
        this.handles[index].focus();
    }

    /** Scales the picture such that these points are in it. */
    private fit(points: Point[]): void {
        const spans = [0, 1].map((axis) => {
            const values = points.map((point) => point[axis]);
            return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
        });
        const width = this.host.clientWidth;
        this.size = [width, Math.min(HIGHEST, 0.7 * width)];
        this.host.setAttribute("viewBox", `0 0 ${this.size.join(" ")}`);
        const lengths = spans.map(([lowest, highest]) => highest - lowest || 1);
        this.scale = Math.min(...lengths.map((length, axis) => (this.size[axis] - 2 * MARGIN) / length));
        this.middle = spans.map(([lowest, highest]) => (lowest + highest) / 2) as Point;
        const coarse = 60 / this.scale;
        const power = 10 ** Math.floor(Math.log10(coarse));
        this.tick = power * [1, 2, 5, 10].find((step) => step * power >= coarse)!;
    }

    private drawGrid(): void {
        const lines: SVGElement[] = [];
        const [width, height] = this.size;
        for (const [axis, size] of this.size.entries()) {
            const half = size / 2 / this.scale;
            const last = Math.floor((this.middle[axis] + half - 24 / this.scale) / this.tick); // room for its label
            for (let k = Math.ceil((this.middle[axis] - half) / this.tick); k <= last; k += 1) {
                const at = this.across(axis, k * this.tick);
                const text = drawn("text", axis === 0 ? { x: at + 3, y: height - 4 } : { x: 3, y: at - 3 });
                text.textContent = `${Number((k * this.tick).toPrecision(6))}${k === last ? ` ${this.unit}` : ""}`;
                lines.push(drawn("path", { d: axis === 0 ? `M${at} 0V${height}` : `M0 ${at}H${width}` }), text);
            }
        }
        this.grid.replaceChildren(...lines);
    }

    /** Where a position of an axis is in the picture. */
    private across(axis: number, position: number): number {
        const off = (position - this.middle[axis]) * this.scale;
        return this.size[axis] / 2 + (axis === 0 ? off : -off);
    }

    private line(line: SVGPolylineElement, points: Point[]): void {
        line.setAttribute("points", points.map(([x, y]) => `${this.across(0, x).toFixed(1)},${this.across(1, y).toFixed(1)}`).join(" "));
    }

    /** The zone around a point, whose edge is dragged. */
    private zone(point: Point, size: number): SVGRectElement {
        const [x, y, side] = [this.across(0, point[0] - size), this.across(1, point[1] + size), 2 * size * this.scale];
        const zone = drawn("rect", { class: "zone", x, y, width: side, height: side });
        zone.addEventListener("pointerdown", () => {
            const drag = (event: PointerEvent) =>
                this.events.resize(Math.max(...this.at(event).map((value, axis) => Math.abs(value - point[axis]))));
            const drop = (event: PointerEvent) => {
                this.host.removeEventListener("pointermove", drag);
                this.dragged = undefined;
                drag(event);
            };
            this.dragged = "zone";
            this.host.addEventListener("pointermove", drag);
            addEventListener("pointerup", drop, { once: true });
        });
        return zone;
    }

    private center(circle: SVGCircleElement, [x, y]: Point): void {
        circle.setAttribute("cx", this.across(0, x).toFixed(1));
        circle.setAttribute("cy", this.across(1, y).toFixed(1));
    }

    private place(handle: SVGCircleElement, i: number): void {
        const [x, y] = this.points[i];
        this.center(handle, this.points[i]);
        handle.setAttribute("aria-valuenow", String(x));
        handle.setAttribute("aria-valuetext", `x ${number(x)} ${this.unit}, y ${number(y)} ${this.unit}`);
    }

    private handle(i: number): SVGCircleElement {
        const handle = drawn("circle", {
            class: "point", r: 9, tabindex: 0, role: "slider", "aria-label": `Waypoint ${i + 1}`, "aria-roledescription": "waypoint",
        });
        handle.addEventListener("pointerdown", (event) => {
            handle.setPointerCapture(event.pointerId);
            this.dragged = i;
        });
        handle.addEventListener("pointermove", (event) => {
            if (this.dragged === i) {
                this.events.move(i, this.at(event));
            }
        });
        handle.addEventListener("lostpointercapture", () => {
            this.dragged = undefined;
            this.events.move(i, this.points[i]);
        });
        handle.addEventListener("keydown", (event) => {
            const step = KEYS[event.key];
            const size = this.tick * (event.shiftKey ? 0.5 : 0.05);
            if (step) {
                this.events.move(i, this.points[i].map((value, axis) => value + size * step[axis]) as Point);
            } else if (event.key === "Delete" || event.key === "Backspace") {
                this.events.remove(i);
            } else {
                return;
            }
            event.preventDefault();
        });
        this.host.append(handle);
        return handle;
    }

    /** The position under the pointer. */
    private at({ clientX, clientY }: PointerEvent): Point {
        const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(this.host.getScreenCTM()!.inverse());
        return [this.middle[0] + (x - this.size[0] / 2) / this.scale, this.middle[1] - (y - this.size[1] / 2) / this.scale];
    }
}
