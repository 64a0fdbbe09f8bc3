// The widget of sv.explore: handles over the picture.  The dragged outline and handle move here, in the same
// frame; Python answers each pose with the picture that follows from it.  The newest pose wins.
//
// Jupyter's server leaves Nagle's algorithm on: what it has sent must be acknowledged before it sends more, and a
// browser with nothing to say acknowledges up to 40 ms late.  So an answer lies in the server until the next message
// from here: the next pose, which must not wait for that answer, or an empty message.

const IN_FLIGHT = 3; // poses not answered yet
const FREE_MS = 8; // the empty message comes this long after a pose, when the answer should lie in the server
const LATE_MS = 3000; // answers that have not come by then are not waited for
const STEP = 8; // points that an arrow key moves; with Shift a tenth
const DOT = 8; // pixels from the middle of a map's dot, by which B is moved, too
const TURN = 5; // degrees that [ and ] turn; with Shift 1

const TELL_MS = 400; // what is told waits for the hand to rest
const LEAST_WIDTH = 540; // points; a picture in a narrower place is laid out for it
const HINT = "Drag a shape, a corner or the turn handle. Keys: Tab to a shape; arrows move it, [ and ] turn it, Page Down goes to its corners.";
const KEYS = "Arrow keys move, with Shift less; [ and ] turn; Page Down and Page Up go to the other handles of the shape.";

class Explorer {
  constructor(model, root) {
    this.model = model;
    this.root = root;
    this.state = model.get("first");
    this.pose = { ...this.poseOf(this.state), ...model.get("pose") }; // of a link: what it shows of the scene
    this.valid = this.pose; // the last that Python took
    this.undone = []; // poses to go back to
    this.redone = []; // and forward
    this.start = this.pose;
    this.sent = 0; // the last pose's number
    this.heard = 0; // the last answer's
    this.given = 0; // the last that is not waited for
    this.next = null; // the newest that waits
    this.drag = null;
    this.width = null; // of the place in points; null: as wide as a picture ever is
    this.shown = 1; // pixels a point
    this.active = { a: "A-move", b: "B-move" }; // each shape is one stop of the Tab key: this handle of it
    this.sides = {}; // where each turn handle sits
    const svg = element("svg", { class: "sv-picture", role: "img" });
    this.pen = new Pen(svg);
    this.svg = svg;
    this.handles = element("div", { class: "sv-handles" });
    this.board = element("div", { class: "sv-board" }, svg, this.handles);
    this.curve = element("svg", { class: "sv-picture sv-curve", role: "img", hidden: true });
    this.curvePen = new Pen(this.curve);
    this.difference = element("svg", { class: "sv-picture sv-difference", role: "img", hidden: true });
    this.differencePen = new Pen(this.difference);
    this.sentence = element("p", { class: "sv-sentence" });
    this.enough = element("p", { class: "sv-enough" });
    this.said = element("div", { class: "sv-said", role: "status" });
    this.heading = element("p", { class: "sv-heading", hidden: true });
    this.goal = element("div", { class: "sv-goal", hidden: true });
    this.map = element("p", { class: "sv-map", hidden: true });
    this.why = element("p", { class: "sv-why", role: "alert", hidden: true });
    this.hint = element("p", { class: "sv-hint" }, HINT);
    this.keys = element("p", { id: `sv-keys-${Math.random().toString(36).slice(2)}`, hidden: true }, KEYS);
    this.table = new Table(this.state.names, { pick: (row) => this.pick(row) });
    const side = element("div", { class: "sv-side" }, this.curve, this.difference, element("div", { class: "sv-fold" }, this.table.element));
    this.stage = element("div", { class: "sv-stage" }, this.goal, this.heading, this.board, this.map, this.hint, this.why, this.sentence, this.enough, this.said, this.keys, this.controls());
    root.classList.add("satviz");
    root.setAttribute("data-lm-suppress-shortcuts", "true");
    this.columns = element("div", { class: "sv-columns" }, this.stage, side);
    root.append(this.columns);
    this.board.addEventListener("pointerdown", (event) => this.down(event));
    this.board.addEventListener("pointermove", (event) => this.moved(event));
    this.board.addEventListener("pointerup", () => this.up());
    this.board.addEventListener("pointercancel", () => this.up());
    // a finger beside the shapes scrolls the page
    this.board.addEventListener("touchstart", (event) => this.under(event.target, event.touches[0]) && event.preventDefault(), { passive: false });
    this.onkey = (event) => this.key(event);
    root.addEventListener("keydown", this.onkey);
    this.onmessage = (content, buffers) => this.message(content, buffers);
    model.on("msg:custom", this.onmessage);
    this.unthemed = themed(root);
    this.show(this.state);
    this.sizes = new ResizeObserver(() => this.resized());
    this.sizes.observe(root);
  }

