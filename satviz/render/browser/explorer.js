// The explorer: handles over the picture of a scene.  The dragged outline and handle move here, in the same frame;
// Python answers each pose with the picture that follows from it.

import { AxisDial } from "./axis_dial.js";
import { download } from "./download.js";
import { element } from "./elements.js";
import { ExplorerControls } from "./explorer_controls.js";
import { GoalPanel } from "./goal_panel.js";
import { Handles } from "./handles.js";
import { PoseHistory } from "./history.js";
import { LiveTable } from "./live_table.js";
import { PasteBox } from "./paste_box.js";
import { Pen } from "./pen.js";
import { PoseSender } from "./pose_sender.js";
import { ShapeEditor } from "./shape_editor.js";
import { centerOf, roundDown, rotated, snap, translated, withRadius, withVertex } from "./shapes.js";
import { followTheme } from "./theme.js";

/** @import { Handle, HandleSpec } from "./handles.js" */
/** @import { Listener, Message, Pose, State, WidgetModel } from "./messages.js" */
/** @import { Point } from "./pen.js" */
/** @import { Snapping } from "./pose_sender.js" */
/** @import { Shape } from "./shapes.js" */
/**
 * @typedef {object} Drag
 * @property {HandleSpec} spec
 * @property {Point} from Where the drag began.
 * @property {Pose} pose The pose with which it began.
 * @property {Point} [spot] Where the pointer is now.
 */

const KEY_STEP = 8; // points that an arrow key moves; with Shift a tenth
const KEY_TURN = 5; // degrees that [ and ] turn; with Shift 1
const ANNOUNCE_MS = 400; // a sentence is said aloud when the scene has rested so long
const FULL_WIDTH = 540; // points; a picture in a narrower place is laid out for it
const HINT = "Drag a shape, a corner or the turn handle.";
const HINT_OF_KEYS = " Keys: Tab to a shape; arrows move it, [ and ] turn it, Page Down goes to its corners.";
const KEYS_HELP = "Arrow keys move the shape; with Shift they move it less. The keys [ and ] turn it. Page Down and Page Up go to its other handles.";
/** @type {Record<string, Point>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {Record<string, number>} */
const TURNS = { "[": 1, "{": 1, "]": -1, "}": -1 };
/** @type {Record<string, number>} */
const HANDLE_STEPS = { PageDown: 1, n: 1, PageUp: -1, p: -1, Escape: 0 }; // Escape: back to the first

/**
 * The width that a picture in a place is laid out for, in points; null: as wide as a picture ever is.
 * @param {number} wide Of the place.
 */
export function pictureWidth(wide) {
  return wide && wide < FULL_WIDTH ? Math.floor(wide / 20) * 20 : null;
}

