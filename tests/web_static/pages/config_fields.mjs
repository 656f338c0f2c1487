// Draws the form of a shirt's configuration with a page that is made of nothing, prints what it shows, fills it in, and
// prints the configuration. Run by test_config_fields.py with the folder js and a file with the form and what to enter.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

class Element extends EventTarget {
  childNodes = [];
  attributes = {};
  parentNode = null;
  namespaceURI = "http://www.w3.org/1999/xhtml";
  value = "";
  checked = false;
  constructor(tag, data = "") {
    super();
    this.localName = tag;
    this.data = data;
  }
  get children() {
    return this.childNodes.filter(({ localName }) => localName);
  }
  get firstChild() {
    return this.childNodes[0] ?? null;
  }
  get nextSibling() {
    const all = this.parentNode?.childNodes ?? [];
    return all[all.indexOf(this) + 1] ?? null;
  }
  get textContent() {
    return this.data + this.childNodes.map((child) => child.textContent).join("");
  }
  set textContent(text) {
    this.data = text;
  }
  set defaultValue(value) {
    this.value = value;
  }
  append(...children) {
    for (const child of children) this.insertBefore(child, null);
  }
  insertBefore(child, next) {
    child.parentNode?.removeChild(child);
    child.parentNode = this;
    this.childNodes.splice(next ? this.childNodes.indexOf(next) : this.childNodes.length, 0, child);
  }
  removeChild(child) {
    this.childNodes.splice(this.childNodes.indexOf(child), 1);
    child.parentNode = null;
  }
  setAttribute(name, value) {
    this.attributes[name] = value === true ? "" : String(value);
  }
  removeAttribute(name) {
    delete this.attributes[name];
  }
  *all(tag) {
    if (this.localName === tag) yield this;
    for (const child of this.childNodes) yield* child.all(tag);
  }
}
const define = (name, value) => Object.defineProperty(globalThis, name, { value, configurable: true });
define("Node", Element);
define("document", {
  createElement: (tag) => new Element(tag),
  createElementNS: (_namespace, tag) => new Element(tag),
  createTextNode: (text) => new Element("", text),
});

const { form, around, entries } = JSON.parse(readFileSync(process.argv[3], "utf8"));
const { configFields } = await import(pathToFileURL(`${process.argv[2]}/pages/shirt/config_fields.js`));
const { Fragment, h, render, signal } = await import(pathToFileURL(`${process.argv[2]}/preact.js`));
const { sourceWords } = await import(pathToFileURL(`${process.argv[2]}/pages/shirt/source_form.js`));

const { layout, files, keys, found, layouts } = Object.fromEntries(
  Object.entries(around).map(([name, value]) => [name, signal(value)]),
);
const { fields, config } = configFields(form, {
  app: {},
  now: around.now,
  layout,
  files,
  keys,
  found,
  layouts,
});
const page = new Element("form");
render(h(Fragment, {}, fields), page);

const labelled = {};
for (const field of page.all("div")) {
  const [label, input, hint] = field.children;
  if (field.attributes.class === "field") labelled[label.textContent] = { input, hint: hint?.textContent ?? null };
  if (field.attributes.class === "row") labelled[label.textContent] = { input, hint: null };
}
for (const label of page.all("label")) {
  if (label.attributes.class === "switch") labelled[label.textContent] = { input: label.children[0], hint: null };
}
const LIMITS = ["type", "min", "max", "minlength", "maxlength", "required"];
const shown = Object.entries(labelled).map(([label, { input, hint }]) => ({
  label,
  hint,
  limits: Object.fromEntries(
    LIMITS.filter((name) => name in input.attributes).map((name) => [name, input.attributes[name]]),
  ),
  options: [...input.all("option")].map((option) => option.textContent),
  segments: [...input.all("label")].map((segment) => segment.textContent),
}));
const before = await config();
for (const [label, value] of Object.entries(entries)) {
  const { input } = labelled[label];
  if (input.attributes.class === "stepper")
    input.children.at(-1).dispatchEvent(Object.assign(new Event("click"), { detail: 0 })); // the button +
  else {
    if (typeof value === "boolean") input.checked = value;
    else if (typeof value === "object")
      input.files = [{ name: "layout.json", text: async () => JSON.stringify(value) }];
    else input.value = value;
    input.dispatchEvent(new Event("input"));
    input.dispatchEvent(new Event("change"));
  }
}
const after = await config();
console.log(JSON.stringify({ shown, before, after, in_use: sourceWords(after, [{ kind: after.kind, form }]) }));
