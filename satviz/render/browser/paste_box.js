// The paste box: shapes as text go to Python, which replies with the readings, the relation, its reason, and forms to copy or save.
// What comes back is shown as text, and the box keeps what was pasted.

import { PAGE_FORMATS, savePictures } from "./download.js";
import { button, element } from "./elements.js";
import { Pen } from "./pen.js";
import { copyText, sceneLink } from "./save_menu.js";

/** @import { Explorer } from "./explorer.js" */
/** @import { Listener, Pasted, PastedFinding, PastedPair, PastedQuestion, PastedShape } from "./messages.js" */

const PLACEHOLDER = "POLYGON((0 0, 4 0, 4 4, 0 4))\nnew Circle(new Vector(5, 2), 1)";

export class PasteBox {
  /** @param {Explorer} explorer */
  constructor(explorer) {
    this.explorer = explorer;
    /** @type {string[]} The readings that were chosen for the text. */
    this.chosen = [];
    this.asked = ""; // the text that was sent last
    /** @param {KeyboardEvent} event */
    const onkeydown = (event) => {
      event.stopPropagation(); // undo in the box is of the text
      if ((event.ctrlKey || event.metaKey) && event.key === "Enter") this.explain([]);
    };
    this.text = element("textarea", { class: "sv-text", rows: 7, spellcheck: "false", autocomplete: "off", "aria-label": "shapes as text", placeholder: PLACEHOLDER, onkeydown });
    this.why = element("p", { class: "sv-unread", role: "alert", hidden: true });
    this.answer = element("div", { class: "sv-answer", "aria-live": "polite" });
    const what = element("p", { class: "sv-note" }, "Paste WKT, GeoJSON, JSON, or lines of code with two or more shapes. No code is run.", element("span", { class: "sv-of-keys" }, " Control and Enter together do the same as the button explain."));
    this.element = element("details", { class: "sv-paste" }, element("summary", {}, "paste your own shapes"), what, this.text, element("div", { class: "sv-controls" }, button("explain", () => this.explain([])), button("take the shapes above", () => this.take())), this.why, this.answer);
    if (explorer.model.get("pasting")) this.element.open = true;
    /** @type {Listener} */
    this.onmessage = (content) => {
      if ((content.kind === "pasted" || content.kind === "state") && content.pasted) this.show(content.pasted);
    };
    explorer.model.on("msg:custom", this.onmessage);
  }

  /**
   * @param {string[]} chosen
   * @param {number} [pair]
   */
  explain(chosen, pair = 0) {
    this.chosen = chosen;
    this.asked = this.text.value;
    this.explorer.choose({ kind: "paste", text: this.asked, as: chosen, pair });
  }

  // The scene of the explorer, also after a drag, so that it can be explained and sent on.
  take() {
    this.text.value = this.explorer.state.json;
    this.explain([]);
  }

  /** @param {Pasted} pasted */
  show(pasted) {
    this.why.textContent = pasted.why ?? "";
    this.why.hidden = !pasted.why;
    this.answer.replaceChildren(...(pasted.sentence ? this.parts(pasted) : []));
  }

  /**
   * @param {Pasted} pasted
   * @returns {Generator<Element>}
   */
  *parts(pasted) {
    const { sentence = "", questions = [], findings = [], shapes = [], pairs = [], refused, without } = pasted;
    yield element("p", { class: "sv-verdict" }, sentence);
    for (const question of without ? questions.slice(0, 1) : questions) yield this.question(question, sentence, pasted.open ?? false);
    if (refused) yield drawn(refused);
    if (without) {
      yield element("p", { class: "sv-verdict" }, "Without it:");
      yield* this.parts(without);
      return;
    }
    const whole = pasted.json !== undefined; // and not an answer below a question
    if (findings.length) yield element("ul", { class: "sv-findings" }, ...findings.map(finding));
    if (whole && pairs.length > 1) yield element("div", { class: "sv-controls", role: "group", "aria-label": "pairs" }, ...pairs.map((pair, i) => this.pairButton(pair, i, pasted.pair ?? 0)), element("span", { class: "sv-note" }, pasted.note ?? ""));
    yield fold("how it was read", element("ul", {}, ...shapes.map(read)));
    const shown = pairs[pasted.pair ?? 0];
    if (!shown) return;
    const rows = shown.others.map(({ definition, answer, why }) => element("tr", {}, element("th", { scope: "row" }, definition), element("td", {}, answer), element("td", {}, why)));
    yield fold("what other definitions say", element("table", { class: "sv-others" }, element("tbody", {}, ...rows)));
    if (whole) yield fold("send it on", this.bundle(pasted));
  }

