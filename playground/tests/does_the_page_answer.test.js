// Does the page answer whoever uses it, by mouse, by keyboard and by address, without a complaint in the console?
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { onPage, open, settled } from "./browser.js";

const duration = (page) => page.textContent("#duration");
const remarks = (page) => page.locator("#remarks li").allTextContents();
/** What is drawn: every sample of the first motion. */
const curves = (page) => page.evaluate(() => String(globalThis.atraj.plots.samples[0].map((curve) => [...curve])));
const pixels = (page) => page.locator("#plots canvas").first().evaluate((canvas) => canvas.toDataURL());

/** Moves the mouse from one point to another with its button down. */
async function drag(page, from, to, steps) {
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...to, { steps });
    await page.mouse.up();
    await settled(page);
}

/** Lines of the table that the page saves. */
async function table(page) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save CSV" }).click()]);
    return (await readFile(await download.path(), "utf8")).trim().split("\n");
}

/** Clicks into a plot, at fractions of its width and height. */
async function click(page, quantity, x, y) {
    const { width, height } = await page.locator(".u-over").nth(quantity).boundingBox();
    await page.locator(".u-over").nth(quantity).click({ position: { x: x * width, y: y * height } });
    await settled(page);
}

onPage("a drag of a slider changes the curve", "", async (page) => {
    const before = [await duration(page), await curves(page), await pixels(page)];
    const { x, y, width, height } = await page.locator("[data-key=jm]").boundingBox();
    await drag(page, [x + 0.3 * width, y + height / 2], [x + 0.9 * width, y + height / 2], 5);
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
        "atraj: the move starts outside its limits, or will unavoidably exceed them.",
    ]);
});

for (const [hash, words] of [
    ["#profile=move&vm=0", [/^atraj refuses: a limit is 0/]],
    ["#profile=move&v1=9", [/^atraj refuses: the target is outside the limits/]],
    ["#profile=bell&p1=0.2&v0=3", [/^atraj keeps every limit/, /leaves the positions/, /^liba refuses: liba finds no such move/]],
    ["#profile=liba-bell&p1=0.2&v0=3", [/^liba refuses/, /^atraj keeps every limit/]],
    ["#profile=liba-trap&v0=4&p1=0.5", [/^liba .*ends with the velocity 2\.4495, not with 0/, /^atraj keeps every limit/]],
    ["#profile=trap&ac=0", [/^atraj refuses/, /^liba /]],
    ["#profile=bell&p0=3&p1=3", [/^atraj: there is nothing to do/]],
    ["#profile=poly5&ts=0", [/no such polynomial/]],
    ["#profile=sync&cycle=-1", [/^atraj refuses: a duration, cycle/]],
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
    await page.getByRole("radio", { name: "Y", exact: true }).check();
    assert.ok(await page.getByText("Limits of Y").isVisible());
});

