// Shapes by hand: draw a polygon corner by corner, make a circle, add a corner to an edge, take one away; with mouse, touch
// and keys.  What is drawn is sent to Python like any change, so undo takes it back.  An outline that Python refuses stays
// on the screen with the reason, and can be mended.

import { element, toolButton, toolMenu } from "./elements.js";
import { distanceToSegment, roundDown, snap, spokenPoint } from "./shapes.js";

/** @import { Explorer } from "./explorer.js" */
/** @import { Listener } from "./messages.js" */
/** @import { Point } from "./pen.js" */
/** @import { Polygon, Shape } from "./shapes.js" */
/** @typedef {"a" | "b"} Key */
/** @typedef {"polygon" | "circle" | "add" | "take"} Tool */

const CLOSE_REACH = 14; // pixels from the first corner within which a click closes the outline
const CROSS_STEP = 8; // points that an arrow key moves the cross; with Shift a tenth
/** @type {Record<string, Point>} */
const CROSS_MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {Record<Tool, string>} */
const TOOL_HELP = {
  polygon: "Click each corner in turn. To close the polygon, click the first corner again, or press done. Keys: arrows move the cross, Enter sets a corner, Backspace removes the last one, Escape ends.",
  circle: "Click the center, then a point of the border. Keys: arrows move the cross, Enter sets it, Escape ends.",
  add: "Click an edge where the new corner belongs. Keys: arrows move the cross, Enter sets it, Escape ends.",
  take: "Click the corner to remove. Keys: arrows move the cross, Enter removes the nearest corner, Escape ends.",
};

export class ShapeEditor {
  /** @param {Explorer} explorer */
  constructor(explorer) {
    this.explorer = explorer;
    /** @type {Tool | null} */
    this.tool = null;
    /** @type {Point[]} The corners that were set, in scene units. */
    this.points = [];
    /** @type {Point} Where the keys have moved the cross. */
    this.cross = [0, 0];
    this.sent = false; // was an outline of this editor sent, and not answered yet?
    const option = (/** @type {Key} */ value) => element("option", { value }, value.toUpperCase());
    this.which = element("select", { "aria-label": "which shape" }, option("a"), option("b"));
    /** @type {Record<Tool, string>} */
    const names = { polygon: "draw polygon", circle: "draw circle", add: "add corner", take: "remove corner" };
    this.buttons = /** @type {[Tool, string][]} */ (Object.entries(names)).map(([tool, name]) => ({ tool, button: toolButton(tool, name, () => this.choose(this.tool === tool ? null : tool), { pressed: "false" }) }));
    this.done = toolButton("done", "done", () => this.finish());
    this.done.hidden = true;
    this.help = element("p", { role: "status" });
    const { menu, summary } = toolMenu("draw", "draw", element("label", {}, "shape ", this.which), ...this.buttons.map((each) => each.button));
    this.summary = summary;
    this.element = element("div", { class: "sv-edit", hidden: true }, this.help, this.done); // where the hint was
    explorer.controls.drawing.append(menu);
    this.drawing = element("svg", { class: "sv-drawing", "aria-hidden": "true" });
    this.plane = element("div", { class: "sv-plane", hidden: true, tabindex: 0, role: "application", "aria-label": "drawing plane", onpointerdown: (event) => this.clicked(event), onkeydown: (event) => this.keyPressed(event) });
    explorer.board.append(this.drawing, this.plane);
    /** @type {Listener} */
    this.onmessage = (content) => {
      if (content.kind === "state") this.answered();
    };
    explorer.model.on("msg:custom", this.onmessage);
  }

  get key() {
    return /** @type {Key} */ (this.which.value);
  }

  /** @param {Tool | null} tool */
  choose(tool) {
    this.tool = tool;
    this.points = [];
    this.sent = false;
    for (const each of this.buttons) each.button.setAttribute("aria-pressed", String(each.tool === tool));
    this.plane.hidden = !tool;
    this.done.hidden = tool !== "polygon";
    this.element.hidden = !tool;
    this.help.textContent = tool ? TOOL_HELP[tool] : "";
    if (tool) {
      this.explorer.used();
      const { pen } = this.explorer;
      this.cross = this.snapped(pen.toScene([pen.width / 2, pen.height / 2]));
      this.plane.focus({ preventScroll: true });
    }
    this.draw();
  }

  /**
   * A point on the grid of round numbers that one point of the picture can show.
   * @param {Point} point
   * @returns {Point}
   */
  snapped([x, y]) {
    const grid = 10 ** Math.floor(Math.log10(1 / this.explorer.pen.scale));
    return [snap(x, grid), snap(y, grid)];
  }

  /** @param {PointerEvent} event */
  clicked(event) {
    if (event.button > 0) return;
    event.preventDefault();
    event.stopPropagation();
    this.plane.focus({ preventScroll: true });
    this.cross = this.snapped(this.explorer.scenePoint(event));
    this.set(this.cross);
  }

