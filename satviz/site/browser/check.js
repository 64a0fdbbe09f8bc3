// The page "Is yours right?": an editor, a check of what is written in it, and the counterexample to drag.

import { element } from "../../render/browser/elements.js";
import { keep, kept } from "./kept.js";
import { LAST, NO_ANSWER, Reader } from "./reader.js";

/** @import { State } from "../../render/browser/messages.js" */
/** @import { PythonWorker } from "./python_worker.js" */
/** @import { Language, Outcome, Pair } from "./reader.js" */
/** @import { ScenePlace } from "./scene_place.js" */
/** @typedef {{ name: string, claim: string, agrees: number, pairs: number }} Likeness */
/** @typedef {{ kind: "checked", right: boolean, finding: string, sentence: string, mistake: string, text: string, link: string | null, behaves_like: Likeness[] }} Checked */
/** @typedef {{ kind: "judged", right: boolean, said: string, truth: string, answers: boolean }} Judged */
/** @typedef {Checked | Judged | { kind: "ask", pairs: Pair[] }} Reply */

const INDENT = "    ";
const CODE = "check-"; // and the name of a language or of a given program: under this the browser keeps the code

export class CheckPage {
  /**
   * @param {HTMLElement} root
   * @param {PythonWorker} python The trusted one: it never runs the reader's code.
   * @param {string} pythonScript
   * @param {ScenePlace} place Of the counterexample.
   */
  constructor(root, python, pythonScript, place) {
    this.root = root;
    this.python = python;
    this.pythonScript = pythonScript;
    this.place = place;
    /** @type {Reader | null} */
    this.reader = null;
    this.running = false;
    /** @type {((reply: Reply) => void) | null} */
    this.waiting = null;
    /** @type {Pair | null} The newest shapes of the explorer, which wait while the function works. */
    this.newest = null;
    this.judging = false;
    /** @type {HTMLTextAreaElement} */
    this.editor = find(root, "textarea");
    /** @type {HTMLSelectElement} */
    this.program = find(root, '[name="program"]');
    this.run = /** @type {HTMLButtonElement} */ (find(root, ".run"));
    this.forget = /** @type {HTMLButtonElement} */ (find(root, ".forget"));
    this.status = find(root, ".check-status");
    this.report = find(root, ".report");
    this.live = find(root, ".yours");
    this.printed = find(root, ".printed");
    this.found = find(root, ".found");
    this.skeletons = JSON.parse(find(root, ".skeletons").textContent ?? "{}");
    python.models.set("check", this);
    this.run.addEventListener("click", () => (this.running ? this.stop() : this.check()));
    this.forget.addEventListener("click", () => this.forgetCode());
    for (const radio of root.querySelectorAll('[name="language"]')) radio.addEventListener("change", () => this.openProgram(this.program.value));
    this.program.addEventListener("change", () => this.openProgram(this.program.value));
    addEventListener("hashchange", () => this.openProgram(location.hash.slice(1)));
    this.editor.addEventListener("input", () => keep(CODE + this.opened, this.editor.value));
    this.editor.addEventListener("keydown", (event) => this.keyPressed(event));
    place.onstate = (state) => this.judge(state);
    this.leaves = false;
    this.openProgram(location.hash.slice(1));
    this.run.disabled = false;
  }

  /** @returns {Language} */
  get language() {
    return /** @type {HTMLInputElement} */ (find(this.root, '[name="language"]:checked')).value === "javascript" ? "javascript" : "python";
  }

  /** What stands in the editor: a given program in this language, or the reader's own. */
  get opened() {
    return this.program.value ? `${this.program.value}-${this.language}` : this.language;
  }

  // Each program is kept by itself, so a given one never takes the place of the reader's own.
  /** @param {string} name Of a given program; otherwise the reader's own is opened. */
  openProgram(name) {
    const given = [...this.program.options].some(({ value }) => value && value === name);
    this.program.value = given ? name : "";
    this.editor.value = kept(CODE + this.opened) ?? this.skeletons[this.opened];
  }

  forgetCode() {
    for (const name of Object.keys(this.skeletons)) keep(CODE + name, null);
    this.openProgram(this.program.value);
    this.say("Your code is deleted from this browser.");
  }

