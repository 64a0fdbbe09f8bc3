// The dial of the free axis: its needle is turned by hand, or turns by itself until it has been all the way round.

import { button, element } from "./elements.js";
import { Pen } from "./pen.js";
import { snap } from "./shapes.js";

/** @import { Explorer } from "./explorer.js" */
/** @import { Picture } from "./pen.js" */

const DEGREES_PER_S = 20;
const HALF_TURN = 180; // then every axis has been shown

export class AxisDial {
  /** @param {Explorer} explorer */
  constructor(explorer) {
    this.explorer = explorer;
    this.svg = element("svg", { class: "sv-picture", role: "img" });
    this.pen = new Pen(this.svg);
    this.turning = false; // by hand
    this.frame = 0; // of the turn by itself; 0: it stands
    this.play = button("turn the axis", () => (this.frame ? this.stop() : this.start()), { pressed: "false" });
    this.element = element("div", { class: "sv-dial", hidden: true }, this.svg, element("div", {}, element("p", { class: "sv-note" }, "In the green directions there is a gap. Drag the needle."), this.play));
    this.svg.addEventListener("pointerdown", (event) => this.pointerDown(event));
    this.svg.addEventListener("pointermove", (event) => this.turning && this.turnTo(event));
    for (const end of ["pointerup", "pointercancel"]) this.svg.addEventListener(end, () => this.letGo());
  }

  /** @param {Picture | undefined} dial */
  show(dial) {
    this.element.hidden = !dial;
    if (dial) this.pen.draw(dial);
    else this.stop();
    this.play.hidden = matchMedia("(prefers-reduced-motion: reduce)").matches; // then only the reader's hand moves it
  }

  /** @param {PointerEvent} event */
  pointerDown(event) {
    if (event.button > 0) return;
    event.preventDefault();
    this.stop();
    this.turning = true;
    this.svg.setPointerCapture(event.pointerId);
    this.explorer.forgetMessages();
    this.explorer.remember(this.explorer.pose);
    this.turnTo(event);
  }

  /** @param {PointerEvent} event */
  turnTo({ clientX, clientY }) {
    const { left, top, width, height } = this.svg.getBoundingClientRect();
    const angle = Math.atan2(top + height / 2 - clientY, clientX - left - width / 2);
    this.send(snap((angle * 180) / Math.PI, 1), false);
  }

  letGo() {
    if (!this.turning) return;
    this.turning = false;
    this.send(this.explorer.pose.degree ?? 0, true);
  }

  /**
   * @param {number} degree
   * @param {boolean} final
   */
  send(degree, final) {
    this.explorer.send({ ...this.explorer.pose, degree: snap(degree, 0.1) }, final);
  }

  // Each frame sends the angle of its time, unless Python has not answered the one before.
  start() {
    const { explorer } = this;
    const from = explorer.pose.degree ?? 0;
    const begin = performance.now();
    explorer.forgetMessages();
    explorer.remember(explorer.pose);
    this.play.setAttribute("aria-pressed", "true");
    /** @param {number} now */
    const tick = (now) => {
      const turned = Math.min(HALF_TURN, (Math.max(0, now - begin) / 1000) * DEGREES_PER_S);
      if (turned === HALF_TURN) {
        this.stop();
        return;
      }
      if (!explorer.sender.ahead) this.send(from + turned, false);
      this.frame = requestAnimationFrame(tick);
    };
    this.frame = requestAnimationFrame(tick);
  }

  stop() {
    if (!this.frame) return;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.play.setAttribute("aria-pressed", "false");
    if (this.explorer.pose.degree !== null) this.send(this.explorer.pose.degree, true);
  }

  remove() {
    cancelAnimationFrame(this.frame);
    this.pen.remove();
  }
}
