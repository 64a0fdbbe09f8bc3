// Helpers that make elements of the page: any element, an icon, a button.

export const SVG = "http://www.w3.org/2000/svg";

const SVG_TAGS = new Set(["svg", "g", "path", "circle", "rect", "text", "tspan"]);

/** @typedef {HTMLElementTagNameMap & Pick<SVGElementTagNameMap, "svg" | "g" | "path" | "circle" | "rect" | "text" | "tspan">} Tags */
/** @typedef {string | number | boolean | null | ((event: any) => void)} Attribute */

/**
 * An `on...` attribute is a listener, `true` an attribute without a value; null and false set nothing.
 * @template {keyof Tags} T
 * @param {T} tag
 * @param {Record<string, Attribute>} [attributes]
 * @param {(Node | string)[]} children
 * @returns {Tags[T]}
 */
export function element(tag, attributes = {}, ...children) {
  const made = SVG_TAGS.has(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (value !== null && value !== false) made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...children);
  return /** @type {any} */ (made);
}

const ICONS = {
  first: "M3 3h2v10H3zM13 3v10L6 8z",
  back: "M11 3v10L4 8z",
  play: "M4 3v10l9-5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  forward: "M5 3v10l7-5z",
  last: "M3 3v10l7-5zM11 3h2v10h-2z",
  turn: "M12.7 9.7A5 5 0 1 1 11.7 4.6M12.2 1.4V5.2H8.4",
};

/** @param {keyof typeof ICONS} name */
export function icon(name) {
  return element("svg", { viewBox: "0 0 16 16", class: "sv-icon", "aria-hidden": "true" }, element("path", { d: ICONS[name] }));
}

/**
 * `content` is what the button shows where that is not its label.
 * @param {string} label
 * @param {() => void} onclick
 * @param {{ content?: Node | string, pressed?: string | null, keys?: string | null }} [options]
 */
export function button(label, onclick, { content, pressed = null, keys = null } = {}) {
  const attributes = { type: "button", "aria-label": label, title: label, onclick: () => onclick(), "aria-pressed": pressed, "aria-keyshortcuts": keys };
  return element("button", attributes, content ?? label);
}
