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
  undo: "M6 2.5 2.5 6 6 9.5M2.5 6H10a3.7 3.7 0 0 1 0 7.4H7",
  redo: "M10 2.5 13.5 6 10 9.5M13.5 6H6a3.7 3.7 0 0 0 0 7.4H9",
  reset: "M3.4 6.3A5 5 0 1 1 3 9M3 2.3v4h4",
  axis: "M2 13.5 13.5 3M9.5 3h4v4M3 7.5A6 6 0 0 1 7 3.4",
  way: "M2 8h8.5M7 4.5 10.5 8 7 11.5M13.8 3v10",
  difference: "M2.5 2.5h7v7h-7zM6.5 6.5h7v7h-7z",
  snap: "M4 3v5a4 4 0 0 0 8 0V3M2.5 3h3M10.5 3h3M2.5 6h3M10.5 6h3",
  draw: "M2.5 13.5l.8-3.2L11 2.6l2.4 2.4-7.7 7.7zM9.6 4l2.4 2.4",
  polygon: "M8 2 14 6.5 11.5 13.5H4.5L2 6.5z",
  circle: "M13.5 8a5.5 5.5 0 1 1-11 0 5.5 5.5 0 0 1 11 0z",
  add: "M2 13.5 8 6l6 7.5M8 1v5M5.5 3.5h5",
  take: "M2 13.5h12M2 13.5 8 6l6 7.5M5.5 3h5",
  done: "M2.5 8.5 6.5 12.5 13.5 4",
  shortcut: "M8.7 1.8 3.5 9H8L7.3 14.2 12.5 7H8z",
  truth: "M3 8.6 6.3 12 13 4.4M2 14h12",
  save: "M8 2v8M4.5 6.8 8 10.3l3.5-3.5M3 13.5h10",
};
const FILLED = new Set(["first", "back", "play", "pause", "forward", "last"]); // the others are lines

/** @param {keyof typeof ICONS} name */
export function icon(name) {
  return element("svg", { viewBox: "0 0 16 16", class: FILLED.has(name) ? "sv-icon" : "sv-icon sv-stroked", "aria-hidden": "true" }, element("path", { d: ICONS[name] }));
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

/**
 * A button of a toolbar: an icon with a word.
 * @param {keyof typeof ICONS} name
 * @param {string} label
 * @param {() => void} onclick
 * @param {{ pressed?: string | null, keys?: string | null }} [options]
 */
export function toolButton(name, label, onclick, options = {}) {
  const made = button(label, onclick, { ...options, content: element("span", {}, label) });
  made.classList.add("sv-tool");
  made.prepend(icon(name));
  return made;
}

/**
 * A toggle of a toolbar: its checkbox, and the label with an icon and a word that shows whether it is checked.
 * @param {keyof typeof ICONS} name
 * @param {string} label
 * @param {(checked: boolean) => void} onchange
 */
export function toolToggle(name, label, onchange) {
  const box = element("input", { type: "checkbox", onchange: ({ target }) => onchange(target.checked) });
  return { box, toggle: element("label", { class: "sv-tool sv-toggle" }, box, icon(name), element("span", {}, label)) };
}

/**
 * A menu of a toolbar: it closes after a button of it, with Escape, and when the focus leaves it.
 * @param {keyof typeof ICONS} name
 * @param {string} label
 * @param {(Node | string)[]} children
 */
export function toolMenu(name, label, ...children) {
  const summary = element("summary", { class: "sv-tool" }, icon(name), element("span", {}, label));
  const list = element("div", { onclick: ({ target }) => target.closest("button") && menu.removeAttribute("open") }, ...children);
  const menu = element("details", { class: "sv-menu" }, summary, list);
  menu.addEventListener("toggle", () => {
    list.style.translate = "";
    const beyond = list.getBoundingClientRect().right - document.documentElement.clientWidth + 8;
    if (menu.open && beyond > 0) list.style.translate = `${-beyond}px`; // the list stays inside the page
  });
  menu.addEventListener("focusout", ({ relatedTarget }) => {
    if (relatedTarget instanceof Node && !menu.contains(relatedTarget)) menu.removeAttribute("open");
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !menu.open) return;
    event.stopPropagation();
    menu.removeAttribute("open");
    summary.focus();
  });
  return { menu, summary };
}
