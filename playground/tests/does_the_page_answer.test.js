// Does the page answer whoever uses it, by mouse, by keyboard and by address, without a complaint in the console?
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { open, settled, start } from "./browser.js";

let browser, close;

before(async () => ({ browser, close } = await start()));
after(() => close());

/** A test on a page that must not complain. */
function onPage(name, hash, act) {
    test(name, async () => {
        const { page, complaints } = await open(browser, hash);
        await act(page);
        assert.deepEqual(complaints, []);
        await page.context().close();
    });
}

const duration = (page) => page.textContent("#duration");
const remarks = (page) => page.locator("#remarks li").allTextContents();
/** What is drawn: every sample of the first motion. */
const curves = (page) => page.evaluate(() => String(globalThis.atraj.plots.samples[0].map((curve) => [...curve])));
const pixels = (page) => page.locator("#plots canvas").first().evaluate((canvas) => canvas.toDataURL());

/** Clicks into a plot, at fractions of its width and height. */
async function click(page, quantity, x, y) {
    const { width, height } = await page.locator(".u-over").nth(quantity).boundingBox();
    await page.locator(".u-over").nth(quantity).click({ position: { x: x * width, y: y * height } });
    await settled(page);
}

onPage("a drag of a slider changes the curve", "", async (page) => {
    const before = [await duration(page), await curves(page), await pixels(page)];
    const { x, y, width, height } = await page.locator("[data-key=jm]").boundingBox();
    await page.mouse.move(x + 0.3 * width, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + 0.9 * width, y + height / 2, { steps: 5 });
    await page.mouse.up();
    await settled(page);
    const after = [await duration(page), await curves(page), await pixels(page)];
    before.forEach((value, i) => assert.notEqual(value, after[i]));
    assert.ok((await page.locator("#field-jm").inputValue()) > 80);
});

onPage("the arrow keys move a slider, and a number field takes any number", "", async (page) => {
    const before = await duration(page);
    await page.locator("[data-key=vm]").focus();
    await page.keyboard.press("ArrowLeft");
    await settled(page);
    const slower = await duration(page);
    assert.notEqual(slower, before);
    await page.getByLabel("Velocity", { exact: true }).first().fill("2.125");
    await settled(page);
    assert.notEqual(await duration(page), slower);
    assert.match(page.url(), /vm=2\.125/);
});

onPage("a click into the position retargets, without a jump", "#profile=move&p1=10", async (page) => {
    const before = await curves(page);
    await click(page, 0, 0.4, 0.9);
    assert.notEqual(await curves(page), before);
    const [command] = await page.locator("#commands li span").allTextContents();
    assert.match(command, /^1\.\d+ s: to −?\d/);
    const steps = await page.evaluate(() => {
        const { times, samples } = globalThis.atraj.plots;
        const most = (curve) => curve.reduce((step, value, k) => Math.max(step, k && Math.abs(value - curve[k - 1])), 0);
        return samples[0].slice(0, 3).map((curve) => most(curve) / times[1]);
    });
    [5, 10, 30].forEach((limit, i) => assert.ok(steps[i] <= limit * 1.000001, `${steps}`));
    const [, target] = command.match(/to (\S+) m/);
    const reached = await page.evaluate(() => globalThis.atraj.plots.samples[0][0].at(-1));
    assert.ok(Math.abs(reached - Number(target.replace("−", "-"))) < 1e-9);
});

onPage("a click into the velocity jogs, and stop stops", "#profile=move", async (page) => {
    await click(page, 1, 0.5, 0.6);
    await click(page, 3, 0.9, 0.5);
    const final = () => page.evaluate(() => globalThis.atraj.plots.samples[0][1].at(-1));
    assert.match((await page.locator("#commands").textContent()), /at −?\d.* m\/s/);
    assert.ok((await final()) > 0.1);
    await page.getByRole("button", { name: "Stop" }).click();
    await settled(page);
    assert.equal(await final(), 0);
    assert.equal(await page.locator("#commands li").count(), 2);
    await page.getByRole("button", { name: /^Take back/ }).first().click();
    assert.equal(await page.locator("#commands li").count(), 0);
});

onPage("the keyboard alone retargets", "#profile=move", async (page) => {
    await page.getByRole("slider", { name: "Time" }).focus();
    await page.keyboard.press("ArrowRight");
    const spoken = await page.getByRole("slider", { name: "Time" }).getAttribute("aria-valuetext");
    assert.match(spoken, /s, Position .* m, Velocity .* m\/s, Acceleration .*, Jerk /);
    await page.getByRole("button", { name: "Retarget to" }).focus();
    await page.keyboard.press("Enter");
    await settled(page);
    assert.equal(await page.locator("#commands li").count(), 1);
    assert.match(await page.textContent("#spoken"), / s, .*keeps every limit/);
});

