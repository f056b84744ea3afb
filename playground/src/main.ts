// The page: whatever changes the state is planned, drawn and told anew.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { code, type Language, LANGUAGES } from "./code";
import { element, showChoice, showFields } from "./controls";
import { AXES, c, type Motion, POINTS } from "./library";
import { Plane } from "./plane";
import { Player } from "./player";
import { number, Plots, QUANTITIES } from "./plots";
import { AXIS_NAMES, COMMANDS, fields, initial, type Outcome, PROFILES, startOf } from "./profiles";
import { type Command, type Point, read, type State, write } from "./state";
import { table } from "./table";
import { converted, inUnit, isLength, UNITS } from "./units";

const INITIAL: State = {
    profile: PROFILES[0].id,
    unit: UNITS[0],
    values: initial(),
    commands: [],
    points: [[0, 0], [4, 5], [8, 5], [12, 0]],
    compare: true,
    axis: 0,
    language: LANGUAGES[0],
    moment: 0.7,
};
const KNOWN = {
    profiles: PROFILES.map(({ id }) => id),
    units: UNITS,
    languages: LANGUAGES,
    axes: AXES,
    commands: COMMANDS,
    points: POINTS,
};

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
const lead = () => Math.min(state.axis, (profile().axes?.length ?? 1) - 1);
/** Whether a run is drawn, not a plan. */
let showsRun = false;
/** The plans in motion. A run has the first plan alone. */
const commands = () => (profile().live && !showsRun ? state.commands : []);

const plots = new Plots(the("plots"), {
    hover: (time) => tell(time ?? state.moment, false),
    click(time, quantity, value) {
        pin(time);
        if (profile().live && !player.isRunning && quantity < 2) {
            command(quantity === 0 ? "to" : "jog", value);
        }
    },
});

const plane = new Plane(document.querySelector<SVGSVGElement>("#plane")!, {
    move(index, to) {
        state.points[index] = to.map(round) as Point;
        redraw();
    },
    remove,
    resize(zone) {
        state.values.zone = round(zone);
        showControls();
        redraw();
    },
});

const player = new Player(the("run"), {
    plan() {
        draw(true);
        return [outcome.motions, startOf(state.profile, state.values)];
    },
    draw(run, time) {
        motions = run;
        plots.show(run, lead(), time, state.unit);
        mark(time);
    },
    mark,
    tell() {
        the("replan").hidden = !profile().live || player.isRunning;
        settle();
    },
});

/** Plans and draws. Nothing else runs while a slider is dragged. */
function draw(isRun = false): void {
    showsRun = isRun;
    player.stop();
    outcome = profile().plan({ ...state, commands: commands() });
    motions = outcome.motions;
    if (profile().runs && state.values.reserve) {
        outcome.remarks.push({ kind: "note", text: `Planned with ${100 - state.values.reserve} % of each limit.` });
    }
    if (isRun && profile().live && state.commands.length > 0) {
        outcome.remarks.push({ kind: "note", text: "The first plan runs alone." });
    }
    if (motions.length > 0) {
        state.moment = Math.min(state.moment, duration());
    }
    plots.show(motions, lead(), state.moment, state.unit);
    if (profile().points) {
        plane.show(state.points, state.values.zone, plots.samples.map(([position]) => position), state.unit);
    }
    markRefused();
    showLegend();
    the("replan").hidden = !profile().live;
    the<HTMLButtonElement>("add").disabled = state.points.length === POINTS;
    the<HTMLButtonElement>("remove").disabled = state.points.length === 2;
    const chosen = motions.find(({ compared }) => !compared);
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
        const planned = { ...state, commands: commands().slice(0, outcome.refused) };
        the("code").textContent = code(state.language as Language, planned, player.changes);
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
    const values = motion?.state(time).map((value, i) => `${QUANTITIES[i].name} ${number(value)} ${inUnit(QUANTITIES[i].unit, state.unit)}`);
    the("moment").setAttribute("aria-valuetext", [text, ...(values ?? [])].join(", "));
}