for (const hash of [
    "#profile=trap&ac=7&de=3.5&compare=no",
    "#profile=move&backward=1&vn=1.5&then=0.5~to~-3_1.25~jog~1_2~stop~0",
    "#profile=sync&y.p1=4",
    "#profile=path&unit=rad&points=0%7E0_1%7E2.5_-3%7E1",
]) {
    onPage(`the address ${hash} comes back`, hash, async (page) => {
        const [address, shown] = [new URL(page.url()).hash, [await duration(page), await curves(page)]];
        const { page: again, complaints } = await open(address);
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
    const { page: fresh } = await open();
    assert.equal(await duration(page), await duration(fresh));
});

onPage("the table holds what is drawn", "#profile=bell", async (page) => {
    const lines = await table(page);
    assert.equal(lines.length, 1 + 2834 + 1); // a row each millisecond, and the end
    assert.match(lines[0], /^time \[s\],atraj position \[m\],.*,liba jerk \[m\/s³\]$/);
    assert.match(lines[2], /^0\.001,/);
    assert.match(lines.at(-1), /^2\.8333333333333\d*,10,/);
});

onPage("the table has a row every step, and none without a step", "#profile=bell&compare=no&unit=mm", async (page) => {
    await page.locator("#step").fill("0.5");
    const lines = await table(page);
    assert.deepEqual(lines.slice(1, -1).map((line) => Number.parseFloat(line)), [0, 0.5, 1, 1.5, 2, 2.5]);
    assert.match(lines[0], /velocity \[mm\/s\]/);
    await page.locator("#step").fill("0");
    await page.getByRole("button", { name: "Save CSV" }).click();
    assert.equal(await page.locator("#step").getAttribute("aria-invalid"), "true");
});

onPage("limits and shading say of which axis they are, in its colour", "#profile=sync&axis=1", async (page) => {
    const legend = () => page.locator(".legend").textContent();
    assert.match(await legend(), /Y speeds up\s+Y slows down\s+end of a phase of Y\s+limit of Y/);
    const color = () => page.locator(".legend .limit").evaluate((item) => getComputedStyle(item, "::before").borderTopColor);
    const value = (i) => page.locator(".value").nth(i).evaluate((item) => getComputedStyle(item).color);
    assert.equal(await color(), await value(1));
    await page.getByRole("radio", { name: "Z" }).check();
    assert.match(await legend(), /limit of Z/);
    assert.equal(await color(), await value(2));
    // The lowest and the highest velocity of Z are dashed lines of this colour.
    const levels = await page.locator("#plots canvas").nth(1).evaluate((canvas, wanted) => {
        const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        const is = (x, y) => wanted.every((part, i) => Math.abs(data[4 * (y * width + x) + i] - part) < 4);
        const count = (y) => Array.from({ length: width }, (_, x) => x).filter((x) => is(x, y)).length;
        return Array.from({ length: height }, (_, y) => y).filter((y) => count(y) > 0.5 * (width - 60)).length;
    }, (await value(2)).match(/\d+/g).map(Number));
    assert.equal(levels, 2);
});

onPage("a unit of position converts every length, and no time", "#profile=move&then=0.7~to~-2&p0=0.123456789", async (page) => {
    const [time, before] = [await duration(page), await curves(page)];
    await page.getByLabel("Unit of position").selectOption("mm");
    await settled(page);
    assert.equal(await duration(page), time);
    assert.equal(await page.locator("#field-vm").inputValue(), "5000");
    assert.match(await page.locator(".caption").nth(2).textContent(), /mm\/s²/);
    assert.match(await page.locator("#commands").textContent(), /0\.7 s: to −2000 mm/);
    assert.match(await page.textContent("#code"), /%\.4f mm/);
    await page.getByLabel("Unit of position").selectOption("steps");
    await page.getByLabel("Unit of position").selectOption("m");
    await settled(page);
    assert.equal(await curves(page), before);
    assert.match(page.url(), /p0=0\.123456789&/);
});

onPage("a plan in motion that is refused is named", "#profile=move&then=0.5~to~3_0.7~jog~9_1~stop~0", async (page) => {
    const [bad] = (await remarks(page)).filter((text) => text.includes("refuses"));
    assert.match(bad, /^atraj refuses the plan at 0\.7 s: the target is outside the limits/);
    assert.deepEqual(await page.locator("#commands .bad span").allTextContents(), ["0.7 s: at 9 m/s", "1 s: stop"]);
    assert.ok(!(await page.textContent("#code")).includes("9"), "the program has the plan that is refused");
});

onPage("on a narrow screen the plots stay in sight while a limit is dragged", "#profile=move", async (page) => {
    for (const key of ["vm", "jm", "a1"]) {
        const slider = page.locator(`[data-key=${key}]`);
        await slider.evaluate((range) => range.scrollIntoView({ block: "center" }));
        const [plots, range] = [await page.locator("#plots").boundingBox(), await slider.boundingBox()];
        assert.ok(plots.y >= 0 && plots.y + plots.height < range.y && range.y < 844, `${key}: ${JSON.stringify([plots, range])}`);
        const right = await page.locator("#plots canvas").first().evaluate((canvas) => canvas.getBoundingClientRect().right);
        assert.ok(right <= 390, `the plots end at ${right}`);
    }
}, { viewport: { width: 390, height: 844 } });

const positions = (page) => page.evaluate(() => globalThis.atraj.plots.samples.map(([position]) => [...position]));
const passes = ([xs, ys], [x, y]) => xs.some((value, k) => Math.hypot(value - x, ys[k] - y) < 0.02);

onPage("a waypoint is dragged by the mouse", "#profile=path", async (page) => {
    const { x, y, width } = await page.getByRole("slider", { name: "Waypoint 2" }).boundingBox();
    const before = await duration(page);
    await drag(page, [x + width / 2, y + width / 2], [x - 60, y + 90], 4);
    assert.notEqual(await duration(page), before);
    const [, px, py] = page.url().match(/points=0%7E0_([-.\d]+)%7E([-.\d]+)_8%7E5_12%7E0/);
    assert.ok(px < 4 && py < 5, `${px} ${py}`);
    assert.ok(passes(await positions(page), [px, py]));
    const box = await page.getByRole("slider", { name: "Waypoint 2" }).boundingBox();
    assert.ok(box.x < x && box.y > y - 40);
});

onPage("a zone is dragged around its waypoint, and the path gets shorter", "#profile=path&zone=0.5", async (page) => {
    const before = Number.parseFloat(await duration(page));
    const zone = await page.locator("#plane .zone").first().boundingBox();
    await drag(page, [zone.x + 2, zone.y + 2], [zone.x - 20, zone.y - 10], 4);
    const size = Number(page.url().match(/zone=([.\d]+)/)[1]);
    assert.ok(size > 0.5, `${size}`);
    assert.ok(Number.parseFloat(await duration(page)) < before);
    const [xs, ys] = await positions(page);
    for (const point of [[4, 5], [8, 5]]) {
        const isInside = (value, k) => Math.abs(value - point[0]) < size + 0.05 && Math.abs(ys[k] - point[1]) < size + 0.05;
        assert.ok(xs.some(isInside), `${point}`);
    }
});

onPage("the keyboard alone moves, adds and removes a waypoint", "#profile=path", async (page) => {
    const point = page.getByRole("slider", { name: "Waypoint 3" });
    await point.focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowDown");
    await settled(page);
    assert.equal(await point.getAttribute("aria-valuetext"), "x 8.1000 m, y 4.9000 m");
    assert.ok(passes(await positions(page), [8.1, 4.9]));
    await page.getByRole("button", { name: "Add a point" }).press("Enter");
    await settled(page);
    assert.equal(await page.getByRole("slider", { name: /^Waypoint/ }).count(), 5);
    await page.keyboard.press("Delete");
    await page.keyboard.press("Delete");
    await settled(page);
    assert.equal(await page.getByRole("slider", { name: /^Waypoint/ }).count(), 3);
    for (const [name, count] of [["Remove the last", 2], ["Add a point", 9]]) {
        const button = page.getByRole("button", { name });
        while (await button.isEnabled()) {
            await button.click();
        }
        assert.equal(await page.getByRole("slider", { name: /^Waypoint/ }).count(), count);
    }
});

onPage("the plane has one scale", "#profile=path&points=0~0_10~10", async (page) => {
    const centers = await page.locator("#plane .point").evaluateAll((points) => points.map((point) => point.getBoundingClientRect()));
    assert.ok(Math.abs(centers[1].x - centers[0].x - (centers[0].y - centers[1].y)) < 0.5);
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
