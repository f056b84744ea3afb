// Does axe-core find a serious fault in the page, on any profile, wide or narrow, light or dark?
import assert from "node:assert/strict";
import { faults, onPage } from "./browser.js";

for (const hash of ["#profile=move&backward=1", "#profile=move&then=0.5~stop~0_0.7~jog~9", "#profile=bell", "#profile=line&axis=1", "#profile=path"]) {
    for (const [name, options] of [["wide", {}], ["narrow and dark", { viewport: { width: 390, height: 844 }, colorScheme: "dark" }]]) {
        onPage(`${hash}, ${name}`, hash, async (page) => assert.deepEqual(await faults(page), []), options);
    }
}

onPage("a planted fault is seen", "", async (page) => {
    await page.evaluate(() => document.querySelector("#profile").closest("label").replaceWith(document.querySelector("#profile")));
    assert.deepEqual(await faults(page), ["select-name at #profile"]);
});