  controls() {
    const check = (label, does) => {
      const box = element("input", { type: "checkbox", onchange: () => does(box.checked) });
      return [box, element("label", {}, box, ` ${label}`)];
    };
    const named = (names) => names.map((name) => element("option", { value: name }, name));
    const groups = { "the article's": this.model.get("presets"), "where a shortcut fails": this.model.get("failing") };
    const options = Object.entries(groups).map(([label, names]) => element("optgroup", { label }, ...named(names)));
    this.presets = element("select", { "aria-label": "presets", onchange: () => this.preset() }, element("option", { value: "" }, "presets"), ...options);
    const goals = Object.entries(this.model.get("challenges")).map(([value, name]) => element("option", { value }, name));
    this.goals = element("select", { "aria-label": "challenges", onchange: () => this.challenge() }, element("option", { value: "" }, "challenges"), ...goals);
    this.views = ["shortcut", "truth"].map((view) => button(view, () => this.commit({ ...this.pose, view, pinned: null }), { pressed: "false" }));
    this.view = element("span", { class: "sv-view", role: "group", "aria-label": "what is shown", hidden: true }, ...this.views);
    this.undoButton = button("undo", () => this.undo(), { keys: "Control+Z" });
    this.redoButton = button("redo", () => this.redo(), { keys: "Control+Shift+Z" });
    const [free, freeLabel] = check("free axis", (on) => this.change({ degree: on ? 30 : null, pinned: null }));
    const [wayOut, wayOutLabel] = check("way out", (on) => this.change({ wayOut: on }));
    const [against, againstLabel] = check("B − A", (on) => this.change({ against: on }));
    this.boxes = { free, wayOut, against };
    const ask = this.model.get("alone") ? null : (form) => this.model.send({ kind: "save", form });
    const save = saveMenu([this.pen, this.curvePen, this.differencePen], ask, { "copy JSON": () => this.state.json, "copy link": () => linked(this.model.get("site"), this.state.link) });
    return element("div", { class: "sv-controls", role: "group", "aria-label": "explorer" },
      this.presets, this.goals, this.view, this.undoButton, this.redoButton, button("reset", () => this.reset()), freeLabel, wayOutLabel, againstLabel, ...save);
  }

  poseOf({ a, b, view, scene, goal }) {
    return { a, b, view, scene, goal: goal?.goal ?? null, pinned: null, degree: this.pose?.degree ?? null, wayOut: this.pose?.wayOut ?? false, against: this.pose?.against ?? false };
  }

  // -- to and from Python

  // A pose that is not final is one of many: Python keeps the kernel busy between them.
  send(pose, final) {
    if (this.choosing) return; // the shapes of the pose are leaving
    this.pose = pose;
    this.next = { pose, final };
    this.flush();
    this.follow();
  }

  flush() {
    if (!this.next || this.sent - Math.max(this.heard, this.given) >= IN_FLIGHT) return;
    const { pose, final } = this.next;
    this.next = null;
    this.sent += 1;
    this.model.send({ kind: "pose", n: this.sent, final, ...pose, width: this.width });
    clearTimeout(this.freeing);
    this.freeing = setTimeout(() => this.model.send({ final }), FREE_MS);
    clearTimeout(this.late);
    this.late = setTimeout(() => {
      this.given = this.sent;
      this.flush();
    }, LATE_MS);
  }

  // Is the pose newer than the last answer?
  get ahead() {
    return this.drag || this.next || this.heard < this.sent;
  }

  message(content, buffers) {
    if (content.kind === "file") return download(content, buffers);
    if (content.n) {
      this.heard = content.n;
      this.flush();
    } else this.choosing = false;
    if (content.kind === "refused") {
      const why = `Not possible: ${content.why}`;
      if (this.why.hidden || this.why.textContent !== why) this.why.textContent = why; // told once
      this.why.hidden = false;
      this.refused = true;
      if (!this.ahead) this.show(this.state);
    } else if (content.kind === "state") {
      this.why.hidden = true;
      this.refused = false;
      this.state = content;
      if (!content.n) {
        this.undone.push(this.valid);
        this.redone = [];
        this.start = this.poseOf(content);
        this.pose = this.start;
      }
      this.valid = { ...this.pose, a: content.a, b: content.b };
      const shapes = ({ a, b }) => JSON.stringify([a, b]);
      if (!this.ahead && shapes(content) === shapes(this.start)) this.sides = {}; // as at first
      this.show(content);
    }
  }

