// The handles over the picture: what each one changes, where it sits, and what it says to a screen reader.

import { element, icon } from "./elements.js";
import { centerOf, contains, distanceToSegment, plainNumber, snap, spoken, spokenPoint } from "./shapes.js";

/** @import { Pose, State } from "./messages.js" */
/** @import { Pen, Picture, Point } from "./pen.js" */
/** @import { Polygon } from "./shapes.js" */
/** @typedef {"a" | "b"} Key */
/**
 * @typedef {object} HandleSpec
 * @property {string} id
 * @property {Key | null} key The shape that it changes; null for the free axis.
 * @property {"move" | "vertex" | "rotate" | "radius" | "axis"} action
 * @property {number} [number] Of the vertex.
 * @property {Point} at In scene units.
 * @property {string} label
 * @property {number} value
 * @property {string} valueText
 */
/** @typedef {{ element: HTMLElement, spec: HandleSpec }} Handle */

const DOT_REACH = 8; // pixels from the middle of a map's dot within which it moves B
const EDGE_REACH = 14; // points between a turn handle and the edge of the picture
const AXIS_REACH = 16; // points between a turn handle and an axis
const WORD_REACH = 13; // points between a turn handle and words
const TURN_REACH = 32; // pixels between a turn handle and its shape
const KEYS = /** @type {const} */ (["a", "b"]);

export class Handles {
  /**
   * @param {Pen} pen
   * @param {string} keysId The id of the element that explains the keys.
   */
  constructor(pen, keysId) {
    this.pen = pen;
    this.keysId = keysId;
    this.element = element("div", { class: "sv-handles" });
    /** @type {Map<string, Handle>} By id, in the order of the Tab key. */
    this.handles = new Map();
    /** @type {Record<Key, string>} Each shape is one stop of the Tab key: this handle of it. */
    this.active = { a: "A-move", b: "B-move" };
    /** @type {Record<Key, number>} The side of the shape on which its turn handle sits. */
    this.sides = { a: 0, b: 0 };
    this.pixelsPerPoint = 1;
    this.obstacles = this.findObstacles(null);
  }

  /** @param {Picture} picture The one that the pen has drawn. */
  avoid(picture) {
    this.obstacles = this.findObstacles(picture);
  }

  /**
   * What lies in the picture: axes and normals, dots that are no vertices (of a map: the middle of B), and words as their
   * middle and about half of their width and height.
   * @param {Picture | null} picture
   */
  findObstacles(picture) {
    const { marks, styles } = picture ?? { marks: [], styles: [] };
    const axes = marks.filter(({ part }) => part === "axis" || part === "normal").map(({ points }) => points);
    const dots = marks.filter(({ part, style }) => styles[style].kind === "dot" && part !== "vertex").map(({ part, points }) => ({ at: points[0], movesB: part === "reference" }));
    const labels = marks.filter(({ style }) => styles[style].kind === "label");
    const words = labels.map(({ points, text = "", style }) => {
      const lines = text.split("\n");
      const { size = 0 } = styles[style];
      return { at: this.pen.toPicture(points[0]), halfWidth: Math.max(...lines.map(({ length }) => length)) * size * 0.32, halfHeight: lines.length * size * 0.6 };
    });
    return { axes, dots, words };
  }

