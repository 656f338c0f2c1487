/**
 * Elements by function call: the nesting of the calls is that of the elements.
 * Text is inserted as text: nothing here parses HTML.
 * @import { Attributes, Child } from "types/dom"
 */

const SVG = "http://www.w3.org/2000/svg";

/**
 * Make an HTML element. `on*` attributes are listeners, `true` sets an empty attribute, false and null leave it out.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...Child} children
 */
export function h(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/**
 * Make an SVG element.
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag @param {Attributes} [attributes] @param {...Child} children
 * @returns {SVGElementTagNameMap[Tag]}
 */
export function s(tag, attributes = {}, ...children) {
  const element = /** @type {SVGElementTagNameMap[Tag]} */ (document.createElementNS(SVG, tag));
  return fill(element, attributes, children);
}

/**
 * Replace everything inside an element.
 * @template {Element} E @param {E} element @param {...Child} children
 */
export function put(element, ...children) {
  element.replaceChildren(...nodes(children));
  return element;
}

/**
 * Set attributes of an element; `on*` adds a listener. A state of `aria-*` that is false is written as "false": without
 * the attribute, a screen reader would take the element for one that has no such state.
 * @template {Element} E @param {E} element @param {Attributes} attributes
 */
export function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on") && typeof value === "function") {
      element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    } else if (name.startsWith("aria-") && typeof value === "boolean") element.setAttribute(name, String(value));
    else if (value === false || value === null || value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  return element;
}

/** Write a text only when it differs: a live region would read it out again. @param {Element} element @param {string} words */
export function write(element, words) {
  if (element.textContent !== words) element.textContent = words;
}

/**
 * Call `close` when Escape is pressed in a question, in place of what it called before; null: nothing any more. The
 * listener answers nothing: an answer of false would hold Tab back.
 * @param {HTMLElement} question @param {(() => void) | null} close
 */
export function onEscape(question, close) {
  question.onkeydown = close && (({ key }) => void (key === "Escape" && close()));
}

/** @template {Element} E @param {E} element @param {Attributes} attributes @param {Child[]} children */
function fill(element, attributes, children) {
  set(element, attributes);
  element.append(...nodes(children));
  return element;
}

/** The nodes of children, flat. @param {Child[]} children @returns {Node[]} */
function nodes(children) {
  return children.flatMap((child) => {
    if (Array.isArray(child)) return nodes(child);
    if (child === null || child === undefined || child === false) return [];
    return child instanceof Node ? child : document.createTextNode(String(child));
  });
}
