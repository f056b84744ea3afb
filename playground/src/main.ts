// The page: whatever changes the state is planned, drawn and told anew.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { code, type Language, LANGUAGES } from "./code";
import { element, showChoice, showFields } from "./controls";
import { AXES, c, type Motion } from "./library";
import { Player } from "./player";
import { number, Plots, QUANTITIES } from "./plots";
import { AXIS_NAMES, COMMANDS, fields, initial, type Outcome, PROFILES } from "./profiles";
import { type Command, read, type State, write } from "./state";

const INITIAL: State = {
    profile: PROFILES[0].id,
    values: initial(),
    commands: [],
    compare: true,
    axis: 0,
    language: LANGUAGES[0],
    moment: 0.7,
};
const KNOWN = { profiles: PROFILES.map(({ id }) => id), languages: LANGUAGES, axes: AXES, commands: COMMANDS };

function the<Kind extends HTMLElement = HTMLElement>(id: string): Kind {
    return document.getElementById(id) as Kind;
}

let state = read(location.hash, INITIAL, KNOWN);
let outcome: Outcome = { motions: [], remarks: [] };
/** What is drawn: what is planned, or what is run. */
let motions: Motion[] = [];

const profile = () => PROFILES.find(({ id }) => id === state.profile)!;
const address = () => write(state, fields(profile(), state.values).map(({ key }) => key));
const duration = () => Math.max(0, ...motions.map((motion) => motion.duration));
const lead = () => (profile().axes ? state.axis : 0);
/** The plans in motion. A clock runs the first plan alone. */
const commands = () => (profile().live && !state.values.run ? state.commands : []);

const plots = new Plots(the("plots"), {
    hover: (time) => tell(time ?? state.moment, false),
    click(time, quantity, value) {
        pin(time);
        if (profile().live && !state.values.run && quantity < 2) {
            command(quantity === 0 ? "to" : "jog", value);
        }
    },
});

const player = new Player(the("run"), {
    plan() {
        if (!state.values.run) {
            state.values.run = 1;
            showControls();
        }
        draw();
        return outcome.motions;
    },
    draw(run, time) {
        motions = run;
        plots.show(run, lead(), time);
        mark(time);
    },
    mark,
});

/** Plans and draws. Nothing else runs while a slider is dragged. */
function draw(): void {
    player.stop();
    outcome = profile().plan(state.values, commands(), state.compare);
    motions = outcome.motions;
    if (motions.length > 0) {
        state.moment = Math.min(state.moment, duration());
    }
    plots.show(motions, lead(), state.moment);
    const chosen = motions.find(({ beside }) => !beside);
    the("duration").textContent = chosen ? `${chosen.duration.toFixed(4)} s` : "No motion";
    the("remarks").replaceChildren(
        ...outcome.remarks.map(({ kind, text }) => element("li", { className: kind, textContent: text })),
    );
    mark(state.moment);
    settle();
}

let settling = 0;

/** Writes the address, the code and the words when the state rests. */
function settle(): void {
    clearTimeout(settling);
    settling = setTimeout(() => {
        settling = 0;
        if (location.hash !== address()) {
            location.replace(address());
        }
        the("code").textContent = code(state.language as Language, { ...state, commands: commands() });
        plots.describe();
        the("spoken").textContent = [the("duration").textContent, ...outcome.remarks.map(({ text }) => text)].join(", ");
    }, 150);
}

let waiting = false;

/** Draws at most once per frame of the screen. */
function redraw(): void {
    if (!waiting) {
        waiting = true;
        requestAnimationFrame(() => {
            waiting = false;
            draw();
        });
    }
}

function tell(time: number, pinned: boolean): void {
    plots.tell(time, pinned);
    const [motion] = motions;
    const text = motion ? `at ${time.toFixed(3)} s` : "";
    the("moment-text").textContent = text;
    const values = motion?.state(time).map((value, i) => `${QUANTITIES[i].name} ${number(value)} ${QUANTITIES[i].unit}`);
    the("moment").setAttribute("aria-valuetext", [text, ...(values ?? [])].join(", "));
}

/** Moves the marker. */
function mark(time: number): void {
    const moment = the<HTMLInputElement>("moment");
    moment.max = String(duration());
    moment.value = String(time);
    tell(time, true);
}

function pin(time: number): void {
    state.moment = round(Math.min(Math.max(time, 0), duration()));
    mark(state.moment);
    settle();
}

/** To a thousandth, for the code and the address. */
function round(value: number): number {
    return Math.round(value * 1000) / 1000;
}

/** Plans anew from the moment that is pinned. Later plans are forgotten. */
function command(kind: Command["kind"], target: number): void {
    const before = state.commands.filter(({ time }) => time < state.moment);
    state.commands = [...before.slice(0, COMMANDS - 1), { time: state.moment, kind, target: round(target) }];
    showCommands();
    redraw();
}

