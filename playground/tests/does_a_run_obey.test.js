// Does a motion that runs in real time obey the button and the knob, within the limits of the machine?
import assert from "node:assert/strict";
import { test } from "node:test";
import { onPage, open, OUT } from "./browser.js";

const button = (page, name) => page.locator("#run").getByRole("button", { name, exact: true });
const words = (page) => page.textContent("#run p");
/** The time of the marker, s. */
const marker = async (page) => Number(await page.locator("#moment").inputValue());
/** Positions where the curves of the page end, as the plots have them. */
const ends = (page) => page.evaluate(() => globalThis.atraj.plots.samples.map(([position]) => position.at(-1)));

/** Sets the knob as a drag does: while it moves, and when it is let go. */
function turn(page, percent) {
    return page.locator("#run input").evaluate((knob, value) => {
        knob.value = value;
        knob.dispatchEvent(new Event("input"));
        knob.dispatchEvent(new Event("change"));
    }, String(percent));
}

/** Which part of the drawn limits the curves use at most, of velocity, acceleration and jerk. */
function used(page, limits) {
    return page.evaluate((limits) => {
        const most = (curve) => curve.reduce((highest, value) => Math.max(highest, Math.abs(value)), 0);
        return globalThis.atraj.plots.samples.map((axis, i) => limits[i].map((limit, k) => most(axis[k + 1]) / limit));
    }, limits);
}

const MACHINES = {
    "#profile=move": { limits: [[5, 10, 30]], ends: [10] },
    "#profile=sync": { limits: [[5, 10, 30], [3, 8, 40], [4, 12, 60]], ends: [10, 6, -3] },
    "#profile=path&reserve=20&points=0~0_4~5_8~5_12~2": { limits: [[5, 10, 30], [3, 8, 40]], ends: [12, 2] },
    "#profile=line&reserve=40": { limits: [[5, 10, 30], [3, 8, 40], [4, 12, 60]], ends: [10, 6, -3], isLine: true },
};

for (const [hash, machine] of Object.entries(MACHINES)) {
    onPage(`hold, go on, override at ${hash}`, hash, async (page) => {
        const [duration, address] = [await page.textContent("#duration"), page.url()];
        const typed = await used(page, machine.limits);
        const reserve = Number(hash.match(/reserve=(\d+)/)?.[1] ?? 0) / 100;
        assert.ok(Math.abs(Math.max(...typed.flat()) - (1 - reserve)) < 1e-3, `planned with ${typed} of the limits`);
        await button(page, "Run").click();
        const run = (await used(page, machine.limits)).flat();
        typed.flat().forEach((part, i) => assert.ok(Math.abs(run[i] - part) < 0.01, `${run[i]} of a limit, planned with ${part}`));
        const early = await marker(page);
        await page.waitForTimeout(300);
        const late = await marker(page);
        assert.ok(late - early > 0.15 && late - early < 2, `the marker went from ${early} to ${late} s`);
        const [said, begun] = await button(page, "Hold").evaluate((hold) => {
            hold.click();
            return [document.querySelector("#run p").textContent, document.querySelector("#moment").valueAsNumber];
        });
        const stands = begun + Number(said.match(/^Holds: stands in (\d\.\d+) s\.$/)[1]);
        await page.locator("#run", { hasText: "Holds: the axes stand." }).waitFor();
        assert.ok((await marker(page)) >= stands - 0.003, "it says too early that the axes stand");
        const held = await ends(page);
        const moved = await page.evaluate(() => {
            const { times, samples } = globalThis.atraj.plots;
            return times[samples[0][1].findLastIndex((velocity) => velocity !== 0)];
        });
        assert.ok(Math.abs(moved - stands) < 0.005, `they stand at ${moved} s, not at ${stands} s`);
        await page.waitForTimeout(300);
        assert.deepEqual(await ends(page), held, "an axis moves while it is held");
        assert.deepEqual([await page.textContent("#duration"), page.url()], [duration, address], "the run has another plan");
        assert.ok(Math.abs(held[0]) > 0.01 && Math.abs(held[0] - machine.ends[0]) > 0.01, `${held}`);
        await turn(page, 60);
        assert.deepEqual(await ends(page), held, "the knob moves an axis that is held");
        await button(page, "Go on").click();
        assert.match(await words(page), /^Runs at 60 %\.$/);
        await turn(page, 90);
        await page.screenshot({ path: `${OUT}run-${hash.slice(9, 13)}.png`, fullPage: true });
        await button(page, "Run again").waitFor({ timeout: 15000 });
        assert.match(await words(page), /at its end/);
        (await ends(page)).forEach((end, axis) => assert.ok(Math.abs(end - machine.ends[axis]) < 1e-9, `${end}`));
        for (const part of (await used(page, machine.limits)).flat()) {
            assert.ok(part > 0.05 && part <= 1 + 1e-9, `${part} of a limit`);
        }
        if (machine.isLine) {
            const [x, y] = await page.evaluate(() => globalThis.atraj.plots.samples.map(([position]) => [...position]));
            x.forEach((value, k) => assert.ok(Math.abs(0.6 * value - y[k]) < 1e-9, "the axes leave their line"));
        }
    });
}

// It brakes at once.
onPage("without a reserve the path ends before it stands, and this is said", "#profile=move&jm=2&am=1&v0=4&p1=9", async (page) => {
    const duration = await page.textContent("#duration");
    await button(page, "Run").click();
    await page.waitForTimeout(700);
    await button(page, "Hold").click();
    assert.equal(await words(page), "The path ends before it stands.");
    assert.equal(await page.textContent("#duration"), duration);
});

test("an override is as high as the limits allow, this is said, and the motion goes on until it is stopped", async () => {
    const { page } = await open("#profile=move&reserve=20&jm=2&am=1&p1=20");
    await button(page, "Run").click();
    await turn(page, 150);
    const [, given] = (await words(page)).match(/^150 % is refused: the limits allow (\d+) % until the end\.$/);
    assert.ok(given >= 102 && given <= 107, `${given} %`);
    assert.equal(await page.locator("#run input").inputValue(), given);
    await page.evaluate(() => Object.assign(globalThis.atraj.c, { atraj_group_rate: () => globalThis.atraj.c.unreachable() }));
    await button(page, "Hold").click();
    assert.match(await words(page), /^The hold is refused: .+\. It goes on at \d+ %\.$/);
    await button(page, "Stop").click();
    assert.match(await words(page), /^Stops: stands in \d\.\d+ s\.$/);
    await button(page, "Run again").waitFor();
    assert.equal(await words(page), "The axes stand.");
    assert.ok((await ends(page))[0] < 10);
    await page.context().close();
});

onPage("a new plan ends the run", "#profile=move", async (page) => {
    await button(page, "Run").click();
    await page.locator("[data-key=vm]").fill("2");
    await button(page, "Run").waitFor();
    await page.waitForTimeout(100);
    const early = await marker(page);
    await page.waitForTimeout(200);
    assert.equal(await marker(page), early);
});
