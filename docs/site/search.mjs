// search.mjs SITE TAGS: adds the functions and structs of the C and C++ reference to the site's search. mdBook knows its own pages only.
import { readFileSync, writeFileSync } from "node:fs";
import { runInThisContext } from "node:vm";

const [, , site, tags] = process.argv;
globalThis.window = { search: {} };
for (const script of ["elasticlunr.min.js", "searchindex.js"]) {
    runInThisContext(readFileSync(`${site}/${script}`, "utf8"));
}
const { search } = window;
const index = elasticlunr.Index.load(search.index);

/** The text of an element in a tag file of doxygen. */
function text(xml, name) {
    const found = xml.match(new RegExp(`<${name}>(.*?)</${name}>`))?.[1] ?? "";
    return found.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, '"').replace(/&amp;/g, "&");
}

/** A title that is the name alone is the best answer to this name. */
function add(title, body, place) {
    const url = `c/${place}`;
    if (!search.doc_urls.includes(url)) {
        const id = String(search.doc_urls.push(url) - 1);
        index.addDoc({ id, title, body, breadcrumbs: `C and C++ reference » ${title}` });
    }
}

for (const [compound, kind] of readFileSync(tags, "utf8").matchAll(/<compound kind="(\w+)".*?<\/compound>/gs)) {
    const [own, ...members] = compound.split("<member ");
    const name = text(own, "name");
    const isType = kind === "struct" || kind === "class";
    if (isType) {
        add(name, `${kind} ${name}`, text(own, "filename"));
    }
    for (const member of members.filter((member) => member.startsWith('kind="function"'))) {
        const title = (isType ? `${name}::` : "") + text(member, "name");
        add(title, `${text(member, "type")} ${title}${text(member, "arglist")}`, `${text(member, "anchorfile")}#${text(member, "anchor")}`);
    }
}
const json = JSON.stringify({ ...search, index }).replace(/[\\']/g, "\\$&");
writeFileSync(`${site}/searchindex.js`, `window.search = Object.assign(window.search, JSON.parse('${json}'));`);
