// Do the programs of the page compile, print the duration that the page shows, and end where its run ends?
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdir, writeFile } from "node:fs/promises";
import { before, test } from "node:test";
import { promisify } from "node:util";
import { open, OUT, ROOT, settled } from "./browser.js";

const run = promisify(execFile);
const CODE = `${OUT}code/`;
const FLAGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", `-I${ROOT}target/dist/include`];
const ARCHIVE = `${ROOT}target/dist/lib/libatraj.a`;
/** `make playground-check` installs the package there. */
const PYTHON = `${ROOT}target/python/venv/bin/python`;
const MANIFEST = `[package]
name = "code"
edition = "2024"

[workspace]

[dependencies]
atraj = { path = "${ROOT}", default-features = false }
`;
const HASHES = {
    bell: "profile=bell&p1=-4&v0=2.5", liba_bell: "profile=liba-bell&jm=12.5",
    trap: "profile=trap&v0=1&p1=-2", liba_trap: "profile=liba-trap&p0=9&p1=-4&de=4",
    poly3: "profile=poly3&ts=3&v0=1", poly5: "profile=poly5&a1=-2", poly7: "profile=poly7&ts=0.125&j1=7",
    move: "profile=move&v0=-1&a1=0.5", backward: "profile=move&backward=1&p1=-8",
    retargeted: "profile=move&then=0.7~to~-2.5_1.1~jog~1.5_1.8~stop~0",
    sync: "profile=sync&y.v0=-1",
    line: "profile=line&least=4&cycle=0.004",
    reserved: "profile=sync&reserve=30",
    path: "profile=path&unit=mm&points=0~0_3~4_3~-1_6~2",
    zones: "profile=path&zone=0.25&points=0~0_3~4_3~-1_6~2",
};
/** These run, are held, go on at 60 % and, if so, are stopped. */
const RUNS = { run_move: "profile=move&v0=1&reserve=20", run_sync: "profile=sync&x.v0=1", run_least: "profile=line&least=3&reserve=10", run_path: "profile=path&zone=0.25&reserve=20", run_stop: "profile=line" };
/** The program for the path prints six setpoints of each section, and each waypoint once. In Python it prints eleven. */
const SETPOINTS = { path: 16, zones: 16 };

const shown = {};

before(async () => {
    await mkdir(`${CODE}src/bin`, { recursive: true });
    await writeFile(`${CODE}Cargo.toml`, MANIFEST);
    for (const [name, hash] of Object.entries({ ...HASHES, ...RUNS })) {
        const { page } = await open(`#${hash}`);
        shown[name] = name in RUNS ? await ran(page, name === "run_stop") : await page.textContent("#duration");
        for (const [language, file] of [["C", `${name}.c`], ["C++", `${name}.cpp`], ["Rust", `src/bin/${name}.rs`], ["Python", `${name}.py`]]) {
            await page.getByRole("radio", { name: language, exact: true }).check();
            await settled(page);
            await writeFile(CODE + file, await page.textContent("#code"));
        }
        await page.context().close();
    }
});

/** The last line that a program of this run prints. */
async function ran(page, stops) {
    const press = (name) => page.locator("#run").getByRole("button", { name, exact: true }).click();
    await press("Run");
    await page.waitForTimeout(400);
    await press("Hold");
    await page.locator("#run", { hasText: "the axes stand" }).waitFor();
    await page.locator("#run input").evaluate((knob) => (knob.value = "60"));
    await press("Go on");
    await page.waitForTimeout(300);
    await (stops && press("Stop"));
    await page.getByRole("button", { name: "Run again" }).waitFor({ timeout: 20000 });
    const [time, ...ends] = await page.evaluate(() => {
        const { times, samples } = globalThis.atraj.plots;
        return [times.at(-1), ...samples.map(([position]) => position.at(-1))].map((value) => value.toFixed(4));
    });
    return `${time} s: ${ends.join(" ")} m`;
}

function told(name, printed, setpoints = SETPOINTS[name] ?? 11) {
    const lines = printed.trim().split("\n");
    if (name in RUNS) {
        assert.equal(lines.at(-1), shown[name]);
        return;
    }
    assert.equal(lines.length, setpoints);
    assert.match(shown[name], /^\d+\.\d{4} s$/);
    const times = lines.map((line) => Number.parseFloat(line));
    times.slice(1).forEach((time, k) => assert.ok(time > times[k], printed));
    assert.equal(lines.at(-1).split(":")[0], shown[name]);
}

for (const [compiler, standard, ending] of [["cc", "c99", "c"], ["c++", "c++98", "cpp"]]) {
    for (const name of Object.keys({ ...HASHES, ...RUNS })) {
        test(`${name}.${ending}`, async () => {
            const program = `${CODE}${name}-${ending}`;
            const source = `${CODE}${name}.${ending}`;
            await run(compiler, [`-std=${standard}`, ...FLAGS, source, ARCHIVE, "-lm", "-o", program]);
            told(name, (await run(program)).stdout);
        });
    }
}

test("all in Rust", async () => {
    const flags = { ...process.env, CARGO_TARGET_DIR: `${CODE}target`, RUSTFLAGS: "-D warnings" };
    await run("cargo", ["build", "--quiet", "--manifest-path", `${CODE}Cargo.toml`], { env: flags });
    for (const name of Object.keys(shown)) {
        told(name, (await run(`${CODE}target/debug/${name}`)).stdout);
    }
});

test("all in Python", async () => {
    for (const name of Object.keys(shown)) {
        told(name, (await run(PYTHON, [`${CODE}${name}.py`])).stdout, 11);
    }
});
