// Does the page fit a wide and a narrow screen, light and dark? The pictures in target/playground are for the eye;
// readme.png is docs/img/playground.png.
import assert from "node:assert/strict";
import { onPage, OUT } from "./browser.js";

const RETARGETED = "#profile=move&then=0.7~to~-2_1.8~stop~0&moment=1.2";
const NARROW = { viewport: { width: 390, height: 844 } };
const PICTURES = {
    readme: [RETARGETED, { viewport: { width: 1120, height: 1036 } }, false],
    light: [RETARGETED],
    dark: [`${RETARGETED}&language=Rust`, { colorScheme: "dark" }],
    narrow: [RETARGETED, NARROW],
    "narrow-dark": ["#profile=bell&v0=3&p1=1", { ...NARROW, colorScheme: "dark" }],
    compared: ["#profile=bell&v0=3&p1=1&moment=0.2"],
    "liba-trapezoid": ["#profile=liba-trap&v0=4&p1=0.5"],
    line: ["#profile=line"],
    step: ["#profile=sync&axis=1", { colorScheme: "dark" }],
    septic: ["#profile=poly7"],
    path: ["#profile=path"],
    "path-narrow": ["#profile=path&unit=deg", { ...NARROW, colorScheme: "dark" }],
    refused: ["#profile=move&vm=0"],
};

for (const [name, [hash, options, fullPage = true]] of Object.entries(PICTURES)) {
    onPage(name, hash, async (page) => {
        await page.screenshot({ path: `${OUT}${name}.png`, fullPage });
        const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        assert.equal(content, window, "the page is wider than the window");
        const small = await page.evaluate(() => {
            const boxes = [...document.querySelectorAll("button, select, input")].filter((control) => control.checkVisibility());
            return boxes.filter((control) => control.getBoundingClientRect().height < 12).map(({ id }) => id);
        });
        assert.deepEqual(small, []);
    }, options);
}
