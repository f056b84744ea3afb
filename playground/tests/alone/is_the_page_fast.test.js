// Can the page draw 60 times a second, 2,000 points in each curve?
import assert from "node:assert/strict";
import { test } from "node:test";
import { open } from "../browser.js";

const FRAMES = 30;
const ROUNDS = 5;

/** Moves a slider in each frame. The time of a frame is for plan, samples, curves and the words around them, ms. */
async function drag(frames) {
    const slider = document.querySelector("[data-key$=jm]");
    const ask = globalThis.requestAnimationFrame;
    const frame = () => new Promise((resolve) => ask(resolve));
    let redraw;
    globalThis.requestAnimationFrame = (callback) => ((redraw = callback), 0);
    let busy = 0;
    const start = await frame();
    let end = start;
    for (let i = 0; i < frames; i += 1) {
        slider.value = String(20 + (i % 60));
        slider.dispatchEvent(new Event("input"));
        const begun = performance.now();
        redraw();
        // uPlot draws at the end of the task, and reading a pixel waits for the canvas.
        await Promise.resolve();
        for (const canvas of document.querySelectorAll("#plots canvas")) {
            canvas.getContext("2d").getImageData(0, 0, 1, 1);
        }
        busy += performance.now() - begun;
        end = await frame();
    }
    globalThis.requestAnimationFrame = ask;
    return { busy: busy / frames, rate: (1000 * frames) / (end - start) };
}

for (const hash of ["#profile=move&then=0.7~to~-2_1.8~stop~0", "#profile=bell", "#profile=line"]) {
    test(hash, async () => {
        const { page } = await open(hash);
        const { points, curves } = await page.evaluate(() => {
            const { samples } = globalThis.atraj.plots;
            return { points: samples[0][0].length, curves: samples.flat().length };
        });
        assert.equal(points, 2000);
        // Other programs disturb a round. The quietest one tells what the page needs.
        const rounds = [];
        for (let i = 0; i < ROUNDS; i += 1) {
            rounds.push(await page.evaluate(drag, FRAMES));
        }
        const busy = Math.min(...rounds.map((round) => round.busy));
        const rate = Math.max(...rounds.map((round) => round.rate));
        console.log(`${hash}: ${busy.toFixed(1)} ms for ${curves} curves of ${points} points, ${rate.toFixed(0)} frames/s`);
        assert.ok(busy < 1000 / 60, `${busy} ms`);
        await page.context().close();
    });
}
