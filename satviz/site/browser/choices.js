// The choices of a question: what is chosen is judged, with a reason; the right one opens what was folded.

import { element } from "../../render/browser/elements.js";

/** @param {HTMLElement} list */
export function judgedChoices(list) {
  const answer = followingAnswer(list);
  const said = element("p", { class: "judged", role: "status" });
  for (const item of list.querySelectorAll("li")) {
    const [words, why] = item.querySelectorAll("span");
    const right = "right" in item.dataset;
    const choose = () => {
      item.classList.add(right ? "right" : "wrong");
      said.replaceChildren(element("b", {}, right ? "Right. " : "Not right. "), ...why.cloneNode(true).childNodes);
      if (right && answer) answer.open = true;
    };
    item.replaceChildren(element("button", { type: "button", onclick: choose }, ...words.childNodes));
  }
  list.classList.add("judges");
  list.after(said);
}

/**
 * The fold with the answer: the next one before any other question.
 * @param {Element} list
 */
export function followingAnswer(list) {
  for (let next = list.nextElementSibling; next && !next.matches(".choices, h2, h3"); next = next.nextElementSibling) {
    if (next instanceof HTMLDetailsElement && next.classList.contains("later")) return next;
  }
  return null;
}