  // -- what is seen

  show(state) {
    this.pen.draw(state.picture);
    this.board.style.setProperty("--sv-width", this.pen.width);
    this.board.style.setProperty("--sv-height", this.pen.height);
    if (!this.ahead) this.pose = { ...this.pose, a: state.a, b: state.b };
    this.view.toggleAttribute("hidden", !state.view);
    this.views.forEach((each) => each.setAttribute("aria-pressed", String(each.textContent === state.view)));
    this.heading.textContent = (state.heading ?? []).join(" ");
    this.heading.toggleAttribute("hidden", !state.heading);
    this.map.textContent = state.map ?? "";
    this.map.toggleAttribute("hidden", !state.map);
    if (this.sentence.textContent) this.tell([...this.goalTold(state), state.sentence].join(" "));
    this.sentence.textContent = state.sentence;
    this.enough.textContent = state.enough;
    if (state.scene !== this.scene) {
      this.scene = state.scene;
      const { name } = JSON.parse(state.scene);
      this.presets.value = [...this.presets.options].some(({ value }) => value === name) ? name : "";
    }
    this.showGoal(state);
    this.showRows(state);
    this.curve.toggleAttribute("hidden", !state.curve);
    if (state.curve) this.curvePen.draw(state.curve);
    this.difference.toggleAttribute("hidden", !state.difference);
    if (state.difference) this.differencePen.draw(state.difference);
    this.settle();
    this.follow();
  }

  // What is asked, how the scene stands to it, and a hint for who wants one.
  showGoal({ goal, view }) {
    this.goals.value = goal?.goal ?? "";
    this.goals.querySelector('[value="break"]').disabled = !view; // without a shortcut there is none to break
    this.goal.toggleAttribute("hidden", !goal);
    if (!goal) return;
    if (!this.goal.childElementCount) {
      const [asks, says, hint] = [element("b"), element("span"), element("p")];
      this.goal.append(asks, says, element("details", {}, element("summary", {}, "a hint"), hint));
      this.goal.parts = { asks, says, hint };
    }
    this.goal.classList.toggle("sv-met", goal.met);
    for (const [name, part] of Object.entries(this.goal.parts)) if (part.textContent !== goal[name]) part.textContent = goal[name];
  }

  // What is said aloud of a challenge: what it asks when it is set, then how the scene stands to it.
  goalTold({ goal }) {
    if (!goal) return [];
    const asks = !this.goal.hidden && goal.asks === this.goal.parts.asks.textContent ? [] : [goal.asks];
    return [...asks, ...(goal.met ? ["Done."] : []), goal.says];
  }

  // The buttons and boxes as the pose has it.
  settle() {
    this.undoButton.disabled = !this.undone.length;
    this.redoButton.disabled = !this.redone.length;
    this.boxes.free.checked = this.pose.degree !== null;
    this.boxes.wayOut.checked = this.pose.wayOut;
    this.boxes.against.checked = this.pose.against;
  }

  // Said aloud when the hand rests, not at every picture.
  tell(sentence) {
    clearTimeout(this.telling);
    if (!this.drag) this.telling = setTimeout(() => { this.said.textContent = sentence; }, TELL_MS);
  }

  // A narrow place gets a picture laid out for it, instead of smaller letters.
  resized() {
    const wide = this.stage.clientWidth || this.columns.clientWidth;
    if (!wide) return;
    this.shown = this.board.clientWidth / this.pen.width;
    const width = wide < LEAST_WIDTH ? Math.floor(wide / 20) * 20 : null;
    if (width !== this.width) {
      this.width = width;
      this.send(this.pose, true);
    } else this.placeHandles();
  }

  // Rows like the last ones change in place: made anew they cost another layout of the page, and the focus.
  showRows({ names, rows, lit }) {
    const like = JSON.stringify(rows.map(({ pair, reason }) => [pair, reason]));
    const table = like === this.like ? new Table(names, this.table) : this.table;
    this.like = like;
    table.names(names);
    table.show(rows, { lit });
    if (table !== this.table) update(this.table.element, table.element);
  }