  // Tab indents; after Escape it leaves the editor, as it does everywhere else.
  /** @param {KeyboardEvent} event */
  keyPressed(event) {
    if (event.key === "Escape") this.leaves = true;
    else if (event.key === "Tab" && !event.shiftKey && !this.leaves) {
      event.preventDefault();
      this.insert(INDENT);
    } else if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      if (!this.running) this.check();
    } else if (event.key === "Enter" && !event.isComposing) {
      const line = this.editor.value.slice(0, this.editor.selectionStart).split("\n").at(-1) ?? "";
      event.preventDefault();
      this.insert(`\n${line.match(/^ */)?.[0] ?? ""}${/[:{]\s*$/.test(line) ? INDENT : ""}`);
    }
    if (event.key !== "Escape" && event.key !== "Shift") this.leaves = false;
  }

  /** @param {string} text */
  insert(text) {
    const { editor } = this;
    editor.setRangeText(text, editor.selectionStart, editor.selectionEnd, "end");
    editor.dispatchEvent(new Event("input"));
  }

  /** @param {string} text */
  say(text) {
    this.status.textContent = text;
  }

  // The editor has no line numbers.
  /** @param {string} text That may name a line of the code. */
  withLine(text) {
    const line = this.editor.value.split("\n")[Number(text.match(/ in line (\d+)/)?.[1]) - 1]?.trim();
    return line ? `${text} The line: ${line}` : text;
  }

  stop() {
    this.reader?.stop();
    this.reader?.settle({ problem: NO_ANSWER, line: "was stopped" });
  }

  async check() {
    this.running = true;
    this.run.textContent = "Stop";
    this.reader?.stop();
    this.live.hidden = this.printed.hidden = this.report.hidden = this.found.hidden = true;
    this.say(this.language === "python" ? "Python is starting for your code." : "Your code is starting.");
    const reader = new Reader(this.language, this.editor.value, this.pythonScript);
    this.reader = reader;
    try {
      const why = await reader.define();
      this.showPrinted(reader.printed);
      if (why) this.say(this.withLine(why));
      else await this.ask(reader);
      const below = this.status.getBoundingClientRect().top > this.run.getBoundingClientRect().top; // else it stands beside
      this.status.scrollIntoView({ block: below && !this.found.hidden ? "start" : "nearest" });
    } finally {
      this.running = false;
      this.run.textContent = "Run";
    }
  }

  /** @param {Reader} reader */
  async ask(reader) {
    const chosen = (/** @type {string} */ name) => /** @type {HTMLSelectElement} */ (find(this.root, `[name="${name}"]`)).value;
    let asked = 0;
    let reply = await this.message({ kind: "check", kinds: chosen("kinds").split("|"), touching: chosen("touching") });
    while (reply.kind === "ask") {
      /** @type {Outcome[]} */
      const outcomes = [];
      for (const pair of reply.pairs) {
        outcomes.push(await reader.call(pair));
        if (LAST.includes(outcomes.at(-1)?.problem ?? "")) break;
      }
      asked += outcomes.length;
      this.say(`${asked} pairs of shapes so far.`);
      reply = await this.message({ kind: "outcomes", outcomes });
    }
    if (reply.kind === "checked") this.show(reply);
  }

  /**
   * @param {Record<string, any>} content
   * @returns {Promise<Reply>}
   */
  message(content) {
    return new Promise((resolve) => {
      this.waiting = resolve;
      this.python.send("check", content);
    });
  }

  /** @param {any} content */
  receive(content) {
    if (content.kind === "judged") {
      this.judging = false;
      this.showAnswer(content);
      if (this.newest) this.judgeNewest();
      return;
    }
    const { waiting } = this;
    this.waiting = null;
    waiting?.(content);
  }

  /** @param {Checked} checked */
  show(checked) {
    this.say(this.withLine(`${checked.sentence} ${checked.mistake}`.trim()));
    const mistake = checked.behaves_like[0];
    const link = mistake && element("a", { href: `scene.html#${mistake.name}` }, "See this mistake in the explorer");
    this.report.replaceChildren(element("pre", { class: "out", tabindex: "0" }, checked.text), ...(link ? [element("p", {}, link)] : []));
    this.report.hidden = false;
    this.found.hidden = !checked.link;
    if (!checked.link) return;
    this.place.root.dataset.hash = checked.link;
    this.place.open();
  }

  /** @param {State} state The explorer's: its shapes are given to the reader's function, the newest only. */
  judge({ a, b }) {
    if (this.found.hidden) return;
    this.newest = { a, b };
    if (!this.judging) this.judgeNewest();
  }

  async judgeNewest() {
    const pair = this.newest;
    this.newest = null;
    if (!pair || !this.reader || this.running) return;
    if (this.reader.ended) {
      this.live.hidden = false;
      this.live.className = "yours wrong";
      this.live.textContent = "✗ Your function does not run any more. Change it, and run it again.";
      return;
    }
    this.judging = true;
    const outcome = await this.reader.call(pair);
    this.showPrinted(this.reader.printed + (outcome.printed ?? ""));
    this.python.send("check", { kind: "judge", ...pair, outcome });
  }

  /** @param {string} text */
  showPrinted(text) {
    this.printed.hidden = !text;
    this.printed.textContent = `printed:\n${text}`;
  }

  /** @param {Judged} judged */
  showAnswer({ right, said, truth, answers }) {
    this.live.hidden = false;
    this.live.className = right ? "yours right" : "yours wrong";
    const text = `${right ? "✓" : "✗"} Your function ${answers ? `says: ${said}` : said}${said.endsWith("?") ? "" : "."} The right answer: ${truth}.`;
    if (this.live.textContent !== text) this.live.textContent = text; // a screen reader reads each change
  }
}

/**
 * @param {HTMLElement} root
 * @param {string} selector
 * @returns {any}
 */
function find(root, selector) {
  const found = root.querySelector(selector);
  if (!found) throw new Error(`the page has no ${selector}`);
  return found;
}
