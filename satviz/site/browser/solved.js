// The challenges that this reader has solved, kept in the reader's own browser.

import { keep, keptValue } from "./kept.js";

const SOLVED = "solved";

/** @returns {string[]} */
function solved() {
  const found = keptValue(SOLVED);
  return Array.isArray(found) ? found.filter((each) => typeof each === "string") : [];
}

/**
 * Keep that the challenge in a state of the explorer is met.
 * @param {{ scene: string, goal?: { goal: string, met: boolean } }} state
 */
export function keepSolved({ scene, goal }) {
  if (!goal?.met) return;
  const id = `${goal.goal}:${JSON.parse(scene).name}`;
  const known = solved();
  if (!known.includes(id)) keep(SOLVED, JSON.stringify([...known, id]));
}

/** @param {HTMLElement} place It says how many are solved, and forgets them. */
export function showSolved(place) {
  const [count, forget] = /** @type {[HTMLElement, HTMLElement]} */ ([place.querySelector(".count"), place.querySelector("button")]);
  const begin = /** @type {HTMLAnchorElement} */ (document.querySelector(".action a"));
  const items = [...document.querySelectorAll(/** @type {"li"} */ ("li[data-challenge]"))];
  const show = () => {
    const known = new Set(solved());
    for (const item of items) {
      const done = known.has(item.dataset.challenge ?? "");
      item.classList.toggle("solved", done);
      const mark = item.querySelector(".mark");
      if (mark) mark.textContent = done ? "solved" : "";
    }
    const done = items.filter((item) => item.classList.contains("solved")).length;
    count.textContent = done ? `You have solved ${done} of ${items.length}.` : `None of ${items.length} is solved yet.`;
    forget.hidden = !done;
    const next = items.find((item) => !item.classList.contains("solved"))?.querySelector("a");
    if (next) begin.href = next.href;
    begin.hidden = !next;
    begin.textContent = done ? "Go on with the next challenge" : "Begin with the first challenge";
  };
  forget.addEventListener("click", () => {
    keep(SOLVED, null);
    show();
    count.focus();
  });
  addEventListener("pageshow", show); // also when the reader comes back from a challenge
  show();
}