  // What is moved runs ahead of the picture: its outline and its handles go there at once.
  follow() {
    const corners = ({ a, b }) => `${a.polygon?.length} ${b.polygon?.length}`;
    if (corners(this.pose) !== corners(this.state)) return; // other shapes: undone beyond a preset, not drawn yet
    const shapes = this.ahead ? { A: this.pose.a, B: this.pose.b } : {};
    this.pen.patch(({ part, owner, number }) => {
      const { polygon, circle, radius } = shapes[owner] ?? {};
      if (part === "outline" && (polygon || circle)) return { points: polygon ?? [circle], radius };
      return part === "vertex" && polygon ? { points: [polygon[number]] } : null;
    });
    this.placeHandles();
  }

  // The handles of a pose: what each is, where it sits, what it is called and what it says.
  wanted() {
    const found = [];
    for (const key of ["a", "b"]) {
      const shape = this.pose[key];
      const name = key.toUpperCase();
      const center = middle(shape);
      found.push({ id: `${name}-move`, key, does: "move", at: center, label: name, value: center[0], says: `middle at ${place(center)}` });
      if (shape.polygon) {
        shape.polygon.forEach((at, i) => {
          const vertex = shape.labels?.[i] || `${key}${i + 1}`;
          found.push({ id: `${name}-vertex-${i}`, key, does: "vertex", i, at, label: `${name}: corner ${vertex}`, value: at[0], says: `at ${place(at)}` });
        });
        const [[x, y]] = shape.polygon;
        const degree = snap((Math.atan2(y - center[1], x - center[0]) * 180) / Math.PI, 1e-3) + 0;
        found.push({ id: `${name}-rotate`, key, does: "rotate", at: this.turnSpot(shape, key, found.find(({ does }) => does === "rotate")?.at), label: `${name}: turn`, value: degree, says: `first corner at ${told(degree)} degrees` });
      } else {
        const at = [center[0] + shape.radius, center[1]];
        found.push({ id: `${name}-radius`, key, does: "radius", at, label: `${name}: radius`, value: shape.radius, says: told(shape.radius) });
      }
    }
    const { knob } = this.state;
    if (knob && this.pose.degree !== null) found.push({ id: "axis", key: null, does: "axis", at: knob, label: "turn the axis", value: this.pose.degree, says: `${told(this.pose.degree)} degrees` });
    return found;
  }

  // Where a shape's turn handle sits: above it, or where neither an axis, dots, words nor the other's (`taken`) lie;
  // there it stays while it can.
  turnSpot({ polygon }, key, taken) {
    const [x, y] = middle({ polygon });
    const [xs, ys] = [0, 1].map((k) => polygon.map((p) => p[k]));
    const off = 32 / (this.pen.scale * this.shown);
    const [left, right, low, high] = [Math.min(...xs) - off, Math.max(...xs) + off, Math.min(...ys) - off, Math.max(...ys) + off];
    const spots = [[x, high], [x, low], [right, y], [left, y], [right, high], [left, high], [right, low], [left, low]];
    const other = this.pose[key === "a" ? "b" : "a"];
    const { axes, dots, words } = this.obstacles;
    const clear = (spot, room) => {
      const [px, py] = this.pen.at(spot);
      const inside = px > 14 && py > 14 && px < this.pen.width - 14 && py < this.pen.height - 14;
      const free = !taken || Math.hypot(spot[0] - taken[0], spot[1] - taken[1]) > off;
      return inside && free && axes.every((line) => distance(spot, line) * this.pen.scale > 16)
        && dots.every(({ at }) => Math.hypot(at[0] - spot[0], at[1] - spot[1]) > off / 2)
        && (!room || (!holds(other, spot) && words.every(([wx, wy, wide, high]) => Math.abs(wx - px) > wide + room || Math.abs(wy - py) > high + room)));
    };
    const sides = [...spots.keys()];
    const side = [this.sides[key] ?? 0, ...sides].find((s) => clear(spots[s], 13)) ?? sides.find((s) => clear(spots[s], 0)) ?? 0;
    this.sides[key] = side;
    return spots[side];
  }

