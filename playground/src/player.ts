// The buttons that run a motion in real time, hold it and override it.
import { message, type Motion } from "./library";
import { Run } from "./run";

/** What the page does while a motion runs. */
export interface Screen {
    /** The moves that are planned, with a reserve for the clock. */
    plan(): Motion[];
    /** Draws what is run so far, and what follows if the rate stays. */
    draw(motions: Motion[], time: number): void;
    /** Moves the marker. */
    mark(time: number): void;
}

const percent = (rate: number) => `${Math.round(100 * rate)} %`;

export class Player {
    private run: Run | undefined;
    /** What `requestAnimationFrame` says at the time 0 of the run, ms. */
    private begun = 0;
    private frame = 0;
    /** How far the motion is drawn, s. */
    private drawn = 0;
    private readonly button: HTMLButtonElement;
    private readonly override: HTMLInputElement;
    private readonly shown: HTMLElement;
    private readonly words: HTMLElement;

    constructor(
        host: HTMLElement,
        private readonly screen: Screen,
    ) {
        [this.button, this.override, this.shown, this.words] = ["button", "input", "output", "p"].map(
            (name) => host.querySelector(name)!,
        ) as [HTMLButtonElement, HTMLInputElement, HTMLElement, HTMLElement];
        this.button.addEventListener("click", () => this.press());
        this.override.addEventListener("input", () => this.turn());
        this.override.addEventListener("change", () => this.settle());
    }

    /** Ends the run: the plan is another one. */
    stop(): void {
        cancelAnimationFrame(this.frame);
        this.run = undefined;
        this.button.textContent = "Run";
        this.words.textContent = "";
        this.settle();
    }

    private get time(): number {
        return (performance.now() - this.begun) / 1000;
    }

    private get wanted(): number {
        return this.override.valueAsNumber / 100;
    }

    private press(): void {
        if (!this.run) {
            this.start();
        } else {
            this.change(this.run.rate === 0 ? this.wanted : 0);
        }
    }

    private start(): void {
        const planned = this.screen.plan();
        if (planned.length === 0) {
            return;
        }
        this.run = new Run(planned);
        this.begun = performance.now();
        this.say(`Runs at ${percent(1)}.`);
        if (this.wanted !== 1) {
            this.change(this.wanted);
        }
        this.draw();
        this.step();
    }

    /** The knob is turned. A motion that is held stays held. */
    private turn(): void {
        this.shown.textContent = percent(this.wanted);
        if (this.run && this.run.rate > 0) {
            this.change(this.wanted);
        }
    }

    /** The knob is let go: it shows the rate. */
    private settle(): void {
        if (this.run && this.run.rate > 0) {
            this.override.value = String(Math.round(100 * this.run.rate));
        }
        this.shown.textContent = percent(this.wanted);
    }

    /** Asks for a rate. One above 100 % becomes the highest that the reserve allows. */
    private change(asked: number): void {
        const run = this.run!;
        if (run.isFull) {
            this.say("The page remembers no more changes: run it again.");
            return;
        }
        const { time } = this;
        const rate = asked > Math.max(1, run.rate) ? run.highest(time, asked) : asked;
        const code = run.change(time, rate);
        if (code < 0) {
            this.say(`${asked === 0 ? "The hold" : percent(asked)} is refused: ${message(code)}. It goes on at ${percent(run.rate)}.`, true);
        } else if (rate < asked) {
            this.say(`${percent(asked)} is refused: the reserve allows ${percent(rate)} until the end.`, true);
        } else if (code > 0) {
            this.say(`The path ends before ${rate === 0 ? "it stands" : `${percent(rate)} is reached`}.`);
        } else {
            this.say(rate === 0 ? `Holds: stands in ${(run.until - time).toFixed(3)} s.` : `Runs at ${percent(rate)}.`);
        }
        this.draw();
    }

    private draw(): void {
        const { time } = this;
        const { end, until } = this.run!;
        this.drawn = end < Infinity ? end : Math.max(time, until);
        this.screen.draw(this.run!.motions(this.drawn), Math.min(time, this.drawn));
    }

    private step(): void {
        const { time } = this;
        if (time >= this.run!.end) {
            this.screen.mark(this.drawn);
            this.run = undefined;
            this.button.textContent = "Run again";
            this.say("The path is at its end.");
            return;
        }
        if (time > this.drawn) {
            this.draw();
        } else {
            this.screen.mark(time);
        }
        this.frame = requestAnimationFrame(() => this.step());
    }

    private say(words: string, isRefused = false): void {
        this.words.textContent = words;
        this.words.classList.toggle("bad", isRefused);
        if (this.run) {
            this.button.textContent = this.run.rate === 0 ? "Go on" : "Hold";
        }
    }
}