export class Explorer {
  /**
   * @param {WidgetModel} model
   * @param {HTMLElement} root
   */
  constructor(model, root) {
    this.model = model;
    this.root = root;
    /** @type {State} */
    this.state = model.get("first");
    /** @type {Pose} A link says what it shows of its scene. */
    this.pose = { ...poseOf(this.state), ...model.get("pose") };
    this.valid = this.pose; // the last pose that Python accepted
    this.start = this.pose;
    this.history = new PoseHistory();
    this.sender = new PoseSender((content) => model.send(content));
    /** @type {Drag | null} */
    this.drag = null;
    /** @type {Snapping} Of the last pose that was sent. */
    this.snapping = null;
    this.everyArrow = true; // see arrowKeys
    this.lastHandle = "B-move"; // the id of the handle that the reader used last
    this.choosing = false; // is another scene on its way?
    this.refused = false;
    this.keepsRefusal = false; // a refused outline stays on the screen until the next change
    this.announcing = 0;
    /** @type {number | null} Of the place for the picture, in points; null: as wide as a picture ever is. */
    this.width = model.get("width") ?? null;

    this.svg = element("svg", { class: "sv-picture", role: "img" });
    this.pen = new Pen(this.svg);
    this.line = element("svg", { class: "sv-picture sv-line", role: "img" });
    this.linePen = new Pen(this.line);
    this.curve = element("svg", { class: "sv-picture sv-curve", role: "img", hidden: true });
    this.curvePen = new Pen(this.curve);
    this.difference = element("svg", { class: "sv-picture sv-difference", role: "img", hidden: true });
    this.differencePen = new Pen(this.difference);
    const keysHelp = element("p", { id: `sv-keys-${Math.random().toString(36).slice(2)}`, hidden: true }, KEYS_HELP);
    this.handles = new Handles(this.pen, keysHelp.id);
    this.board = element("div", { class: "sv-board" }, this.svg, this.handles.element);
    this.sentence = element("p", { class: "sv-sentence" });
    this.enough = element("p", { class: "sv-enough", hidden: true });
    this.announcement = element("div", { class: "sv-said", role: "status" });
    this.heading = element("p", { class: "sv-heading", hidden: true });
    this.goal = new GoalPanel(() => this.chooseGoal(""));
    this.map = element("p", { class: "sv-map", hidden: true });
    this.refusal = element("p", { class: "sv-why", role: "alert", hidden: true });
    this.hint = element("p", { class: "sv-hint" }, HINT, element("span", { class: "sv-of-keys" }, HINT_OF_KEYS));
    this.tip = element("div", { class: "sv-tip" }, this.hint, this.enough); // one place: the hint goes, and what is enough comes
    this.table = new LiveTable(this.state.names, { pick: (row) => this.change({ pinned: this.pose.pinned === row ? null : row }) });
    this.controls = new ExplorerControls(this);
    this.dial = new AxisDial(this);
    const side = element("div", { class: "sv-side" }, this.dial.element, this.curve, this.difference, element("div", { class: "sv-fold" }, this.table.element));
    this.stage = element("div", { class: "sv-stage" }, this.goal.element, this.heading, this.board, this.line, this.sentence, this.tip, this.map, this.announcement, keysHelp);
    const tools = element("div", { class: "sv-tools" }, this.controls.scenes, this.controls.element);
    this.columns = element("div", { class: "sv-columns sv-bench" }, this.stage, tools, side);
    this.board.append(this.refusal); // over the picture, so that nothing jumps
    root.classList.add("satviz");
    root.setAttribute("data-lm-suppress-shortcuts", "true");
    root.append(this.columns);
    this.editor = new ShapeEditor(this);
    this.pasteBox = new PasteBox(this);
    this.tip.append(this.editor.element);
    this.columns.append(this.pasteBox.element);

    this.board.addEventListener("pointerdown", (event) => this.pointerDown(event));
    this.board.addEventListener("pointermove", (event) => this.pointerMove(event));
    this.board.addEventListener("pointerup", () => this.pointerUp());
    this.board.addEventListener("pointercancel", () => this.pointerUp());
    // A finger beside the shapes scrolls the page.
    this.board.addEventListener("touchstart", (event) => this.handleUnder(event.target, event.touches[0]) && event.preventDefault(), { passive: false });
    /** @param {KeyboardEvent} event */
    this.onkey = (event) => this.keyPressed(event);
    root.addEventListener("keydown", this.onkey);
    /** @type {Listener} */
    this.onmessage = (content, buffers) => this.receive(content, buffers);
    model.on("msg:custom", this.onmessage);
    this.unfollowTheme = followTheme(root);
    this.show(this.state);
    this.sizes = new ResizeObserver(() => this.resized());
    this.sizes.observe(root);
  }

  // -- to and from Python

  /**
   * @param {Pose} pose
   * @param {boolean} final False for one of many poses of a drag.
   * @param {Snapping} [snapping]
   */
  send(pose, final, snapping = null) {
    if (this.choosing) return; // the shapes of the pose are leaving
    this.pose = pose;
    this.snapping = snapping;
    this.sender.push(pose, final, this.width, snapping);
    this.follow();
  }

  // Is the pose newer than the picture?
  get ahead() {
    return this.drag !== null || this.sender.ahead;
  }

  /**
   * @param {Message} content
   * @param {BlobPart[]} buffers
   */
  receive(content, buffers) {
    if (content.kind === "file") {
      download(content, buffers);
      return;
    }
    if (content.n) this.sender.receive(content.n);
    else this.choosing = false;
    if (content.kind === "refused") {
      const why = `Not possible: ${content.why}`;
      if (this.refusal.hidden || this.refusal.textContent !== why) this.refusal.textContent = why; // said aloud once
      this.refusal.hidden = false;
      this.refused = true;
      this.editor.showRefused(this.pose);
      if (!this.ahead) this.show(this.state);
    } else if (content.kind === "state") {
      this.refusal.hidden = !this.keepsRefusal;
      if (content.snapped && !this.drag) this.controls.status.textContent = content.snapped;
      this.refused = false;
      this.state = content;
      if (!content.n) {
        this.history.remember(this.valid);
        this.start = poseOf(content, this.pose);
        this.pose = this.start;
      }
      this.valid = { ...this.pose, a: content.a, b: content.b };
      const shapes = (/** @type {{ a: unknown, b: unknown }} */ { a, b }) => JSON.stringify([a, b]);
      if (!this.ahead && shapes(content) === shapes(this.start)) this.handles.sides = { a: 0, b: 0 }; // as at first
      this.show(content);
    }
  }