  /**
   * The handles of a pose.
   * @param {Pose} pose
   * @param {State} state
   */
  specs(pose, { knob }) {
    /** @type {HandleSpec[]} */
    const specs = [];
    for (const key of KEYS) {
      const shape = pose[key];
      const name = key.toUpperCase();
      const center = centerOf(shape);
      specs.push({ id: `${name}-move`, key, action: "move", at: center, label: name, value: center[0], valueText: `middle at ${spokenPoint(center)}` });
      if (shape.polygon) {
        shape.polygon.forEach((at, number) => {
          const vertex = shape.labels?.[number] || `${key}${number + 1}`;
          specs.push({ id: `${name}-vertex-${number}`, key, action: "vertex", number, at, label: `${name}: corner ${vertex}`, value: at[0], valueText: `at ${spokenPoint(at)}` });
        });
        const [[x, y]] = shape.polygon;
        const degree = snap((Math.atan2(y - center[1], x - center[0]) * 180) / Math.PI, 1e-3) + 0;
        const taken = specs.find(({ action }) => action === "rotate")?.at;
        specs.push({ id: `${name}-rotate`, key, action: "rotate", at: this.turnSpot(shape, key, pose, taken), label: `${name}: turn`, value: degree, valueText: `first corner at ${spoken(degree)} degrees` });
      } else {
        specs.push({ id: `${name}-radius`, key, action: "radius", at: [center[0] + shape.radius, center[1]], label: `${name}: radius`, value: shape.radius, valueText: spoken(shape.radius) });
      }
    }
    if (knob && pose.degree !== null) specs.push({ id: "axis", key: null, action: "axis", at: knob, label: "turn the axis", value: pose.degree, valueText: `${spoken(pose.degree)} degrees` });
    return specs;
  }

  /**
   * A shape's turn handle sits above it, or where neither an axis, dots, words nor the other turn handle lie.  There it
   * stays while it can.
   * @param {Polygon} shape
   * @param {Key} key
   * @param {Pose} pose
   * @param {Point | undefined} taken Where the other turn handle sits.
   */
  turnSpot(shape, key, pose, taken) {
    const [x, y] = centerOf(shape);
    const xs = shape.polygon.map((p) => p[0]);
    const ys = shape.polygon.map((p) => p[1]);
    const off = TURN_REACH / (this.pen.scale * this.pixelsPerPoint);
    const [left, right, low, high] = [Math.min(...xs) - off, Math.max(...xs) + off, Math.min(...ys) - off, Math.max(...ys) + off];
    /** @type {Point[]} */
    const spots = [[x, high], [x, low], [right, y], [left, y], [right, high], [left, high], [right, low], [left, low]];
    const other = pose[key === "a" ? "b" : "a"];
    const sides = [this.sides[key], ...spots.keys()];
    const clear = sides.filter((s) => this.isClear(spots[s], off, taken));
    const wordless = clear.filter((s) => this.isClearOfWords(spots[s]));
    const side = wordless.find((s) => !contains(other, spots[s])) ?? wordless[0] ?? clear[0] ?? 0; // inside A all are in A
    this.sides[key] = side;
    return spots[side];
  }

  /**
   * @param {Point} spot
   * @param {number} off
   * @param {Point | undefined} taken
   */
  isClear(spot, off, taken) {
    const { axes, dots } = this.obstacles;
    const [px, py] = this.pen.toPicture(spot);
    const inside = px > EDGE_REACH && py > EDGE_REACH && px < this.pen.width - EDGE_REACH && py < this.pen.height - EDGE_REACH;
    const free = !taken || Math.hypot(spot[0] - taken[0], spot[1] - taken[1]) > off;
    return inside && free && axes.every((line) => distanceToSegment(spot, line) * this.pen.scale > AXIS_REACH)
      && dots.every(({ at }) => Math.hypot(at[0] - spot[0], at[1] - spot[1]) > off / 2);
  }

  /** @param {Point} spot */
  isClearOfWords(spot) {
    const [px, py] = this.pen.toPicture(spot);
    return this.obstacles.words.every(({ at: [x, y], halfWidth, halfHeight }) => Math.abs(x - px) > halfWidth + WORD_REACH || Math.abs(y - py) > halfHeight + WORD_REACH);
  }