const sign = (value: number) => String(value).replace("-", "−");
const WORDS = {
    to: (target: number) => `to ${sign(target)} m`,
    jog: (target: number) => `at ${sign(target)} m/s`,
    stop: () => "stop",
};

function showCommands(): void {
    the("commands").replaceChildren(
        ...state.commands.map(({ time, kind, target }, i) => {
            const text = `${time} s: ${WORDS[kind](target)}`;
            const remove = element("button", { type: "button", textContent: "×", title: "Take back" });
            remove.setAttribute("aria-label", `Take back ${text}`);
            remove.addEventListener("click", () => {
                state.commands = state.commands.slice(0, i);
                showCommands();
                the("retarget").focus();
                redraw();
            });
            return element("li", {}, element("span", { textContent: text }), remove);
        }),
    );
}

/** Shows the controls of the profile. */
function showControls(): void {
    const { id, note, groups, axes, rival, live, runs } = profile();
    the<HTMLSelectElement>("profile").value = id;
    the("note").textContent = note;
    the("axes").hidden = !axes;
    showChoice(the("axes"), AXIS_NAMES, AXIS_NAMES[state.axis], (name) => {
        state.axis = AXIS_NAMES.indexOf(name);
        showControls();
        the("axes").querySelector<HTMLElement>(":checked")!.focus();
        redraw();
    });
    const shown = groups.filter(({ axis, when }) => (axis ?? state.axis) === state.axis && (!when || state.values[when]));
    showFields(the("fields"), shown, state.values, (key, value) => {
        state.values[key] = value;
        if (groups.some(({ when }) => when === key)) {
            showControls();
            the("fields").querySelector<HTMLElement>(`[data-key=${key}]`)!.focus();
        }
        redraw();
    });
    the("compare-row").hidden = !rival;
    the("compare-name").textContent = `Compare with ${rival}`;
    the<HTMLInputElement>("compare").checked = state.compare;
    the("run").hidden = !runs;
    the("replan").hidden = !live || state.values.run === 1;
    const plan = document.querySelector<HTMLElement>(".legend .plan")!;
    plan.hidden = !live && !state.values.run;
    plan.textContent = state.values.run ? "new rate" : "new plan";
    showChoice(the("languages"), LANGUAGES, state.language, (name) => {
        state.language = name;
        settle();
    });
    showCommands();
}

function listen(): void {
    const target = (id: string) => the<HTMLInputElement>(id).valueAsNumber || 0;
    const onClick = (id: string, act: () => void) => the(id).addEventListener("click", act);
    the("profile").addEventListener("change", (event) => {
        state.profile = (event.target as HTMLSelectElement).value;
        showControls();
        redraw();
    });
    the("compare").addEventListener("change", (event) => {
        state.compare = (event.target as HTMLInputElement).checked;
        redraw();
    });
    the("moment").addEventListener("input", (event) => pin((event.target as HTMLInputElement).valueAsNumber));
    onClick("retarget", () => command("to", target("retarget-value")));
    onClick("jog", () => command("jog", target("jog-value")));
    onClick("stop", () => command("stop", 0));
    onClick("csv", save);
    onClick("link", () => copy("link", new URL(address(), location.href).href));
    onClick("copy", () => copy("copy", the("code").textContent!));
    addEventListener("hashchange", () => {
        if (location.hash !== address()) {
            state = read(location.hash, INITIAL, KNOWN);
            showControls();
            redraw();
        }
    });
    the("controls").addEventListener("submit", (event) => event.preventDefault());
}

/** Copies a text, and says so on the button. */
async function copy(id: string, text: string): Promise<void> {
    const button = the(id);
    const name = button.dataset.name ?? button.textContent!;
    button.dataset.name = name;
    const done = await navigator.clipboard.writeText(text).then(() => true, () => false);
    button.textContent = done ? "Copied" : "The browser refuses";
    setTimeout(() => (button.textContent = name), 1500);
}

/** Saves the samples that are drawn. */
function save(): void {
    const heads = motions.flatMap(({ name, quantities }) =>
        QUANTITIES.slice(0, quantities).map((quantity) => `${name} ${quantity.name.toLowerCase()} [${quantity.unit}]`),
    );
    const rows = Array.from(plots.times, (time, k) => [time, ...plots.samples.flat().map((curve) => curve[k])].join(","));
    const text = [["time [s]", ...heads].join(","), ...rows, ""].join("\n");
    const url = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    element("a", { href: url, download: `${state.profile}.csv` }).click();
    setTimeout(() => URL.revokeObjectURL(url));
}

the("profile").append(...PROFILES.map(({ id, name }) => element("option", { value: id, textContent: name })));
showControls();
listen();
draw();

// For the tests, and for a look from the console of the browser.
Object.assign(globalThis, { atraj: { c, plots, isSettled: () => !waiting && settling === 0 } });