  /** @param {KeyboardEvent} event */
  keyPressed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = CROSS_MOVES[event.key];
    if (arrow) {
      const size = roundDown(CROSS_STEP / this.explorer.pen.scale) * (event.shiftKey ? 0.1 : 1);
      const [x, y] = this.cross;
      this.cross = [snap(x + arrow[0] * size, size / 10), snap(y + arrow[1] * size, size / 10)];
      this.plane.setAttribute("aria-label", `cross at ${spokenPoint(this.cross)}`);
    } else if (event.key === "Enter" || event.key === " ") this.set(this.cross);
    else if (event.key === "Backspace") this.points.pop();
    else if (event.key === "Escape") {
      this.choose(null);
      this.summary.focus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
    this.draw();
  }

  /**
   * Use a point: a corner, a center, a place on an edge, a corner that goes.
   * @param {Point} point
   */
  set(point) {
    this.sent = false;
    if (this.tool === "polygon") {
      if (this.points.length > 2 && this.pixels(point, this.points[0]) <= CLOSE_REACH) {
        this.finish();
        return;
      }
      this.points.push(point);
    } else if (this.tool === "circle") {
      this.points.push(point);
      if (this.points.length === 2) {
        const [[x, y], rim] = this.points;
        const grid = 10 ** Math.floor(Math.log10(1 / this.explorer.pen.scale));
        this.send({ circle: [x, y], radius: snap(Math.hypot(rim[0] - x, rim[1] - y), grid) });
      }
    } else this.changeCorner(point);
    this.draw();
  }

  /**
   * Add a corner to the nearest edge, or take the nearest corner.
   * @param {Point} point
   */
  changeCorner(point) {
    const { pose } = this.explorer;
    /** @type {{ key: Key, shape: Polygon, number: number, distance: number } | null} */
    let nearest = null;
    for (const key of /** @type {Key[]} */ (["a", "b"])) {
      const shape = pose[key];
      if (!shape.polygon) continue;
      const { polygon } = shape;
      for (const [number, p] of polygon.entries()) {
        const edge = [p, polygon[(number + 1) % polygon.length]];
        const distance = this.tool === "add" ? distanceToSegment(point, edge) : Math.hypot(p[0] - point[0], p[1] - point[1]);
        if (!nearest || distance < nearest.distance) nearest = { key, shape, number, distance };
      }
    }
    if (!nearest) return;
    const { key, shape, number } = nearest;
    const polygon = this.tool === "add" ? shape.polygon.toSpliced(number + 1, 0, point) : shape.polygon.toSpliced(number, 1);
    this.which.value = key;
    this.points = polygon; // shown if it is refused
    this.send({ polygon });
  }

  finish() {
    if (this.points.length) this.send({ polygon: this.points });
  }

  /** @param {Shape} shape */
  send(shape) {
    this.sent = true;
    this.explorer.change({ [this.key]: shape, pinned: null });
  }

  // Python has taken the outline: the next one can be drawn, and what was refused before goes.
  answered() {
    if (this.explorer.keepsRefusal) return;
    if (!this.sent) {
      if (!this.tool && this.points.length) this.choose(null);
      return;
    }
    this.sent = false;
    this.points = [];
    if (this.tool === "polygon" || this.tool === "circle") this.choose(null);
    this.draw();
  }

  /**
   * An outline that Python refuses stays on the screen.  One that is being drawn can be mended: its last corner can be
   * taken back.
   * @param {{ a: Shape, b: Shape }} pose
   */
  showRefused(pose) {
    const { state, drag } = this.explorer;
    const own = this.sent;
    this.sent = false;
    const key = /** @type {Key[]} */ (["a", "b"]).find((k) => JSON.stringify(pose[k]) !== JSON.stringify(state[k]));
    if (!key || drag) return; // what is dragged is drawn already
    this.which.value = key;
    if (!own || this.tool !== "polygon") this.points = pose[key].polygon ?? [];
    this.draw(true);
    if (this.tool && this.tool !== "polygon") this.points = [];
  }

  /**
   * How far apart two points are on the screen.
   * @param {Point} p
   * @param {Point} q
   */
  pixels(p, q) {
    return Math.hypot(p[0] - q[0], p[1] - q[1]) * this.explorer.pen.scale * this.explorer.handles.pixelsPerPoint;
  }

  // Take the refused outline off the screen.
  clear() {
    if (this.tool !== "polygon") this.points = [];
    this.draw();
  }

  /** @param {boolean} [refused] */
  draw(refused = false) {
    const { pen } = this.explorer;
    this.drawing.setAttribute("viewBox", `0 0 ${pen.width} ${pen.height}`);
    this.drawing.classList.toggle("sv-wrong", refused);
    this.drawing.classList.toggle("sv-role-b", this.key === "b");
    const spots = this.points.map((p) => pen.toPicture(p));
    const path = spots.map(([x, y], i) => `${i ? "L" : "M"}${x} ${y}`).join("");
    const dots = spots.map(([x, y]) => element("circle", { cx: x, cy: y, r: 4 }));
    const parts = path ? [element("path", { d: refused ? `${path}Z` : path }), ...dots] : [];
    if (this.tool && !refused) {
      const [x, y] = pen.toPicture(this.cross);
      parts.push(element("path", { class: "sv-cross", d: `M${x - 8} ${y}H${x + 8}M${x} ${y - 8}V${y + 8}` }));
    }
    this.drawing.replaceChildren(...parts);
  }

  remove() {
    this.explorer.model.off("msg:custom", this.onmessage);
  }
}
