// The step player: the picture of each step, the table of axes, the algorithm, the sentence.
// Python has computed everything that is shown.

import { button, element, icon } from "./elements.js";
import { Pen } from "./pen.js";
import { saveMenu, sceneLink } from "./save_menu.js";
import { Table } from "./table.js";
import { followTheme } from "./theme.js";

/** @import { Style, Mark, Picture, Point } from "./pen.js" */
/** @import { Row } from "./table.js" */
/**
 * @typedef {object} Step
 * @property {number[]} marks By their number in the show.
 * @property {Picture["limits"]} limits
 * @property {string} sentence
 * @property {number} ms How long the sentence takes to read.
 * @property {number | null} row The row of the table that the step is about.
 * @property {number[]} code The lines of the algorithm that the step is about.
 * @property {string} stage
 */
/**
 * A run of the algorithm.
 * @typedef {object} Show
 * @property {Point} size
 * @property {Style[]} styles
 * @property {Mark[]} marks
 * @property {Step[]} steps
 * @property {string[]} names
 * @property {Row[]} rows
 * @property {boolean} asks Can the reader predict its answers?
 * @property {string[]} code
 */
/** @typedef {(form: string, step: number, which: number) => void} RequestFile */
/**
 * @typedef {object} PlayerOptions
 * @property {boolean} [predict]
 * @property {number} [speed] How many times as fast it plays at first.
 * @property {string[]} [formats] The formats of the files that a kernel draws.
 * @property {RequestFile | null} [requestFile] Asks the kernel for a file.  Without it the page saves its own picture.
 * @property {Show[]} [narrow] The same shows for a place where the others do not fit.
 * @property {string} [link]
 * @property {string} [site]
 * @property {Point | null} [range] The first and the last step, if only these are played.
 */

const ANSWER_STAGES = new Set(["range", "both ranges", "gap"]); // these stages give the answer away
const MAX_WIDTH_BESIDE_TABLE = 620; // points

export class Player {
  /**
   * @param {HTMLElement} root
   * @param {Show[]} shows One, or that of the early exit and that of every axis.
   * @param {PlayerOptions} [options]
   */
  constructor(root, shows, { predict = false, speed = 1, requestFile = null, formats = [], narrow = [], link = "", site = "", range = null } = {}) {
    this.root = root;
    this.shows = shows;
    this.range = range;
    this.which = 0;
    this.at = this.first;
    this.timer = 0;
    /** @type {Map<number, boolean>} By row: was the guess right? */
    this.answered = new Map();
    /** @type {number | null} The row that the reader is asked about. */
    this.asking = null;
    /** @type {number[]} By row: the step from which its result is known. */
    this.knownAt = [];
    const svg = element("svg", { class: "sv-picture", role: "img", tabindex: 0, "data-lm-suppress-shortcuts": "true" });
    this.svg = svg;
    this.pen = new Pen(svg);
    this.sentence = element("p", { class: "sv-sentence", "aria-live": "polite" });
    this.question = element("div", { class: "sv-question", role: "group", hidden: true });
    this.table = new Table(this.show.names);
    this.code = element("ol", { class: "sv-code", "aria-label": "the algorithm" });
    this.playButton = button("play", () => this.toggle(), { content: icon("play") });
    this.scrub = element("input", { type: "range", min: this.first, step: 1, "aria-label": "step", oninput: () => this.go(Number(this.scrub.value)) });
    this.count = element("output", { class: "sv-count" });
    const known = [...new Set([0.25, 0.5, 1, 2, 4, speed])].sort((p, q) => p - q);
    const speeds = known.map((v) => element("option", { value: v, selected: v === speed }, `${v}×`));
    this.speed = element("select", { "aria-label": "speed" }, ...speeds);
    this.predict = element("input", { type: "checkbox", checked: predict, onchange: () => this.go(this.at) });
    this.predictLabel = element("label", {}, this.predict, " predict");
    this.score = element("output", { class: "sv-score" });
    this.rest = button("test the rest", () => this.switchShow(), { pressed: "false" });
    const copy = () => sceneLink(site, `${link}&step=${this.at}${this.predict.checked ? "&predict=1" : ""}${this.which ? "&every-axis=1" : ""}`);
    const kernel = requestFile && { formats, request: (/** @type {string} */ form) => requestFile(form, this.at, this.which) };
    const { menu, status } = saveMenu([this.pen], kernel, link ? { "copy link": copy } : {});
    this.status = status; // says what became of a file
    const side = element("div", { class: "sv-side" }, this.code, element("div", { class: "sv-fold" }, this.table.element));
    const board = element("div", { class: "sv-board sv-scrolls" }, svg);
    const stage = element("div", { class: "sv-stage" }, board, this.question, this.sentence, this.controls(menu));
    root.classList.add("satviz");
    root.append(element("div", { class: "sv-columns" }, stage, side));
    /** @param {KeyboardEvent} event */
    this.onkey = (event) => this.keyPressed(event);
    root.addEventListener("keydown", this.onkey);
    this.unfollowTheme = followTheme(root);
    this.load();
    this.sizes = new ResizeObserver(() => {
      const fitting = narrow.length && board.clientWidth < shows[0].size[0] ? narrow : shows;
      if (fitting === this.shows) return;
      this.shows = fitting;
      this.load();
    });
    this.sizes.observe(root);
  }

