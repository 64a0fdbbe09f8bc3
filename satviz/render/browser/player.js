// The step player: the picture of each step, the table of axes, the algorithm, the sentence.
// Everything shown was computed in Python; this walks through it.

const ASKED = new Set(["range", "both ranges", "gap"]); // stages that give the answer away
const ICONS = {
  first: "M3 3h2v10H3zM13 3v10L6 8z",
  back: "M11 3v10L4 8z",
  play: "M4 3v10l9-5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  forward: "M5 3v10l7-5z",
  last: "M3 3v10l7-5zM11 3h2v10h-2z",
  turn: "M12.7 9.7A5 5 0 1 1 11.7 4.6M12.2 1.4V5.2H8.4",
};

export function icon(name) {
  return element("svg", { viewBox: "0 0 16 16", class: "sv-icon", "aria-hidden": "true" }, element("path", { d: ICONS[name] }));
}

export function button(label, does, { shows, pressed = null, keys = null } = {}) {
  const what = { type: "button", "aria-label": label, title: label, onclick: does, "aria-pressed": pressed, "aria-keyshortcuts": keys };
  return element("button", what, shows ?? label);
}

// What a site's explorer opens: `site` is its address, empty where none is known.
export function linked(site, link) {
  return `${site ?? ""}scene.html#${link}`;
}

// Was the text copied?  Only a page from https or this machine has the clipboard, and a browser may forbid it there.
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = element("textarea", { readonly: true });
    field.value = text;
    const focused = document.activeElement;
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    focused?.focus();
    return done;
  }
}

// One menu of the files that can be saved, and of texts to copy: functions by name.  `ask` makes a kernel draw the
// files; where there is none the page's own pictures are the file.  Beside it `.sv-done` says what became of it.
export function saveMenu(pens, ask, texts) {
  const save = ask ?? ((form) => saveDrawn(pens, form));
  const said = element("span", { class: "sv-done", role: "status" });
  const copy = async (text) => { said.textContent = (await copied(text())) ? "Copied." : "This browser does not let a page copy."; };
  const copies = Object.entries(texts).map(([name, text]) => button(name, () => copy(text)));
  const forms = (ask ? ["svg", "png", "gif"] : ["svg", "png"]).map((form) => button(`save ${form.toUpperCase()}`, () => save(form), { shows: form.toUpperCase() }));
  const head = element("summary", {}, "save");
  const list = element("div", { onclick: () => menu.removeAttribute("open") }, ...forms, ...copies);
  const menu = element("details", { class: "sv-menu" }, head, list);
  menu.addEventListener("toggle", () => { // it stays inside the page
    if (menu.open) said.textContent = "";
    list.style.translate = "";
    const beyond = list.getBoundingClientRect().right - document.documentElement.clientWidth + 8;
    if (menu.open && beyond > 0) list.style.translate = `${-beyond}px`;
  });
  menu.addEventListener("focusout", ({ relatedTarget }) => relatedTarget && !menu.contains(relatedTarget) && menu.removeAttribute("open"));
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !menu.open) return;
    event.stopPropagation();
    menu.removeAttribute("open");
    head.focus();
  });
  return [menu, said];
}

// The table of axes.  A row is lit, greyed or still empty; then it does not show, either, whether it will be tested, since
// that tells where the run stops.  `pick` makes the rows buttons.
export class Table {
  constructor(names, { pick } = {}) {
    this.pick = pick;
    this.head = element("tr");
    this.body = element("tbody");
    this.element = element("table", { class: "sv-table" }, element("thead", {}, this.head), this.body);
    this.names(names);
  }
  names(names) {
    const heads = ["axis", ...names, "gap"].map((name) => element("th", { scope: "col" }, name));
    this.head.replaceChildren(element("td"), ...heads);
    this.called = names;
  }
  show(rows, { lit = null, done = () => true } = {}) {
    let pair = "";
    const made = [];
    rows.forEach((row, i) => {
      if (row.pair !== pair) {
        pair = row.pair;
        const cell = element("th", { colspan: 5, scope: "rowgroup" }, pair);
        made.push(element("tr", { class: "sv-pair" }, cell));
      }
      const known = done(i);
      const skipped = "reason" in row;
      const result = !known ? "" : skipped ? row.reason : row.outcome;
      const role = skipped || !known ? "" : row.gap >= 0 ? "sv-gap" : "sv-overlap";
      const shown = (text) => (known && !skipped ? text : "");
      const cells = skipped && known ? [element("td", { colspan: 3, class: "sv-reason" }, result)] : [
        element("td", { class: "sv-A", "data-of": this.called[0] }, shown(row.a)),
        element("td", { class: "sv-B", "data-of": this.called[1] }, shown(row.b)),
        element("td", { class: role }, result),
      ];
      const classes = `${lit === i ? "sv-lit" : ""} ${skipped && known ? "sv-skipped" : ""}`.trim();
      const name = this.pick && !skipped ? button(`show ${row.axis}`, () => this.pick(i), { shows: row.axis }) : row.axis;
      const first = element("td", {}, known || lit === i ? String(row.number ?? "–") : "");
      const line = element("tr", { class: classes, "aria-current": lit === i ? "step" : null }, first, element("td", {}, name), ...cells);
      made.push(line);
    });
    this.body.replaceChildren(...made);
  }
}