  // -- what is shown

  /** @param {State} state */
  show(state) {
    this.pen.draw(state.picture);
    this.handles.avoid(state.picture);
    this.columns.style.setProperty("--sv-width", String(this.pen.width));
    this.columns.style.setProperty("--sv-height", String(this.pen.height));
    if (!this.ahead) this.pose = { ...this.pose, a: state.a, b: state.b };
    this.heading.textContent = (state.heading ?? []).join(" ");
    this.heading.hidden = !state.heading;
    this.map.textContent = state.map ?? "";
    this.map.hidden = !state.map;
    if (this.sentence.textContent) this.announce([...this.goal.announcement(state.goal), state.sentence].join(" "));
    this.sentence.textContent = state.sentence;
    this.enough.textContent = state.enough;
    this.goal.show(state.goal);
    this.table.update(state.names, state.rows, state.lit);
    this.line.classList.toggle("sv-empty", !state.line);
    if (state.line) this.linePen.draw(state.line);
    this.dial.show(state.dial);
    this.curve.toggleAttribute("hidden", !state.curve);
    if (state.curve) this.curvePen.draw(state.curve);
    this.difference.toggleAttribute("hidden", !state.difference);
    if (state.difference) this.differencePen.draw(state.difference);
    this.controls.show(state);
    this.controls.follow(this);
    this.follow();
  }

  /**
   * Say a sentence aloud when the drag has ended, not at every picture.
   * @param {string} sentence
   */
  announce(sentence) {
    clearTimeout(this.announcing);
    if (this.drag) return;
    this.announcing = setTimeout(() => {
      this.announcement.textContent = sentence;
    }, ANNOUNCE_MS);
  }

  // A narrow place gets a picture laid out for it, instead of smaller letters.
  resized() {
    const wide = this.stage.clientWidth || this.columns.clientWidth;
    if (!wide) return;
    this.handles.pixelsPerPoint = this.board.clientWidth / this.pen.width;
    const width = pictureWidth(wide);
    if (width !== this.width) {
      this.width = width;
      this.send(this.pose, true);
    } else this.placeHandles();
  }

  // A shape that has snapped stays where it touches until Python says that it is far enough away.
  get holds() {
    return this.snapping !== null && this.state.relation === "touching" && this.state.snapped !== undefined;
  }

  // What is moved runs ahead of the picture: its outline and its handles go there at once.
  follow() {
    const corners = (/** @type {{ a: Shape, b: Shape }} */ { a, b }) => `${a.polygon?.length} ${b.polygon?.length}`;
    if (corners(this.pose) !== corners(this.state)) return; // the shapes of another scene, undone and not drawn yet
    /** @type {Record<string, Shape>} */
    const shapes = this.ahead && !this.holds ? { A: this.pose.a, B: this.pose.b } : {};
    this.pen.patch(({ part, owner = "", number = 0 }) => {
      const shape = shapes[owner];
      if (!shape) return null;
      if (part === "outline") return shape.circle ? { points: [shape.circle], radius: shape.radius } : { points: shape.polygon };
      return part === "vertex" && shape.polygon ? { points: [shape.polygon[number]] } : null;
    });
    this.placeHandles();
  }

  placeHandles() {
    this.handles.place(this.holds ? { ...this.pose, a: this.state.a, b: this.state.b } : this.pose, this.state, this.drag);
  }

  // -- the pointer and the keys

  /**
   * Where a pointer is in the scene.
   * @param {{ clientX: number, clientY: number }} pointer
   */
  scenePoint({ clientX, clientY }) {
    const box = this.svg.getBoundingClientRect();
    const k = this.pen.width / box.width;
    return this.pen.toScene([(clientX - box.left) * k, (clientY - box.top) * k]);
  }

  /**
   * @param {EventTarget | null} target
   * @param {{ clientX: number, clientY: number }} pointer
   */
  handleUnder(target, pointer) {
    return this.handles.under(target, this.scenePoint(pointer), this.pose);
  }

