// The front page shows its idea by itself, once: the axis turns, and the gap opens.  Then the reader drags.
// It does not start where the reader wants less motion, and it ends as soon as the reader touches the scene.

import { element } from "../../render/browser/elements.js";
import { Pen } from "../../render/browser/pen.js";

const BEFORE_MS = 2600; // to read the first sentence
const TURN_MS = 6500;
const AFTER_MS = 3200;

/** @param {HTMLElement} stage */
export function playFirstMinute(stage) {
  const script = stage.querySelector("script.first-minute");
  const sentences = [...document.querySelectorAll(".told li")];
  if (!script || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const { frames, marks, ...still } = JSON.parse(script.textContent ?? "");
  const svg = element("svg", { class: "sv-picture", "aria-hidden": "true" });
  const cover = element("div", { class: "turning" }, svg);
  const again = element("button", { type: "button", class: "again", onclick: () => (cover.isConnected ? stop() : start()) });
  document.querySelector(".says")?.append(again);
  const pen = new Pen(svg);
  let frame = 0;
  let begun = 0;

  /** @param {number} i */
  const show = (i) => pen.draw({ ...still, sentence: "", marks: frames[i].map((/** @type {number} */ m) => marks[m]) });
  /** @param {number} now */
  const step = (now) => {
    begun ||= now;
    const part = Math.max(0, Math.min(1, (now - begun - BEFORE_MS) / TURN_MS));
    show(Math.round(((1 - Math.cos(Math.PI * part)) / 2) * (frames.length - 1)));
    const at = part === 0 ? 0 : part < 1 ? 1 : 2;
    for (const [i, sentence] of sentences.entries()) sentence.classList.toggle("now", i === at);
    if (now - begun > BEFORE_MS + TURN_MS + AFTER_MS) stop();
    else frame = requestAnimationFrame(step);
  };
  const start = () => {
    begun = 0;
    stage.prepend(cover);
    stage.classList.add("turns");
    again.textContent = "Stop";
    frame = requestAnimationFrame(step);
  };
  const stop = () => {
    cancelAnimationFrame(frame);
    cover.remove();
    stage.classList.remove("turns");
    for (const sentence of sentences) sentence.classList.remove("now");
    again.textContent = "Show it again";
  };
  stage.addEventListener("pointerdown", () => cover.isConnected && stop());
  stage.addEventListener("focusin", () => cover.isConnected && stop());
  start();
}