const WIDE = 620; // points; what is wider has no table beside it

// shows: one, or that of the early exit and that of every axis; narrow: the same for where these do not fit.
// save(form, step, which) asks a kernel for a file; without one the picture is saved as it is drawn.
export class Player {
  constructor(root, shows, { predict = false, save = null, narrow = [], link = "", site = "" } = {}) {
    this.root = root;
    this.shows = shows;
    this.which = 0;
    this.at = 0;
    this.timer = 0;
    this.answered = new Map(); // row -> was the guess right?
    this.asking = null;
    const svg = element("svg", { class: "sv-picture", role: "img", tabindex: 0, "data-lm-suppress-shortcuts": "true" });
    this.svg = svg;
    this.pen = new Pen(svg);
    this.sentence = element("p", { class: "sv-sentence", "aria-live": "polite" });
    this.question = element("div", { class: "sv-question", role: "group", hidden: true });
    this.table = new Table(this.show.names);
    this.code = element("ol", { class: "sv-code", "aria-label": "the algorithm" });
    const asked = (name, on) => (on ? `&${name}=1` : "");
    const copy = () => linked(site, `${link}&step=${this.at}${asked("predict", this.predict.checked)}${asked("rest", this.which)}`);
    this.controls = this.makeControls(predict, save, link ? { "copy link": copy } : {});
    const side = element("div", { class: "sv-side" }, this.code, element("div", { class: "sv-fold" }, this.table.element));
    const board = element("div", { class: "sv-board sv-scrolls" }, svg);
    const stage = element("div", { class: "sv-stage" }, board, this.question, this.sentence, this.controls);
    root.classList.add("satviz");
    root.append(element("div", { class: "sv-columns" }, stage, side));
    this.onkey = (event) => this.key(event);
    root.addEventListener("keydown", this.onkey);
    this.unthemed = themed(root);
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
  get last() {
    return this.show.steps.length - 1;
  }

  makeControls(predict, save, texts) {
    const go = (where) => () => this.go(where());
    this.playButton = button("play", () => this.toggle(), { shows: icon("play") });
    this.scrub = element("input", { type: "range", min: 0, step: 1, "aria-label": "step", oninput: () => this.go(Number(this.scrub.value)) });
    this.count = element("output", { class: "sv-count" });
    const options = [0.5, 1, 2].map((v) => element("option", { value: v, selected: v === 1 }, `${v}×`));
    this.speed = element("select", { "aria-label": "speed" }, ...options);
    this.predict = element("input", { type: "checkbox", checked: predict, onchange: () => this.go(this.at) });
    this.score = element("output", { class: "sv-score" });
    this.rest = button("test the rest", () => this.other(), { pressed: "false" });
    const row = element("div", { class: "sv-controls", role: "group", "aria-label": "player", "data-lm-suppress-shortcuts": "true" },
      button("first step", go(() => 0), { shows: icon("first") }),
      button("step back", go(() => this.at - 1), { shows: icon("back") }),
      this.playButton,
      button("step forward", go(() => this.at + 1), { shows: icon("forward") }),
      button("last step", go(() => this.last), { shows: icon("last") }),
      this.scrub, this.count, this.speed,
      element("label", {}, this.predict, " predict"), this.score,
      button("reset", () => this.reset()), this.rest);
    const [menu, done] = saveMenu([this.pen], save && ((form) => save(form, this.at, this.which)), texts);
    this.done = done; // says what became of a file
    row.append(menu, done);
    return row;
  }

  // Take in a show: when each row of its table is known, and the pictures by number.
  load() {
    const { steps, rows } = this.show;
    this.doneAt = rows.map(() => 0);
    steps.forEach((step, i) => {
      if (step.stage === "gap") this.doneAt[step.row] = i;
    });
    rows.forEach((row, i) => {
      if ("reason" in row && i) this.doneAt[i] = this.doneAt[i - 1];
    });
    this.scrub.max = this.last;
    const [width] = this.show.size;
    this.svg.style.minWidth = `${width}px`; // no letter is shown smaller than it is
    this.root.classList.toggle("sv-wide", width > WIDE);
    this.predict.parentNode.hidden = !this.show.asks;
    this.table.names(this.show.names);
    this.code.replaceChildren(...this.show.code.map((text) => element("li", {}, text)));
    this.go(Math.min(this.at, this.last), { animate: false });
  }

  picture(i) {
    const { size, looks, marks, steps } = this.show;
    const { limits, sentence } = steps[i];
    return { limits, size, looks, sentence, marks: steps[i].marks.map((m) => marks[m]) };
  }

  // Go to a step; in predict mode no further than the first question that is open.
  go(step, { animate = true } = {}) {
    let to = Math.max(0, Math.min(this.last, step));
    this.asking = null;
    const open = this.predict.checked ? this.show.steps.findIndex((s) => s.row !== null && ASKED.has(s.stage) && !this.answered.has(s.row)) : -1;
    if (open > 0 && open <= to) {
      to = open - 1;
      this.asking = this.show.steps[open].row;
    }
    const hides = open > 0; // how many steps there are tells how it ends
    const forward = to === this.at + 1;
    this.at = to;
    this.pen.draw(this.picture(to), { animate: animate && forward });
    const { sentence, row, code } = this.show.steps[to];
    this.sentence.textContent = sentence;
    this.scrub.value = to;
    this.count.textContent = hides ? `${to + 1}` : `${to + 1} / ${this.last + 1}`;
    this.scrub.hidden = hides;
    this.rest.hidden = hides || this.shows.length < 2;
    const known = (i) => this.doneAt[i] <= to && (!this.predict.checked || "reason" in this.show.rows[i] || this.answered.has(i));
    this.table.show(this.show.rows, { lit: row, done: known });
    [...this.code.children].forEach((line, i) => line.classList.toggle("sv-lit", code.includes(i)));
    this.ask();
    if (to === this.last || this.asking !== null) this.pause();
  }

  ask() {
    this.question.hidden = this.asking === null;
    if (this.asking !== null) {
      const name = this.show.rows[this.asking].axis;
      const answer = (yes) => () => this.answer(yes);
      this.question.replaceChildren(element("span", {}, `Does this axis (${name}) separate them?`), button("yes", answer(true)), button("no", answer(false)));
    }
    const right = [...this.answered.values()].filter(Boolean).length;
    this.score.textContent = this.predict.checked && this.answered.size ? `${right} of ${this.answered.size} right` : "";
  }

  answer(yes) {
    const row = this.asking;
    const separates = this.show.rows[row].gap > 0;
    this.answered.set(row, yes === separates);
    this.go(this.doneAt[row]);
    const said = yes === separates ? "Right. " : "Not so. ";
    this.sentence.textContent = said + this.sentence.textContent;
    this.root.querySelector(".sv-picture").focus();
  }

  toggle() {
    if (this.timer) return this.pause();
    if (this.at === this.last) this.go(0);
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
    if (this.which) this.other();
    this.go(0, { animate: false });
  }

  // The early exit's steps, or those of every axis.
  other() {
    this.which = this.which ? 0 : 1;
    this.rest.setAttribute("aria-pressed", String(Boolean(this.which)));
    this.load();
  }

  key(event) {
    const inside = event.target.closest("input, select, .sv-question");
    if (event.ctrlKey || event.metaKey || event.altKey || (inside && inside !== this.scrub)) return;
    const where = { ArrowRight: this.at + 1, ArrowLeft: this.at - 1, Home: 0, End: this.last }[event.key];
    if (where !== undefined) this.go(where);
    else if (event.key === " " && !event.target.closest("input, button, summary")) this.toggle();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  remove() {
    this.pause();
    this.sizes.disconnect();
    this.unthemed();
    this.pen.remove();
    this.root.removeEventListener("keydown", this.onkey);
    this.root.replaceChildren();
  }
}
