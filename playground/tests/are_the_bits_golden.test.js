// Do liba's functions give the golden bits in the WebAssembly of the page?
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { open, ROOT } from "./browser.js";

const { page } = await open();

async function rows(table) {
    const text = await readFile(`${ROOT}tests/golden/${table}_f64.csv`, "utf8");
    return text.trim().split("\n").slice(1).map((line) => line.split(","));
}

/** Plans and evaluates every golden case in the page: how many values were compared, and which of them differ. */
function replay({ family, plans, evaluations }) {
    const { c } = globalThis.atraj;
    const view = new DataView(new ArrayBuffer(8));
    const real = (hex) => (hex === "nan" ? NaN : (view.setBigUint64(0, BigInt(`0x${hex}`)), view.getFloat64(0)));
    const hex = (value) => (view.setFloat64(0, value), view.getBigUint64(0).toString(16).padStart(16, "0"));
    const differing = [];
    let compared = 0;
    const compare = (place, got, golden) => {
        compared += 1;
        // JavaScript does not keep the bits of a NaN.
        const same = Number.isNaN(real(golden)) ? Number.isNaN(got) : hex(got) === golden;
        same || differing.push(`${place}: ${hex(got)}, golden ${golden}`);
    };
    const place = c.plan_at(0);
    const functions = ["pos", "vel", "acc", "jer"].map((name) => c[`a_traj${family}_${name}`]).filter(Boolean);
    for (const [number, , ...cells] of plans) {
        const duration = c[`a_traj${family}_gen`](place, ...cells.slice(0, 7).map(real));
        compare(`plan ${number}`, duration, cells[7]);
        if (duration > 0) {
            for (const [, x, ...golden] of evaluations.filter(([plan]) => plan === number)) {
                functions.forEach((evaluate, i) => compare(`plan ${number} at ${real(x)}`, evaluate(place, real(x)), golden[i]));
            }
        }
    }
    return { compared, differing };
}

for (const [family, least] of [["bell", 6000], ["trap", 3500]]) {
    test(`a_traj${family}_*`, async () => {
        const [plans, evaluations] = await Promise.all([rows(`${family}_gen`), rows(`${family}_eval`)]);
        const { compared, differing } = await page.evaluate(replay, { family, plans, evaluations });
        assert.deepEqual(differing, []);
        assert.ok(compared > least, `only ${compared} values were compared`);
        console.log(`a_traj${family}_*: ${compared} values, no bit differs`);
    });
}

test("a planted difference is seen", async () => {
    const plans = (await rows("bell_gen")).slice(0, 1);
    plans[0][9] = plans[0][9].replace(/.$/, (digit) => (digit === "0" ? "1" : "0"));
    const { differing } = await page.evaluate(replay, { family: "bell", plans, evaluations: [] });
    assert.equal(differing.length, 1);
});

test("the module imports nothing", async () => {
    const module = new WebAssembly.Module(await readFile(`${ROOT}target/playground/atraj.wasm`));
    assert.deepEqual(WebAssembly.Module.imports(module), []);
    const exported = new Set(WebAssembly.Module.exports(module).map(({ name }) => name));
    const symbols = (await readFile(`${ROOT}tests/symbols.txt`, "utf8")).trim().split("\n");
    assert.ok(symbols.length > 50);
    assert.deepEqual(symbols.filter((name) => !exported.has(name)), []);
});