  // What lies in the picture: axes and normals, dots that are no corners (of a map: B's middle), and words as middle,
  // half the width and the height, about.
  get obstacles() {
    if (this.seen !== this.state) {
      this.seen = this.state;
      const { marks, looks } = this.state.picture;
      const axes = marks.filter(({ part }) => part === "axis" || part === "normal").map(({ points }) => points);
      const dots = marks.filter(({ part, look }) => looks[look].kind === "dot" && part !== "vertex").map(({ part, points }) => ({ at: points[0], middle: part === "reference" }));
      const labels = marks.filter(({ look }) => looks[look].kind === "label");
      const half = (lines, size) => [Math.max(...lines.map(({ length }) => length)) * size * 0.32, lines.length * size * 0.6];
      this.found = { axes, dots, words: labels.map(({ points, text, look }) => [...this.pen.at(points[0]), ...half(text.split("\n"), looks[look].size)]) };
    }
    return this.found;
  }

  placeHandles() {
    const wanted = this.wanted();
    const old = new Map([...this.handles.children].map((handle) => [handle.dataset.handle, handle]));
    for (const key of ["a", "b"]) {
      if (!wanted.some(({ id }) => id === this.active[key])) this.active[key] = `${key.toUpperCase()}-move`;
    }
    for (const spec of wanted) {
      let handle = old.get(spec.id);
      old.delete(spec.id);
      if (!handle) {
        handle = element("div", { class: `sv-handle sv-does-${spec.does} sv-role-${spec.key ?? "axis"}`, "data-handle": spec.id, role: "slider", "aria-describedby": this.keys.id });
        handle.append(spec.does === "rotate" ? icon("turn") : element("span", { class: "sv-grip" }));
        handle.addEventListener("focus", () => this.focused(handle.spec));
        this.handles.append(handle);
      }
      handle.spec = spec;
      const mine = this.drag && this.drag.spec.id === spec.id && (spec.does === "rotate" || spec.does === "radius") && this.drag.spot;
      const [x, y] = this.pen.at(mine || spec.at);
      handle.style.left = `${(100 * x) / this.pen.width}%`;
      handle.style.top = `${(100 * y) / this.pen.height}%`;
      if (!this.drag) this.describe(handle, spec);
    }
    for (const handle of old.values()) handle.remove();
    wanted.forEach(({ id }, i) => { // in their order, also after other shapes
      const there = this.handles.children[i];
      if (there.dataset.handle !== id) this.handles.insertBefore(this.handles.querySelector(`[data-handle="${id}"]`), there);
    });
  }

  describe(handle, { id, key, label, value, says }) {
    const [least, most] = key ? [-1e9, 1e9] : [-180, 180];
    const now = Math.min(most, Math.max(least, value)).toLocaleString("en", { useGrouping: false, maximumSignificantDigits: 6 }); // no exponent
    const words = { "aria-label": label, "aria-valuemin": least, "aria-valuemax": most, "aria-valuenow": now, "aria-valuetext": says };
    for (const [name, text] of Object.entries(words)) if (handle.getAttribute(name) !== String(text)) handle.setAttribute(name, text);
    handle.tabIndex = !key || this.active[key] === id ? 0 : -1;
  }

  focused({ id, key }) {
    if (!key || this.active[key] === id) return;
    this.active[key] = id;
    this.placeHandles();
  }

  // -- the hand

  pointed({ clientX, clientY }) {
    const box = this.svg.getBoundingClientRect();
    const k = this.pen.width / box.width;
    return this.pen.scene([(clientX - box.left) * k, (clientY - box.top) * k]);
  }

  // The handle that a pointer means.  Where handles overlap it is the nearest one, and none where a dot that nothing
  // drags is nearer still; the dot of a map is B's middle.  A shape is moved by any point of it; where both lie B, which
  // is drawn last.
  under(target, pointer) {
    const spot = this.pointed(pointer);
    const mover = (key) => this.handles.querySelector(`[data-handle="${key.toUpperCase()}-move"]`);
    const marks = [...this.handles.children].filter(({ spec }) => spec.does !== "move").map((handle) => ({ at: handle.spec.at, handle }));
    for (const { at, middle } of this.obstacles.dots) marks.push({ at, handle: middle ? mover("b") : null });
    const reach = target.closest(".sv-handle") ? Infinity : DOT / this.shown / this.pen.scale;
    let [means, least] = [null, Infinity];
    for (const { at: [x, y], handle } of marks) {
      const off = Math.hypot(x - spot[0], y - spot[1]);
      if (off < least) [means, least] = [handle, off];
    }
    if (means && least <= reach) return means;
    const key = ["b", "a"].find((k) => holds(this.pose[k], spot));
    return key ? mover(key) : null;
  }