  get show() {
    return this.shows[this.which];
  }
  get first() {
    return this.range?.[0] ?? 0;
  }
  get last() {
    return this.range?.[1] ?? this.show.steps.length - 1;
  }

  /** @param {HTMLElement} menu */
  controls(menu) {
    return element("div", { class: "sv-controls", role: "group", "aria-label": "player", "data-lm-suppress-shortcuts": "true" },
      button("first step", () => this.go(this.first), { content: icon("first") }),
      button("step back", () => this.go(this.at - 1), { content: icon("back") }),
      this.playButton,
      button("step forward", () => this.go(this.at + 1), { content: icon("forward") }),
      button("last step", () => this.go(this.last), { content: icon("last") }),
      this.scrub, this.count, this.speed, this.predictLabel, this.score,
      button("reset", () => this.reset()), this.rest, menu, this.status);
  }

  // Show another run, at the same step if it has one.
  load() {
    const { steps, rows } = this.show;
    this.knownAt = rows.map(() => 0);
    steps.forEach((step, i) => {
      if (step.stage === "gap" && step.row !== null) this.knownAt[step.row] = i;
    });
    rows.forEach((row, i) => {
      if ("reason" in row && i) this.knownAt[i] = this.knownAt[i - 1];
    });
    this.scrub.max = String(this.last);
    const [width, height] = this.show.size;
    this.code.hidden = !this.show.code.length;
    this.table.element.hidden = !rows.length;
    this.svg.style.minWidth = `${width}px`; // no letter is shown smaller than it is
    this.svg.style.setProperty("--sv-height", String(height));
    this.root.classList.toggle("sv-wide", width > MAX_WIDTH_BESIDE_TABLE);
    this.predictLabel.hidden = !this.show.asks;
    this.table.setNames(this.show.names);
    this.code.replaceChildren(...this.show.code.map((text) => element("li", {}, text)));
    this.go(Math.min(this.at, this.last), { animate: false });
  }

  /**
   * @param {number} i
   * @returns {Picture}
   */
  picture(i) {
    const { size, styles, marks, steps } = this.show;
    const { limits, sentence } = steps[i];
    return { limits, size, styles, sentence, marks: steps[i].marks.map((m) => marks[m]) };
  }

