// The rest of a chapter gives its questions away, so it stays folded until the answer to the question before it is opened.
// How far a reader has come is kept in the reader's own browser.

import { element } from "../../render/browser/elements.js";
import { keep, keptValue } from "./kept.js";

const ANSWERED = "answered";

/** @returns {Record<string, number>} By the path of a chapter, how many of its questions are answered. */
const answered = () => Object(keptValue(ANSWERED) ?? {});

/** @param {HTMLElement} chapter Each fold with the rest of it stands right after an answer, inside the fold before. */
export function waitForAnswers(chapter) {
  const rests = [...chapter.querySelectorAll(/** @type {"details"} */ ("details.rest"))];
  const path = location.pathname;
  const whole = element("button", { type: "button", onclick: () => goOn(rests.length) }, "Show the whole chapter");
  const waits = element("p", { class: "waits" }, whole);

  /** @param {number} count So many questions are answered, or do not matter to the reader. */
  function goOn(count) {
    const passed = Math.max(count, answered()[path] || 0);
    if (passed) keep(ANSWERED, JSON.stringify({ ...answered(), [path]: passed }));
    const focused = document.activeElement;
    const next = rests.find(({ isConnected }) => isConnected)?.querySelector(/** @type {"h2"} */ ("h2, h3, p"));
    waits.remove();
    for (const rest of rests.slice(0, passed)) {
      if (!rest.isConnected) continue;
      rest.firstElementChild?.remove(); // its summary
      rest.replaceWith(...rest.childNodes);
    }
    rests[passed]?.after(waits);
    if (!next || focused?.isConnected) return;
    next.setAttribute("tabindex", "-1"); // what had the focus is gone
    next.focus({ preventScroll: true });
  }

  for (const [i, rest] of rests.entries()) {
    for (const fold of [rest, rest.previousElementSibling]) {
      fold?.addEventListener("toggle", () => fold instanceof HTMLDetailsElement && fold.open && goOn(i + 1));
    }
  }
  goOn(0);
}