  down(event) {
    if (event.button > 0 || this.drag || this.choosing) return;
    const handle = this.under(event.target, event);
    if (handle || event.target.closest(".sv-handle")) event.preventDefault(); // what is not meant gets no focus either
    if (!handle) return;
    clearTimeout(this.telling);
    this.hint.hidden = true;
    handle.focus({ preventScroll: true });
    this.board.setPointerCapture(event.pointerId);
    this.board.classList.add("sv-dragging");
    this.drag = { spec: handle.spec, from: this.pointed(event), pose: this.pose };
  }

  moved(event) {
    if (!this.drag) return this.board.classList.toggle("sv-over", Boolean(this.under(event.target, event)));
    const { spec, from, pose } = this.drag;
    const grid = 10 ** Math.floor(Math.log10(1 / this.pen.scale));
    const [x, y] = this.pointed(event).map((v) => snap(v, grid));
    this.drag.spot = [x, y];
    const shape = spec.key && pose[spec.key];
    const [cx, cy] = spec.key ? middle(shape) : this.pen.scene([this.pen.width / 2, this.pen.height / 2]);
    if (spec.does === "axis") {
      const degree = (Math.atan2(y - cy, x - cx) * 180) / Math.PI;
      return this.send({ ...this.pose, degree: snap(degree, 0.1) }, false);
    }
    let made = shape;
    if (spec.does === "move") made = shifted(shape, snap(x - from[0], grid), snap(y - from[1], grid));
    else if (spec.does === "vertex") made = { ...shape, polygon: shape.polygon.map((p, i) => (i === spec.i ? [x, y] : p)) };
    else if (spec.does === "radius") made = { ...shape, radius: snap(Math.hypot(x - cx, y - cy), grid) };
    else made = turned(shape, Math.atan2(y - cy, x - cx) - Math.atan2(from[1] - cy, from[0] - cx));
    this.send({ ...this.pose, [spec.key]: made }, false);
  }

  up() {
    if (!this.drag) return;
    const before = this.drag.pose;
    this.drag = null;
    this.board.classList.remove("sv-dragging");
    const to = this.refused ? this.valid : this.pose;
    if (JSON.stringify(to) !== JSON.stringify(before)) this.remember(before);
    this.send(to, true);
  }

  key(event) {
    const taken = () => {
      event.preventDefault();
      event.stopPropagation();
      this.hint.hidden = true;
    };
    if ((event.ctrlKey || event.metaKey) && !event.altKey && "zy".includes(event.key.toLowerCase())) {
      taken();
      return event.shiftKey || event.key.toLowerCase() === "y" ? this.redo() : this.undo();
    }
    const handle = event.target.closest(".sv-handle");
    if (!handle || event.ctrlKey || event.metaKey || event.altKey) return;
    const { spec } = handle;
    const next = { PageDown: 1, n: 1, PageUp: -1, p: -1, Escape: 0 }[event.key];
    if (next !== undefined && spec.key) {
      taken();
      const own = [...this.handles.children].filter((each) => each.spec.key === spec.key);
      const to = next ? own.indexOf(handle) + next + own.length : 0;
      return own[to % own.length].focus();
    }
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const side = { "[": 1, "{": 1, "]": -1, "}": -1 }[event.key];
    if (!way && !side) return;
    taken();
    const size = nice(STEP / this.pen.scale) * (event.shiftKey ? 0.1 : 1);
    const angle = (side ?? (spec.does === "rotate" || spec.does === "axis" ? -way[0] || way[1] : 0)) * (event.shiftKey ? 1 : TURN);
    if (spec.does === "axis") return this.commit({ ...this.pose, degree: snap(this.pose.degree + angle, 0.1) });
    const shape = this.pose[spec.key];
    const [dx, dy] = (way ?? [0, 0]).map((d) => d * size);
    let made;
    if (angle) made = turned(shape, (angle * Math.PI) / 180);
    else if (spec.does === "vertex") made = { ...shape, polygon: shape.polygon.map((p, i) => (i === spec.i ? [snap(p[0] + dx, size / 10), snap(p[1] + dy, size / 10)] : p)) };
    else if (spec.does === "radius") made = { ...shape, radius: snap(shape.radius + dx + dy, size / 10) };
    else made = shifted(shape, dx, dy);
    this.commit({ ...this.pose, [spec.key]: made });
  }