  /**
   * Go to a step; in predict mode no further than the first question that is open.
   * @param {number} step
   */
  go(step, { animate = true } = {}) {
    let to = Math.max(this.first, Math.min(this.last, step));
    this.asking = null;
    const open = this.predict.checked ? this.show.steps.findIndex((s, i) => i > this.first && s.row !== null && ANSWER_STAGES.has(s.stage) && !this.answered.has(s.row)) : -1;
    if (open > 0 && open <= to) {
      to = open - 1;
      this.asking = this.show.steps[open].row;
    }
    const hides = open > 0; // how many steps there are tells how it ends
    const forward = to === this.at + 1;
    this.at = to;
    this.pen.draw(this.picture(to), { animate: animate && forward && this.show.steps[to].stage !== "sweep" });
    const { sentence, row, code } = this.show.steps[to];
    this.sentence.textContent = sentence;
    this.scrub.value = String(to);
    this.count.textContent = hides ? `${to + 1}` : `${to + 1} / ${this.show.steps.length}`;
    this.scrub.hidden = hides;
    this.rest.hidden = hides || this.shows.length < 2 || this.range !== null;
    const known = (/** @type {number} */ i) => this.knownAt[i] <= to && (!this.predict.checked || "reason" in this.show.rows[i] || this.answered.has(i));
    this.table.show(this.show.rows, { lit: row, known });
    for (const [i, line] of [...this.code.children].entries()) line.classList.toggle("sv-lit", code.includes(i));
    this.ask();
    if (to === this.last || this.asking !== null) this.pause();
  }

  ask() {
    const row = this.asking;
    this.question.hidden = row === null;
    if (row !== null) {
      const name = this.show.rows[row].axis;
      this.question.replaceChildren(element("span", {}, `Does this axis (${name}) separate them?`), button("yes", () => this.answer(row, true)), button("no", () => this.answer(row, false)));
    }
    const right = [...this.answered.values()].filter(Boolean).length;
    this.score.textContent = this.predict.checked && this.answered.size ? `${right} of ${this.answered.size} right` : "";
  }

  /**
   * @param {number} row
   * @param {boolean} yes
   */
  answer(row, yes) {
    const asked = this.show.rows[row];
    const right = yes === ("gap" in asked && asked.gap > 0);
    this.answered.set(row, right);
    this.go(this.knownAt[row]);
    this.sentence.textContent = (right ? "Right. " : "Not right. ") + this.sentence.textContent;
    this.svg.focus();
  }

  toggle() {
    if (this.timer) return this.pause();
    if (this.at === this.last) this.go(this.first);
    this.playButton.replaceChildren(icon("pause"));
    this.playButton.setAttribute("aria-label", "pause");
    const next = () => {
      const { ms } = this.show.steps[Math.min(this.at + 1, this.last)]; // as long as its words take to read
      this.timer = setTimeout(next, ms / Number(this.speed.value));
      this.go(this.at + 1);
    };
    this.timer = setTimeout(next, 300);
  }

  pause() {
    clearTimeout(this.timer);
    this.timer = 0;
    this.playButton.replaceChildren(icon("play"));
    this.playButton.setAttribute("aria-label", "play");
  }

  reset() {
    this.answered.clear();
    this.pause();
    if (this.which) this.switchShow();
    this.go(this.first, { animate: false });
  }

  // Change between the steps of the early exit and those of every axis.
  switchShow() {
    this.which = this.which ? 0 : 1;
    this.rest.setAttribute("aria-pressed", String(Boolean(this.which)));
    this.load();
  }

  /** @param {KeyboardEvent} event */
  keyPressed(event) {
    if (!(event.target instanceof Element)) return;
    const inside = event.target.closest("input, select, .sv-question");
    if (event.ctrlKey || event.metaKey || event.altKey || (inside && inside !== this.scrub)) return;
    /** @type {Record<string, number>} */
    const steps = { ArrowRight: this.at + 1, ArrowLeft: this.at - 1, Home: this.first, End: this.last };
    const step = steps[event.key];
    if (step !== undefined) this.go(step);
    else if (event.key === " " && !event.target.closest("input, button, summary")) this.toggle();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  remove() {
    this.pause();
    this.sizes.disconnect();
    this.unfollowTheme();
    this.pen.remove();
    this.root.removeEventListener("keydown", this.onkey);
    this.root.replaceChildren();
  }
}
