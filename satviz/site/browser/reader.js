// The reader's function, in a worker of its own: Python beside a second Pyodide, JavaScript in a worker without an origin.
// It is asked about one pair at a time.  Where no answer comes, the worker is ended.

import { answerPairs } from "./answer_pairs.js";
import { shutOff } from "./shut_off.js";

/** @typedef {{ value?: unknown, problem?: string, line?: string, printed?: string }} Outcome `printed`: what the function printed. */
/** @typedef {{ a: unknown, b: unknown }} Pair Shapes as in a scene file. */
/** @typedef {"python" | "javascript"} Language */

const CALL_MS = 2000; // that one call may take
const START_MS = 60000; // that Python may take to start; a script starts at once
const MAX_LETTERS = 20000; // of an answer with all that was printed
export const NO_ANSWER = "no answer";
const ENDED = "ended";
export const LAST = [NO_ANSWER, ENDED]; // problems after which nothing more is asked

export class Reader {
  /**
   * @param {Language} language
   * @param {string} code
   * @param {string} pythonScript
   */
  constructor(language, code, pythonScript) {
    this.language = language;
    this.code = code;
    /** @type {((data: any) => void) | null} */
    this.waiting = null;
    this.ended = false;
    this.printed = ""; // by the code itself, before its function is called
    const source = language === "python" ? `import ${JSON.stringify(new URL(pythonScript, location.href).href)};` : harness(code);
    // A worker made from such an address obeys the policy of this page, also where a server sends no policy.
    this.url = language === "python" ? URL.createObjectURL(new Blob([source], { type: "text/javascript" })) : `data:text/javascript;charset=utf-8,${encodeURIComponent(source)}`;
    this.worker = new Worker(this.url, language === "python" ? { type: "module" } : {});
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      const number = event.lineno - HARNESS_LINES;
      const line = number > 0 && number <= code.split("\n").length ? ` in line ${number}` : "";
      this.settle({ problem: "error", line: event.message ? `raises ${event.message.replace(/^Uncaught /, "")}${line}` : "does not load" });
    };
  }

  /** @returns {Promise<string>} Why there is no function; empty where there is one. */
  async define() {
    if (this.language === "python") {
      const { failed, problem } = await this.next(START_MS);
      if (failed || problem) return `Python does not start${failed ? `: ${failed}` : ""}.`;
      this.worker.postMessage({ place: "reader", content: { kind: "define", code: this.code } });
    }
    const found = await this.next(this.language === "python" ? START_MS / 4 : CALL_MS);
    this.printed = String(found.printed ?? "");
    return found.problem ? `The code ${found.line}.`.replace("?.", "?") : String(found.why ?? "");
  }

  /**
   * @param {Pair} pair
   * @returns {Promise<Outcome>}
   */
  async call(pair) {
    if (this.ended) return { problem: NO_ANSWER, line: "was stopped" };
    this.worker.postMessage(this.language === "python" ? { place: "reader", content: { kind: "call", ...pair } } : pair);
    return this.next(CALL_MS);
  }

  /**
   * @param {number} milliseconds
   * @returns {Promise<any>}
   */
  next(milliseconds) {
    return new Promise((resolve) => {
      const timer = setTimeout(() => {
        this.stop();
        this.settle({ problem: NO_ANSWER, line: `gives no answer within ${milliseconds / 1000} s: an endless loop?` });
      }, milliseconds);
      this.waiting = (data) => {
        clearTimeout(timer);
        resolve(data);
      };
    });
  }

  /** @param {any} data */
  receive(data) {
    if (this.language === "python") {
      if (data?.ended) this.end();
      else if (data?.ready || data?.failed) this.settle(data.failed ? { failed: String(data.failed) } : {});
      else if (typeof data?.text === "string") this.settle(outcomeFrom(data.text));
    } else this.settle(typeof data === "string" ? outcomeFrom(data) : {});
  }

  /** @param {any} data */
  settle(data) {
    const { waiting } = this;
    this.waiting = null;
    waiting?.(data);
  }

  end() {
    this.stop();
    this.settle({ problem: ENDED, line: "ends the program by itself" });
  }

  stop() {
    this.ended = true;
    this.worker.terminate();
    if (this.language === "python") URL.revokeObjectURL(this.url);
  }
}

/**
 * @param {string} text Of the worker, where the reader's code may have forged it.
 * @returns {Record<string, any>}
 */
function outcomeFrom(text) {
  if (text.length > MAX_LETTERS) return { problem: "error", line: `answers with more than ${MAX_LETTERS} letters` };
  try {
    return JSON.parse(text) ?? {};
  } catch {
    return { problem: "error", line: "answers with a message that is not an outcome" };
  }
}

const FILE = "your-code"; // the name of the reader's script in the stack of an error
const before = (/** @type {number} */ lines) => `((post) => {\n(${shutOff})();\n(${answerPairs})(post, "${FILE}", ${lines});\n})(self.postMessage.bind(self));\nself.satvizCollide = (() => {\n`;
const HARNESS_LINES = before(0).split("\n").length - 1;
const FUNCTION_OF_TWO = /(?:function\s+|(?:const|let|var)\s+)([A-Za-z_$][\w$]*)\s*(?:=\s*(?:function\s*)?)?\(\s*[\w$]+\s*,\s*[\w$]+\s*\)/g;

/** @param {string} code Its function `collide` is called, or the last one of two arguments. */
function harness(code) {
  const names = [...code.matchAll(FUNCTION_OF_TWO)].map((found) => found[1]);
  const name = names.includes("collide") ? "collide" : (names.at(-1) ?? "collide");
  return `${before(HARNESS_LINES)}${code}\n;return typeof ${name} === "function" ? ${name} : null;\n})();\n//# sourceURL=${FILE}`;
}
