// The rest of a chapter gives its questions away, so it waits until the answer to the question before it is opened.
// How far a reader has come is kept in the reader's own browser.

import { element } from "../../render/browser/elements.js";
import { followingAnswer } from "./choices.js";
import { keep, keptValue } from "./kept.js";

const ANSWERED = "answered";

/** @returns {Record<string, number>} By the path of a chapter, how many of its questions are answered. */
const answered = () => Object(keptValue(ANSWERED) ?? {});

/** @param {HTMLElement} chapter Where its answers are folded, and its choices are buttons. */
export function waitForAnswers(chapter) {
  const answers = [...chapter.querySelectorAll(".choices")].flatMap((choices) => followingAnswer(choices) ?? []);
  const path = location.pathname;
  const rest = element("div", { class: "rest", hidden: "until-found", onbeforematch: () => goOn(answers.length) });
  const whole = element("button", { type: "button", onclick: () => {
    const next = rest.querySelector(/** @type {"h2"} */ ("h2, h3, p"));
    goOn(answers.length);
    next?.setAttribute("tabindex", "-1");
    next?.focus({ preventScroll: true }); // the button is gone
  } }, "Show the whole chapter");
  const waits = element("p", { class: "waits" }, "The chapter goes on when you have answered. ", whole);

  /** @param {number} count So many questions are answered, or do not matter to the reader. */
  function goOn(count) {
    const passed = Math.max(count, answered()[path] || 0);
    if (passed) keep(ANSWERED, JSON.stringify({ ...answered(), [path]: passed }));
    waits.remove();
    rest.replaceWith(...rest.childNodes);
    if (passed >= answers.length) return;
    answers[passed].after(waits, rest);
    while (rest.nextSibling && !(rest.nextSibling instanceof Element && rest.nextSibling.matches(".note"))) rest.append(rest.nextSibling);
  }

  for (const [i, answer] of answers.entries()) answer.addEventListener("toggle", () => answer.open && goOn(i + 1));
  goOn(0);
}
