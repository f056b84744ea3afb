// Is the site whole: a page for each document and each example, all in the table of contents, both references, the playground, no dead
// link, and a search that finds each function? `make doc` writes the site.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { basename, dirname, join, relative } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { browser, ROOT } from "./browser.js";

const SITE = join(ROOT, "target/site");
const read = (path) => readFileSync(path, "utf8");
const named = (folder, ending) => readdirSync(join(ROOT, folder)).filter((name) => name.endsWith(ending)).map((name) => join(folder, name));
const DOCUMENTS = [...named("docs", ".md"), ...named("examples", ".c"), "README.md", "examples/README.md"];
const PAGES = DOCUMENTS.map((name) => join(SITE, name.replace(/\.\w+$/, ".html")));

/** What a page refers to on this site. */
const links = (page) => [...read(page).matchAll(/(?:href|src)="([^"]*)"/g)].map(([, link]) => link).filter((link) => !link.includes("://"));

test("every page is in the table of contents", () => {
    const listed = links(join(SITE, "toc.html"));
    for (const page of PAGES) {
        assert.ok(existsSync(page), page);
        assert.ok(listed.includes(relative(SITE, page)), page);
    }
    const references = links(join(SITE, "docs/site/references.html"));
    for (const name of ["c/index.html", "rust/atraj/index.html", "python/atraj.html", "playground.html"]) {
        assert.ok(references.includes(`../../${name}`), name);
    }
});

test("no link is dead", () => {
    let followed = 0;
    for (const page of PAGES) {
        for (const link of links(page)) {
            const [file, place] = link.split("#");
            const target = file ? join(dirname(page), decodeURI(file)) : page;
            const leads = existsSync(target) && statSync(target).isFile() && (!place || read(target).includes(`id="${place}"`));
            assert.ok(leads, `${relative(SITE, page)} leads to ${link}`);
            followed += 1;
        }
    }
    assert.ok(followed > 100, `${followed}`);
});

test("the C reference says what to include", () => {
    const text = (page) => read(join(SITE, "c", page)).replace(/<[^>]*>/g, "");
    const first = read(join(SITE, "c/index.html"));
    assert.ok(first.includes("atraj_move_plan"));
    for (const header of ["a/trajbell.h", ...readdirSync(join(ROOT, "include/atraj")).map((name) => `atraj/${name}`)]) {
        assert.ok(first.includes(`"${header}"`), `the first page lacks ${header}`);
    }
    assert.ok(first.includes('href="../index.html"'), "no way back to the guide");
    const reference = text("trajbell_8h.html");
    assert.ok(reference.includes("a_trajbell_gen") && !reference.includes("A_EXTERN"));
    for (const [page, include] of [
        ["structa__trajbell.html", "a/trajbell.h"],
        ["structclaraty__trapezoid.html", "claraty/trapezoid.h"],
        ["classclaraty_1_1Trapezoidal__Trajectory.html", "claraty/trapezoidal_trajectory.h"],
    ]) {
        assert.ok(text(page).includes(`#include &lt;${include}&gt;`), page);
    }
});

test("the search finds a function before the pages that name it", async () => {
    const page = await browser.newPage();
    for (const name of ["atraj_move_plan", "atraj_path_plan", "a_trajbell_gen", "claraty_trapezoid_stop", "atraj_group"]) {
        await page.goto(`${pathToFileURL(join(SITE, "docs/moves.html"))}?search=${name}`);
        await page.locator("#searchresults a").first().click();
        const [, place] = page.url().split("#");
        const found = place ? page.locator(`#${place} + .memtitle`) : page.locator(".title");
        assert.match(await found.textContent(), new RegExp(`\\b${name}\\b`), page.url());
    }
    await page.close();
});

// A table begins with the link to its file, and has a row for each line.
test("every table is drawn", () => {
    const all = PAGES.map(read).join("");
    for (const table of named("docs/data", ".csv")) {
        const link = `<p><a href="data/${basename(table)}"`;
        assert.ok(all.includes(link), `no page draws ${table}`);
        const drawn = all.split(link)[1].split("</table>")[0];
        assert.equal(drawn.split("<tr>").length, read(join(ROOT, table)).split("\n").length, table);
    }
});