  /** @param {PointerEvent} event */
  pointerDown(event) {
    if (event.button > 0 || this.drag || this.choosing) return;
    const handle = this.handleUnder(event.target, event);
    if (handle || this.handles.of(event.target)) event.preventDefault(); // a handle that is not meant gets no focus either
    if (!handle) return;
    clearTimeout(this.announcing);
    this.used();
    this.forgetMessages();
    this.lastHandle = handle.spec.id;
    handle.element.focus({ preventScroll: true });
    this.board.setPointerCapture(event.pointerId);
    this.board.classList.add("sv-dragging");
    this.drag = { spec: handle.spec, from: this.scenePoint(event), pose: this.pose };
  }

  /** @param {PointerEvent} event */
  pointerMove(event) {
    if (!this.drag) {
      this.board.classList.toggle("sv-over", this.handleUnder(event.target, event) !== null);
      return;
    }
    const { spec, from, pose } = this.drag;
    const grid = 10 ** Math.floor(Math.log10(1 / this.pen.scale));
    const pointer = this.scenePoint(event);
    /** @type {Point} */
    const spot = [snap(pointer[0], grid), snap(pointer[1], grid)];
    this.drag.spot = spot;
    if (spec.key === null) {
      const angle = angleFrom(this.pen.toScene([this.pen.width / 2, this.pen.height / 2]), spot);
      this.send({ ...this.pose, degree: snap((angle * 180) / Math.PI, 0.1) }, false);
    } else this.send({ ...this.pose, [spec.key]: dragged(pose[spec.key], spec, from, spot, grid) }, false, this.snaps(spec));
  }

  pointerUp() {
    if (!this.drag) return;
    const { pose: before, spec } = this.drag;
    this.drag = null;
    this.board.classList.remove("sv-dragging");
    const to = this.refused ? this.valid : this.pose;
    if (JSON.stringify(to) !== JSON.stringify(before)) this.remember(before);
    if (this.refused) this.keepRefused(this.pose);
    this.send(to, true, this.snaps(spec));
  }

  /**
   * The shape that a handle moves, where the reader lets it snap.
   * @param {HandleSpec} spec
   * @returns {Snapping}
   */
  snaps({ key, action }, byKey = false) {
    return key && action === "move" && this.controls.snap.box.checked ? { snap: key, byKey } : null;
  }

  /**
   * A refused outline stays on the screen, with the reason, until something else is changed.
   * @param {Pose} pose
   */
  keepRefused(pose) {
    this.keepsRefusal = true;
    this.editor.showRefused(pose);
  }

  // What was said of the last change is not true of the next one.
  forgetMessages() {
    this.controls.status.textContent = "";
    if (!this.keepsRefusal) return;
    this.keepsRefusal = false;
    this.refusal.hidden = true;
    this.editor.clear();
  }

  /** @param {KeyboardEvent} event */
  keyPressed(event) {
    const command = event.ctrlKey || event.metaKey;
    const key = event.key.toLowerCase();
    if (command && !event.altKey && (key === "z" || key === "y")) {
      this.take(event);
      if (event.shiftKey || key === "y") this.redo();
      else this.undo();
      return;
    }
    const handle = this.handles.of(event.target) ?? this.handleWithoutFocus(event.target);
    if (!handle || command || event.altKey) return;
    const { spec } = handle;
    this.lastHandle = spec.id;
    const step = HANDLE_STEPS[event.key];
    if (step !== undefined && spec.key) {
      this.take(event);
      this.focusOther(handle, step);
      return;
    }
    const arrow = ARROWS[event.key];
    const turn = TURNS[event.key];
    if (!arrow && !turn) return;
    this.take(event);
    const turns = turn ?? (spec.action === "rotate" || spec.action === "axis" ? -arrow[0] || arrow[1] : 0);
    const degrees = turns * (event.shiftKey ? 1 : KEY_TURN);
    if (spec.key === null) {
      this.change({ degree: snap((this.pose.degree ?? 0) + degrees, 0.1) });
      return;
    }
    const size = roundDown(KEY_STEP / this.pen.scale) * (event.shiftKey ? 0.1 : 1);
    const [x, y] = arrow ?? [0, 0];
    const shape = this.pose[spec.key];
    const made = degrees ? rotated(shape, (degrees * Math.PI) / 180) : nudged(shape, spec, x * size, y * size, size / 10);
    this.change({ [spec.key]: made }, arrow ? this.snaps(spec, true) : null);
  }

  /**
   * Where nothing has the focus, a key is meant for the handle used last, at first for B as a whole.
   * @param {EventTarget | null} target
   */
  handleWithoutFocus(target) {
    return target === document.body ? (this.handles.handles.get(this.lastHandle) ?? this.handles.handles.get("B-move")) : undefined;
  }

