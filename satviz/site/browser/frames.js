// A slider over pictures that were drawn beforehand.

import { element } from "../../render/browser/elements.js";

/** @param {HTMLElement} place */
export function slidingFrames(place) {
  const frames = [...place.querySelectorAll("figure")];
  const slider = element("input", { type: "range", min: 0, max: frames.length - 1, step: 1, value: frames.findIndex((frame) => !frame.hidden), "aria-label": "picture",
    oninput: () => {
      for (const [i, frame] of frames.entries()) frame.hidden = i !== Number(slider.value);
      describe();
    } });
  const describe = () => slider.setAttribute("aria-valuetext", frames[Number(slider.value)].textContent?.trim() ?? "");
  describe();
  place.append(slider);
}
