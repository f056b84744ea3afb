// The controls of the page: sliders with number fields, and choices.
import type { Field, Group } from "./profiles";
import type { Values } from "./state";
import { inUnit, isLength, scale } from "./units";

/** An element with properties and children. */
export function element<Name extends keyof HTMLElementTagNameMap>(
    name: Name,
    properties: Partial<HTMLElementTagNameMap[Name]>,
    ...children: (Node | string)[]
): HTMLElementTagNameMap[Name] {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}

/** A field of lengths in metres, in another unit of position. */
function inLength(field: Field, unit: string): Field {
    const [min, max] = isLength(field.unit) ? [field.min * scale(unit), field.max * scale(unit)] : [field.min, field.max];
    return { ...field, unit: inUnit(field.unit, unit), min, max };
}

/** Shows the fields of the groups in `host`. */
export function showFields(
    host: HTMLElement, groups: Group[], unit: string, values: Values, change: (key: string, value: number) => void,
): void {
    host.replaceChildren(
        ...groups.map(({ title, fields }) =>
            element(
                "fieldset",
                {},
                element("legend", { textContent: title }),
                ...fields.map((field) => (field.unit ? slider(inLength(field, unit), values, title, change) : check(field, values, change))),
            ),
        ),
    );
}

function slider({ key, label, unit, min, max }: Field, values: Values, title: string, change: (key: string, value: number) => void): HTMLElement {
    const id = `field-${key}`;
    const range = element("input", { type: "range", min: String(min), max: String(max), step: String((max - min) / 200) });
    const entry = element("input", { type: "number", id, step: "any" });
    range.value = entry.value = String(values[key]);
    range.setAttribute("aria-label", `${title}: ${label}, ${unit}`);
    range.dataset.key = key;
    range.addEventListener("input", () => {
        entry.value = range.value;
        change(key, range.valueAsNumber);
    });
    entry.addEventListener("input", () => {
        entry.setAttribute("aria-invalid", String(!entry.validity.valid || entry.value === ""));
        if (Number.isFinite(entry.valueAsNumber)) {
            range.value = entry.value;
            change(key, entry.valueAsNumber);
        }
    });
    return element(
        "div",
        { className: "field" },
        element("label", { htmlFor: id, textContent: label }),
        entry,
        element("span", { className: "unit", textContent: unit }),
        range,
    );
}

function check({ key, label }: Field, values: Values, change: (key: string, value: number) => void): HTMLElement {
    const box = element("input", { type: "checkbox", checked: values[key] === 1 });
    box.dataset.key = key;
    box.addEventListener("change", () => change(key, Number(box.checked)));
    return element("label", { className: "check" }, box, element("span", { textContent: label }));
}

/** Shows a choice of one name. */
export function showChoice(host: HTMLElement, names: string[], chosen: string, change: (name: string) => void): void {
    host.replaceChildren(
        ...names.map((name) => {
            const button = element("input", { type: "radio", name: host.id, value: name, checked: name === chosen });
            button.addEventListener("change", () => change(name));
            return element("label", {}, button, element("span", { textContent: name }));
        }),
    );
}