  /**
   * Put the handles of a pose where they belong.
   * @param {Pose} pose
   * @param {State} state
   * @param {{ spec: HandleSpec, spot?: Point } | null} drag While a turn or a radius is dragged, its handle follows the pointer.
   */
  place(pose, state, drag) {
    const old = this.handles;
    this.handles = new Map();
    for (const spec of this.specs(pose, state)) {
      const handle = old.get(spec.id) ?? this.make(spec);
      old.delete(spec.id);
      handle.spec = spec;
      this.handles.set(spec.id, handle);
    }
    for (const handle of old.values()) handle.element.remove();
    for (const key of KEYS) if (!this.handles.has(this.active[key])) this.active[key] = `${key.toUpperCase()}-move`;
    for (const [i, handle] of [...this.handles.values()].entries()) {
      const { spec } = handle;
      const follows = drag?.spec.id === spec.id && (spec.action === "rotate" || spec.action === "radius");
      const [x, y] = this.pen.toPicture((follows && drag.spot) || spec.at);
      handle.element.style.left = `${(100 * x) / this.pen.width}%`;
      handle.element.style.top = `${(100 * y) / this.pen.height}%`;
      if (!drag) this.describe(handle);
      // The elements are in the order of the specs, also after other shapes.
      const there = this.element.children[i];
      if (there !== handle.element) this.element.insertBefore(handle.element, there);
    }
  }

  /**
   * @param {HandleSpec} spec
   * @returns {Handle}
   */
  make(spec) {
    const grip = spec.action === "rotate" ? icon("turn") : element("span", { class: "sv-grip" });
    const made = element("div", { class: `sv-handle sv-does-${spec.action} sv-role-${spec.key ?? "axis"}`, "data-handle": spec.id, role: "slider", "aria-describedby": this.keysId }, grip);
    const handle = { element: made, spec };
    made.addEventListener("focus", () => this.focused(handle));
    this.element.append(made);
    return handle;
  }

  /** @param {Handle} handle */
  describe({ element: made, spec: { id, key, label, value, valueText } }) {
    const [least, most] = key ? [-1e9, 1e9] : [-180, 180];
    const now = Math.min(most, Math.max(least, value));
    const words = { "aria-label": label, "aria-valuemin": String(least), "aria-valuemax": String(most), "aria-valuenow": plainNumber(now), "aria-valuetext": valueText };
    for (const [name, text] of Object.entries(words)) if (made.getAttribute(name) !== text) made.setAttribute(name, text);
    made.tabIndex = !key || this.active[key] === id ? 0 : -1;
  }

  /** @param {Handle} handle */
  focused({ spec: { id, key } }) {
    if (!key || this.active[key] === id) return;
    this.active[key] = id;
    for (const handle of this.handles.values()) this.describe(handle);
  }

  /**
   * The handle of an element, or of one inside its own.
   * @param {EventTarget | null} target
   */
  of(target) {
    const found = target instanceof Element ? target.closest(".sv-handle") : null;
    return (found && [...this.handles.values()].find((handle) => handle.element === found)) ?? null;
  }

  /**
   * The handle that a pointer means.  Where handles overlap it is the nearest one, and none where a dot that nothing
   * drags is nearer still; the dot of a map is the middle of B.  A shape is moved by any point of it; where both shapes
   * lie it is B, which is drawn last.
   * @param {EventTarget | null} target
   * @param {Point} spot Where the pointer is, in scene units.
   * @param {Pose} pose
   */
  under(target, spot, pose) {
    const handles = [...this.handles.values()];
    const mover = (/** @type {Key} */ key) => handles.find(({ spec }) => spec.key === key && spec.action === "move") ?? null;
    const candidates = [
      ...handles.filter(({ spec }) => spec.action !== "move").map((handle) => ({ at: handle.spec.at, handle })),
      ...this.obstacles.dots.map(({ at, movesB }) => ({ at, handle: movesB ? mover("b") : null })),
    ];
    const reach = this.of(target) ? Infinity : DOT_REACH / this.pixelsPerPoint / this.pen.scale;
    /** @type {Handle | null} */
    let nearest = null;
    let least = Infinity;
    for (const { at: [x, y], handle } of candidates) {
      const distance = Math.hypot(x - spot[0], y - spot[1]);
      if (distance < least) [nearest, least] = [handle, distance];
    }
    if (nearest && least <= reach) return nearest;
    const key = KEYS.toReversed().find((k) => contains(pose[k], spot));
    return key ? mover(key) : null;
  }
}