  /**
   * The explorer answers the key, and nobody else does.
   * @param {KeyboardEvent} event
   */
  take(event) {
    event.preventDefault();
    event.stopPropagation();
    this.used();
  }

  /**
   * @param {Handle} handle
   * @param {number} step To the next one of its shape or the one before; 0: to the first.
   */
  focusOther(handle, step) {
    const own = [...this.handles.handles.values()].filter(({ spec }) => spec.key === handle.spec.key);
    const to = step ? own.indexOf(handle) + step + own.length : 0;
    own[to % own.length].element.focus();
  }

  // -- changes that can be undone

  /** @param {Pose} pose */
  remember(pose) {
    this.history.remember(pose);
    this.used();
  }

  /**
   * @param {Partial<Pose>} changes
   * @param {Snapping} [snapping]
   */
  change(changes, snapping = null) {
    this.forgetMessages();
    this.remember(this.pose);
    this.send({ ...this.pose, ...changes }, true, snapping);
    this.controls.follow(this);
  }

  reset() {
    const { a, b, scene, view, goal } = this.start;
    this.change({ a, b, scene, view, goal, pinned: null });
  }

  undo() {
    if (!this.drag && !this.choosing) this.restore(this.history.undo(this.pose));
  }

  redo() {
    if (!this.drag && !this.choosing) this.restore(this.history.redo(this.pose));
  }

  /** @param {Pose | undefined} pose */
  restore(pose) {
    if (!pose) return;
    this.forgetMessages();
    this.send(pose, true);
    this.controls.follow(this);
  }

  // The first use: the hint gives way to the sentence on how many axes are enough.
  used() {
    this.hint.hidden = true;
    this.enough.hidden = false;
  }

  /** @param {string} name */
  choosePreset(name) {
    if (name) this.choose({ kind: "preset", name });
  }

  /** @param {string} goal */
  chooseGoal(goal) {
    if (goal) this.choose({ kind: "challenge", goal });
    else this.change({ goal: null });
  }

  /** @param {Record<string, unknown>} request */
  choose(request) {
    this.forgetMessages();
    this.used();
    this.sender.discard(); // a pose that still waits is of the scene that leaves
    this.drag = null;
    this.choosing = true;
    this.model.send(request);
  }

  remove() {
    clearTimeout(this.announcing);
    this.sender.stop();
    this.sizes.disconnect();
    this.unfollowTheme();
    this.root.removeEventListener("keydown", this.onkey);
    this.model.off("msg:custom", this.onmessage);
    this.pen.remove();
    this.dial.remove();
    this.editor.remove();
    this.pasteBox.remove();
    this.root.replaceChildren();
  }
}

/**
 * The pose of a state, with the options of another pose.
 * @param {State} state
 * @param {Pick<Pose, "degree" | "mtv" | "difference">} options
 * @returns {Pose}
 */
function poseOf({ a, b, view, scene, goal }, { degree, mtv, difference } = { degree: null, mtv: false, difference: false }) {
  return { a, b, view, scene, goal: goal?.goal ?? null, pinned: null, degree, mtv, difference };
}

/**
 * A shape after its handle was dragged.
 * @param {Shape} shape
 * @param {HandleSpec} spec
 * @param {Point} from
 * @param {Point} to
 * @param {number} grid
 */
function dragged(shape, { action, number }, from, to, grid) {
  const center = centerOf(shape);
  if (action === "move") return translated(shape, snap(to[0] - from[0], grid), snap(to[1] - from[1], grid));
  if (action === "vertex") return withVertex(shape, number, () => to);
  if (action === "radius") return withRadius(shape, snap(Math.hypot(to[0] - center[0], to[1] - center[1]), grid));
  return rotated(shape, angleFrom(center, to) - angleFrom(center, from));
}

/**
 * A shape after an arrow key on its handle.
 * @param {Shape} shape
 * @param {HandleSpec} spec
 * @param {number} dx
 * @param {number} dy
 * @param {number} grid
 */
function nudged(shape, { action, number }, dx, dy, grid) {
  if (action === "vertex") return withVertex(shape, number, ([x, y]) => [snap(x + dx, grid), snap(y + dy, grid)]);
  if (action === "radius" && shape.circle) return withRadius(shape, snap(shape.radius + dx + dy, grid));
  return translated(shape, dx, dy);
}

/**
 * @param {Point} center
 * @param {Point} point
 */
function angleFrom([cx, cy], [x, y]) {
  return Math.atan2(y - cy, x - cx);
}