onPage("values follow the pointer", "#profile=bell&compare=no", async (page) => {
    const value = () => page.locator(".values").first().textContent();
    await page.locator(".u-over").first().hover({ position: { x: 5, y: 20 } });
    const early = await value();
    await page.locator(".u-over").first().hover({ position: { x: 400, y: 20 } });
    assert.ok(Number(await value()) > Number(early));
});

onPage("a start outside the limits is no clean move", "#profile=move&v0=9", async (page) => {
    assert.deepEqual((await remarks(page)).filter((text) => !/between its ends/.test(text)), [
        "atraj: the move starts outside its limits, or is bound to leave them.",
    ]);
});

for (const [hash, words] of [
    ["#profile=move&vm=0", [/^atraj refuses: a limit is 0/]],
    ["#profile=move&v1=9", [/^atraj refuses: the target is outside the limits/]],
    ["#profile=bell&p1=0.2&v0=3", [/^atraj keeps every limit/, /leaves the positions/, /^liba refuses: liba finds no such move/]],
    ["#profile=liba-bell&p1=0.2&v0=3", [/^liba refuses/, /^atraj keeps every limit/]],
    ["#profile=liba-trap&v0=4&p1=0.5", [/^liba .*ends at 2\.4495 m\/s, not at 0/, /^atraj keeps every limit/]],
    ["#profile=trap&ac=0", [/^atraj refuses/, /^liba /]],
    ["#profile=bell&p0=3&p1=3", [/^atraj: there is nothing to do/]],
    ["#profile=poly5&ts=0", [/no such polynomial/]],
    ["#profile=sync&cycle=-1", [/^atraj refuses: the duration or the cycle/]],
    ["#profile=line&x.v0=1", [/^atraj refuses: the states do not lie/]],
]) {
    onPage(`words at ${hash}`, hash, async (page) => {
        const said = await remarks(page);
        words.forEach((word) => assert.ok(said.some((text) => word.test(text)), `${word} in ${said}`));
        if (words[0].source.includes("refuses") || words[0].source.includes("no such")) {
            assert.equal(await duration(page), "No motion");
        }
    });
}

onPage("several axes end together, on a line", "#profile=line", async (page) => {
    const ratios = await page.evaluate(() => {
        const [x, y] = globalThis.atraj.plots.samples.map(([position]) => position);
        return [...x].map((value, k) => Math.abs(value * 0.6 - y[k]));
    });
    assert.ok(Math.max(...ratios) < 1e-9);
    await page.getByRole("radio", { name: "Y" }).check();
    assert.ok(await page.getByText("Limits of Y").isVisible());
});

for (const hash of [
    "#profile=trap&ac=7&de=3.5&compare=no",
    "#profile=move&backward=1&vn=1.5&then=0.5~to~-3_1.25~jog~1_2~stop~0",
    "#profile=sync&y.p1=4",
]) {
    onPage(`the address ${hash} comes back`, hash, async (page) => {
        const [address, shown] = [new URL(page.url()).hash, [await duration(page), await curves(page)]];
        const { page: again, complaints } = await open(browser, address);
        assert.equal(new URL(again.url()).hash, address);
        assert.deepEqual([await duration(again), await curves(again)], shown);
        assert.deepEqual(complaints, []);
        for (const word of hash.slice(1).split("&").filter((word) => !word.includes("~"))) {
            assert.ok(address.includes(word), `${word} in ${address}`);
        }
        await page.evaluate(() => (location.hash = "#profile=poly7&ts=2"));
        await page.locator("#duration", { hasText: "2.0000 s" }).waitFor();
    });
}

onPage("a wrong address gives the page as it begins", "#profile=x&vm=fast&then=1~fly~2&axis=9&moment=Infinity", async (page) => {
    const { page: fresh } = await open(browser);
    assert.equal(await duration(page), await duration(fresh));
});

onPage("the table holds what is drawn", "#profile=bell", async (page) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save CSV" }).click()]);
    const lines = (await readFile(await download.path(), "utf8")).trim().split("\n");
    assert.equal(lines.length, 2001);
    assert.match(lines[0], /^time \[s\],atraj position \[m\],.*,liba jerk \[m\/s³\]$/);
    assert.match(lines.at(-1), /^2\.8333333333333\d*,10,/);
});

onPage("every control has a name", "#profile=move&backward=1&then=0.5~stop~0", async (page) => {
    const session = await page.context().newCDPSession(page);
    const { nodes } = await session.send("Accessibility.getFullAXTree");
    const focusable = nodes.filter(({ properties }) => properties?.some(({ name, value }) => name === "focusable" && value.value));
    const nameless = focusable.filter(({ role, name }) => role.value !== "RootWebArea" && !name?.value);
    assert.ok(focusable.length > 30);
    assert.deepEqual(nameless.map(({ role }) => role.value), []);
    const pictures = nodes.filter(({ role }) => role?.value === "image").map(({ name }) => name.value);
    assert.match(pictures[0], /^Position over time: atraj from 0\.0000 to /);
});