  // -- changes that can be undone

  remember(pose) {
    this.undone.push(pose);
    this.redone = [];
    this.hint.hidden = true;
  }
  commit(pose) {
    this.remember(this.pose);
    this.send(pose, true);
    this.settle();
  }
  change(more) {
    this.commit({ ...this.pose, ...more });
  }
  reset() {
    const { a, b, scene, view, goal } = this.start;
    this.change({ a, b, scene, view, goal, pinned: null });
  }
  undo() {
    this.go(this.undone, this.redone);
  }
  redo() {
    this.go(this.redone, this.undone);
  }
  go(from, to) {
    if (!from.length || this.drag || this.choosing) return;
    to.push(this.pose);
    this.send(from.pop(), true);
    this.settle();
  }
  pick(row) {
    this.change({ pinned: this.pose.pinned === row ? null : row });
  }
  preset() {
    if (this.presets.value) this.choose({ kind: "preset", name: this.presets.value });
  }
  challenge() {
    if (this.goals.value) this.choose({ kind: "challenge", goal: this.goals.value });
    else this.change({ goal: null });
  }
  choose(asked) {
    this.hint.hidden = true;
    this.next = null; // a pose that still waits is of the scene that leaves
    this.drag = null;
    this.choosing = true;
    this.model.send(asked);
  }

  remove() {
    clearTimeout(this.freeing);
    clearTimeout(this.late);
    clearTimeout(this.telling);
    this.sizes.disconnect();
    this.unthemed();
    this.root.removeEventListener("keydown", this.onkey);
    this.model.off("msg:custom", this.onmessage);
    this.pen.remove();
    this.root.replaceChildren();
  }
}

// Make an element say what another one, built alike, says.
function update(old, made) {
  for (const name of new Set([...old.getAttributeNames(), ...made.getAttributeNames()])) {
    const value = made.getAttribute(name);
    if (value === null) old.removeAttribute(name);
    else if (value !== old.getAttribute(name)) old.setAttribute(name, value);
  }
  if (!made.childElementCount && old.textContent !== made.textContent) old.textContent = made.textContent;
  [...old.children].forEach((child, i) => update(child, made.children[i]));
}

// A number on a grid, without the tail of digits that a float multiplication leaves.
function snap(value, grid) {
  return Number((Math.round(value / grid) * grid).toPrecision(12));
}

// The round number (1, 2 or 5 times a power of ten) below.
function nice(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value / power >= 5 ? 5 : value / power >= 2 ? 2 : 1);
}

// A number as a voice says it.
function told(value) {
  return String(Number(value.toPrecision(4))).replace("-", "\u2212");
}

function place([x, y]) {
  return `(${told(x)}, ${told(y)})`;
}

function middle({ polygon, circle }) {
  if (circle) return circle;
  return [0, 1].map((k) => polygon.reduce((sum, p) => sum + p[k], 0) / polygon.length);
}

function shifted(shape, dx, dy) {
  const go = ([x, y]) => [Number((x + dx).toPrecision(12)), Number((y + dy).toPrecision(12))];
  return shape.circle ? { ...shape, circle: go(shape.circle) } : { ...shape, polygon: shape.polygon.map(go) };
}

function turned(shape, angle) {
  if (shape.circle) return shape;
  const [cx, cy] = middle(shape);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { ...shape, polygon: shape.polygon.map(([x, y]) => [cx + (x - cx) * c - (y - cy) * s, cy + (x - cx) * s + (y - cy) * c]) };
}

// From a point to a segment.
function distance([x, y], [[px, py], [qx, qy]]) {
  const [dx, dy] = [qx - px, qy - py];
  const t = Math.max(0, Math.min(1, ((x - px) * dx + (y - py) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(px + t * dx - x, py + t * dy - y);
}

// Is the point inside?  (Crossing number; a pointer needs no more.)
function holds({ polygon, circle, radius }, [x, y]) {
  if (circle) return Math.hypot(x - circle[0], y - circle[1]) <= radius;
  let inside = false;
  polygon.forEach(([px, py], i) => {
    const [qx, qy] = polygon[(i + 1) % polygon.length];
    if (py > y !== qy > y && x < px + ((y - py) / (qy - py)) * (qx - px)) inside = !inside;
  });
  return inside;
}

function render({ model, el }) {
  const explorer = new Explorer(model, el.appendChild(element("div")));
  return () => explorer.remove();
}

export default { render };
