// The buttons that run a motion in real time, hold, override and stop it.
import { message, type Motion } from "./library";
import { type Change, Run, type Start } from "./run";

/** What the page does while a motion runs. */
export interface Screen {
    /** The moves to run, and how they start. */
    plan(): [Motion[], Start];
    /** Draws what is run so far, and what follows if nothing is changed. */
    draw(motions: Motion[], time: number): void;
    /** Moves the marker. */
    mark(time: number): void;
    /** A run has begun, was changed or is over. */
    tell(): void;
}

const percent = (rate: number) => `${Math.round(100 * rate)} %`;
/** A frame takes no longer, s: a page that was out of sight does not leap. */
const LONGEST = 0.25;

export class Player {
    private run: Run | undefined;
    private frame = 0;
    /** When the last frame was, ms, and how far the run is to be, s. */
    private last = 0;
    private due = 0;
    /** How far the motion is drawn, s. */
    private drawn = 0;
    private readonly button: HTMLButtonElement;
    private readonly brake: HTMLButtonElement;
    private readonly override: HTMLInputElement;
    private readonly shown: HTMLElement;
    private readonly words: HTMLElement;

    constructor(
        host: HTMLElement,
        private readonly screen: Screen,
    ) {
        [this.button, this.brake, this.override, this.shown, this.words] = ["button", "button + button", "input", "output", "p"].map(
            (name) => host.querySelector(name)!,
        ) as [HTMLButtonElement, HTMLButtonElement, HTMLInputElement, HTMLElement, HTMLElement];
        this.button.addEventListener("click", () => this.press());
        this.brake.addEventListener("click", () => this.change());
        this.override.addEventListener("input", () => (this.shown.textContent = percent(this.wanted)));
        this.override.addEventListener("change", () => this.turn());
    }

    get isRunning(): boolean {
        return this.run !== undefined && !this.run.isOver;
    }

    /** What the group was asked for; none without a run of the present plan. */
    get changes(): Change[] | undefined {
        return this.run?.changes;
    }

    /** Forgets the run: the plan is another one. */
    stop(): void {
        cancelAnimationFrame(this.frame);
        this.run = undefined;
        this.say("");
    }

    private get wanted(): number {
        return this.override.valueAsNumber / 100;
    }

    private press(): void {
        if (this.isRunning) {
            this.change(this.run!.rate === 0 ? this.wanted : 0);
        } else {
            this.start();
        }
    }

    private start(): void {
        const [planned, start] = this.screen.plan();
        if (planned.length === 0) {
            return;
        }
        const run = new Run(planned, start);
        if (run.code < 0) {
            this.say(`The run is refused: ${message(run.code)}.`, true);
            return;
        }
        [this.run, this.last, this.due] = [run, performance.now(), 0];
        this.say(`Runs at ${percent(1)}.`);
        this.draw();
        this.screen.tell();
        if (this.wanted !== 1) {
            this.change(this.wanted);
        }
        this.step();
    }

    /** The knob was turned. A motion that is held stays held. */
    private turn(): void {
        if (this.isRunning && this.run!.rate > 0) {
            this.change(this.wanted);
            this.override.value = String(Math.round(100 * (this.run!.rate || this.wanted)));
        }
        this.shown.textContent = percent(this.wanted);
    }

    /** Asks for a rate, or else for a stop. One above 100 % becomes the highest that the limits allow. */
    private change(asked?: number): void {
        this.advance();
        const run = this.run!;
        if (run.isOver) {
            return;
        }
        const before = run.rate;
        const rate = asked !== undefined && asked > Math.max(1, before) ? run.highest(asked) : asked;
        const code = rate === before ? 0 : run.change(rate);
        this.draw();
        if (code < 0) {
            const rest = before === 0 ? "The axes stop and stand as before." : `It goes on at ${percent(before)}.`;
            this.say(`${asked === undefined ? "The stop" : asked === 0 ? "The hold" : percent(asked)} is refused: ${message(code)}. ${rest}`, true);
        } else if (rate === undefined || (rate === 0 && code === 0)) {
            this.say(`${rate === 0 ? "Holds" : "Stops"}: stands in ${run.rest.toFixed(3)} s.`);
        } else if (code > 0) {
            this.say(`The path ends before ${rate === 0 ? "it stands" : `${percent(rate)} is reached`}.`);
        } else if (rate < asked!) {
            this.say(`${percent(asked!)} is refused: the limits allow ${percent(rate)} until the end.`, true);
        } else {
            this.say(`Runs at ${percent(rate)}.`);
        }
        this.screen.tell();
    }

    private draw(): void {
        const motions = this.run!.motions();
        this.drawn = motions[0].duration;
        this.screen.draw(motions, this.run!.time);
    }

    /** Lets the group tick as often as it is time. */
    private advance(): void {
        const now = performance.now();
        this.due += Math.min((now - this.last) / 1000, LONGEST);
        this.last = now;
        const stood = this.run!.stands;
        this.run!.advance(this.due);
        if (this.run!.stands && !stood) {
            this.say("Holds: the axes stand.");
        }
    }

    private step(): void {
        const run = this.run!;
        this.advance();
        if (run.isOver || run.time > this.drawn) {
            this.draw();
        } else {
            this.screen.mark(run.time);
        }
        if (run.isOver) {
            this.say(run.changes.at(-1)?.rate === undefined && run.rate === 0 ? "The axes stand." : "The path is at its end.");
            this.screen.tell();
            return;
        }
        this.frame = requestAnimationFrame(() => this.step());
    }

    private say(words: string, isRefused = false): void {
        this.words.textContent = words;
        this.words.classList.toggle("bad", isRefused);
        this.brake.hidden = !this.isRunning;
        this.button.textContent = !this.run ? "Run" : !this.isRunning ? "Run again" : this.run.rate === 0 ? "Go on" : "Hold";
    }
}