  /**
   * @param {PastedQuestion} question
   * @param {string} sentence the verdict, which can begin with the question
   * @param {boolean} open whether nothing is taken yet, because of this question or another one
   */
  question({ asks, answers }, sentence, open) {
    const buttons = answers.map(({ choice, meaning, gives }) => button(`${meaning}: ${gives}`, () => this.explain([...this.chosen, choice])));
    const taken = open ? [] : [element("span", { class: "sv-note" }, "satviz took the first answer. With the others the relation is the same.")];
    return element("div", { class: "sv-question", role: "group", "aria-label": asks }, ...(sentence.startsWith(asks) ? [] : [element("b", {}, asks)]), ...buttons, ...taken);
  }

  /**
   * @param {PastedPair} pair
   * @param {number} number
   * @param {number} shown
   */
  pairButton({ a, b, relation }, number, shown) {
    return button(`${a} and ${b}: ${relation}`, () => this.explain(this.chosen, number), { pressed: String(number === shown) });
  }

  /** @param {Pasted} pasted */
  bundle({ wkt = "", json = "", scene = "", link = "", tests = {}, picture }) {
    const status = element("span", { class: "sv-done", role: "status" });
    /** @param {string} text */
    const copy = async (text) => {
      status.textContent = (await copyText(text)) ? "Copied." : "This browser does not allow it: copy by hand.";
    };
    /** @type {Record<string, () => string>} */
    const texts = { link: () => sceneLink(this.explorer.model.get("site"), link), "scene file": () => scene, WKT: () => wkt, JSON: () => json };
    const copies = Object.entries(texts).map(([name, text]) => button(`copy ${name}`, () => copy(text())));
    const languages = element("select", { "aria-label": "language of the minimal test" }, ...Object.keys(tests).map((name) => element("option", { value: name }, name)));
    const svg = element("svg", { class: "sv-picture", role: "img" });
    const pen = new Pen(svg);
    if (picture) pen.draw(picture);
    /** @param {string} form */
    const save = (form) => savePictures([pen], form).catch(() => {
      status.textContent = "This browser cannot draw the file.";
    });
    const saves = picture ? PAGE_FORMATS.map((form) => button(`save picture as ${form.toUpperCase()}`, () => save(form))) : [];
    const controls = element("div", { class: "sv-controls" }, ...copies, ...saves, languages, button("copy minimal test", () => copy(tests[languages.value])), status);
    return element("div", {}, controls, ...(picture ? [svg] : []));
  }

  remove() {
    this.explorer.model.off("msg:custom", this.onmessage);
  }
}

/** @param {PastedFinding} finding */
function finding({ kind, text, help }) {
  return element("li", { class: `sv-finding sv-finding-${kind}` }, element("b", {}, text), help ? ` ${help}` : "");
}

/** @param {PastedShape} shape */
function read({ name, label, said, excerpt, refused }) {
  const title = label && label !== name ? `${name} (${label})` : name;
  return element("li", {}, `${title}: ${said}${refused ? `, refused: ${refused}` : ""}`, element("code", { class: "sv-excerpt", dir: "auto" }, excerpt));
}

/**
 * @param {string} title
 * @param {Node} inside
 */
function fold(title, inside) {
  return element("details", {}, element("summary", {}, title), inside);
}

/** @param {import("./pen.js").Picture} picture */
function drawn(picture) {
  const svg = element("svg", { class: "sv-picture sv-refused", role: "img" });
  new Pen(svg).draw(picture);
  return svg;
}
