// Does a border between phases stand where the motion changes, and nowhere else?
import assert from "node:assert/strict";
import { onPage } from "./browser.js";

// Moves with a cruise: at a peak the jerk stays as it is.
for (const [hash, count] of [
    ["#profile=trap&p1=10&ac=10&de=5", 2],
    ["#profile=liba-trap&p1=10&ac=10&de=5", 2],
    ["#profile=bell&p1=10", 6],
    ["#profile=liba-bell&p1=10", 6],
    ["#profile=move&p1=10", 6],
]) {
    onPage(`at ${hash}`, hash, async (page) => {
        const { borders, times, samples } = await page.evaluate(() => {
            const { borders, times, samples } = globalThis.atraj.plots;
            // The highest quantity is constant in each phase.
            return { borders, times: [...times], samples: [...samples[0].at(-1)] };
        });
        const end = times.at(-1);
        const inner = borders.filter((time) => time > 0 && time < end);
        const changes = times.flatMap((time, k) => (k > 1 && time < end && samples[k] !== samples[k - 1] ? [[times[k - 1], time]] : []));
        const holds = ([from, to], time) => from <= time && time <= to;
        assert.equal(inner.length, count, `${borders}`);
        assert.equal(changes.length, count, `${changes}`);
        inner.forEach((time) => assert.ok(changes.some((change) => holds(change, time)), `nothing changes at ${time}: ${changes}`));
    });
}
