// Writes the page as one file: node build.js FILE
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const [, , file] = process.argv;
const { outputFiles } = await build({
    entryPoints: ["src/main.ts"],
    bundle: true,
    minify: true,
    write: false,
    outdir: ".",
    format: "esm",
    target: "es2022",
    loader: { ".wasm": "binary" },
});
const output = (ending) => outputFiles.find(({ path }) => path.endsWith(ending)).text;
const script = output(".js").replaceAll("</script", "<\\/script");
const page = (await readFile("src/index.html", "utf8"))
    .replace("/* style */", () => output(".css"))
    .replace("/* script */", () => script);
await writeFile(file, page);
console.log(`${file}: ${Math.round(page.length / 1000)} kB`);