/** Moves the marker. */
function mark(time: number): void {
    const moment = the<HTMLInputElement>("moment");
    moment.max = String(duration());
    moment.value = String(time);
    tell(time, true);
    if (profile().points && motions.length > 0) {
        plane.mark(motions.map((motion) => motion.state(time)[0]) as Point);
    }
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
    to: (target: number) => `to ${sign(target)} ${state.unit}`,
    jog: (target: number) => `at ${sign(target)} ${state.unit}/s`,
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

/** Marks the plan in motion that is refused, and what would follow. */
function markRefused(): void {
    [...the("commands").children].forEach((item, i) => item.classList.toggle("bad", i >= (outcome.refused ?? Infinity)));
}

/** Adds a waypoint in the middle of the longest section. */
function add(): void {
    const length = (i: number) => Math.hypot(...state.points[i].map((value, axis) => value - state.points[i + 1][axis]));
    const sections = state.points.slice(1).map((_, i) => i);
    const longest = sections.reduce((most, i) => (length(i) > length(most) ? i : most));
    const middle = state.points[longest].map((value, axis) => round((value + state.points[longest + 1][axis]) / 2)) as Point;
    state.points = state.points.toSpliced(longest + 1, 0, middle);
    draw();
    plane.focus(longest + 1);
}

function remove(index: number): void {
    if (state.points.length > 2) {
        state.points = state.points.toSpliced(index, 1);
        draw();
        plane.focus(Math.min(index, state.points.length - 1));
    }
}

/** Takes another unit of position, and says every length in it. */
function convert(unit: string): void {
    const change = (value: number) => converted(value, state.unit, unit);
    const lengths = new Set(PROFILES.flatMap(({ groups }) => groups.flatMap((group) => group.fields)).filter(({ unit }) => isLength(unit)).map(({ key }) => key));
    lengths.forEach((key) => (state.values[key] = change(state.values[key])));
    state.commands = state.commands.map((command) => ({ ...command, target: change(command.target) }));
    state.points = state.points.map((point) => point.map(change) as Point);
    for (const id of ["retarget-value", "jog-value"]) {
        the<HTMLInputElement>(id).value = String(change(the<HTMLInputElement>(id).valueAsNumber || 0));
    }
    state.unit = unit;
    showControls();
    redraw();
}

/** Shows the controls of the profile. */
function showControls(): void {
    const { id, note, groups, axes, rival, runs, points } = profile();
    the<HTMLSelectElement>("profile").value = id;
    the("note").textContent = note;
    the<HTMLSelectElement>("unit").value = state.unit;
    document.querySelectorAll<HTMLElement>("[data-unit]").forEach((unit) => (unit.textContent = inUnit(unit.dataset.unit!, state.unit)));
    the("axes").hidden = !axes;
    showChoice(the("axes"), axes ?? [], AXIS_NAMES[lead()], (name) => {
        state.axis = AXIS_NAMES.indexOf(name);
        showControls();
        the("axes").querySelector<HTMLElement>(":checked")!.focus();
        redraw();
    });
    const shown = groups.filter(({ axis, when }) => (axis ?? lead()) === lead() && (!when || state.values[when]));
    showFields(the("fields"), shown, state.unit, state.values, (key, value) => {
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
    the("path").hidden = !points;
    showChoice(the("languages"), LANGUAGES, state.language, (name) => {
        state.language = name;
        settle();
    });
    showCommands();
}

/** Says what lines and shading mean, and of which axis they are. */
function showLegend(): void {
    const { axes, marks } = profile();
    const legend = document.querySelector<HTMLElement>(".legend")!;
    const say = (name: string, text: string) => (legend.querySelector(`.${name}`)!.textContent = text);
    const axis = axes && AXIS_NAMES[lead()];
    legend.style.setProperty("--limit", axis ? `var(--curve-${lead()})` : "");
    say("faster", axis ? `${axis} speeds up` : "speeds up");
    say("slower", axis ? `${axis} slows down` : "slows down");
    say("border", axis ? `end of a phase of ${axis}` : "end of a phase");
    say("limit", axis ? `limit of ${axis}` : "limit");
    const mark = showsRun ? "new rate" : marks;
    say("plan", mark ?? "");
    legend.querySelector<HTMLElement>(".plan")!.hidden = !mark;
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
    the("unit").addEventListener("change", (event) => convert((event.target as HTMLSelectElement).value));
    onClick("add", add);
    onClick("remove", () => remove(state.points.length - 1));
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

/** Saves what is drawn as a table. */
function save(): void {
    const step = the<HTMLInputElement>("step");
    const text = table(motions, step.valueAsNumber, state.unit);
    step.setAttribute("aria-invalid", String(text === undefined));
    if (text !== undefined) {
        const url = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
        element("a", { href: url, download: `${state.profile}.csv` }).click();
        setTimeout(() => URL.revokeObjectURL(url));
    }
}

the("unit").append(...UNITS.map((unit) => element("option", { value: unit, textContent: unit })));
the("profile").append(...PROFILES.map(({ id, name }) => element("option", { value: id, textContent: name })));
if (location.pathname.endsWith("/playground.html")) {
    the<HTMLAnchorElement>("guide").href = "index.html"; // of the site
}
showControls();
listen();
draw();

// For the tests, and for a look from the console of the browser.
Object.assign(globalThis, { atraj: { c, plots, isSettled: () => !waiting && settling === 0 } });
