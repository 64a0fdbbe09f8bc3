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
const TURN = 5; // degrees that [ and ] turn; with Shift 1

class Explorer {
  constructor(model, root) {
    this.model = model;
    this.root = root;
    this.state = model.get("first");
    this.pose = this.poseOf(this.state);
    this.valid = this.pose; // the last that Python took
    this.undone = []; // poses to go back to
    this.start = this.pose;
    this.sent = 0; // the last pose's number
    this.heard = 0; // the last answer's
    this.given = 0; // the last that is not waited for
    this.next = null; // the newest that waits
    this.drag = null;
    const svg = element("svg", { class: "sv-picture", role: "img" });
    this.pen = new Pen(svg);
    this.handles = element("g", { class: "sv-handles" });
    svg.append(this.handles);
    this.svg = svg;
    this.curve = element("svg", { class: "sv-picture sv-curve", role: "img", hidden: true });
    this.curvePen = new Pen(this.curve);
    this.difference = element("svg", { class: "sv-picture sv-difference", role: "img", hidden: true });
    this.differencePen = new Pen(this.difference);
    this.sentence = element("p", { class: "sv-sentence", "aria-live": "polite" });
    this.heading = element("p", { class: "sv-heading", hidden: true });
    this.why = element("p", { class: "sv-why", role: "alert", hidden: true });
    this.table = new Table(this.state.names, { pick: (row) => this.pick(row) });
    const side = element("div", { class: "sv-side" }, this.table.element, this.curve, this.difference);
    const stage = element("div", { class: "sv-stage" }, this.heading, svg, this.why, this.sentence, this.controls());
    root.classList.add("satviz");
    root.setAttribute("data-lm-suppress-shortcuts", "true");
    root.append(element("div", { class: "sv-columns" }, stage, side));
    svg.addEventListener("pointerdown", (event) => this.down(event));
    svg.addEventListener("pointermove", (event) => this.moved(event));
    svg.addEventListener("pointerup", () => this.up());
    svg.addEventListener("pointercancel", () => this.up());
    svg.addEventListener("keydown", (event) => this.key(event));
    this.onmessage = (content, buffers) => this.message(content, buffers);
    model.on("msg:custom", this.onmessage);
    this.show(this.state);
  }

  controls() {
    const check = (label, does) => {
      const box = element("input", { type: "checkbox", onchange: () => does(box.checked) });
      return element("label", {}, box, ` ${label}`);
    };
    const named = (names) => names.map((name) => element("option", { value: name }, name));
    const groups = { "the article's": this.model.get("presets"), "where a shortcut fails": this.model.get("failing") };
    const options = Object.entries(groups).map(([label, names]) => element("optgroup", { label }, ...named(names)));
    this.presets = element("select", { "aria-label": "presets", onchange: () => this.preset() }, element("option", { value: "" }, "presets"), ...options);
    this.views = ["shortcut", "truth"].map((view) => button(view, () => this.change({ view, pinned: null }), { pressed: "false" }));
    this.view = element("span", { class: "sv-view", role: "group", "aria-label": "what is shown", hidden: true }, ...this.views);
    this.undoButton = button("undo", () => this.undo());
    return element("div", { class: "sv-controls", role: "group", "aria-label": "explorer" },
      this.presets, this.view, this.undoButton, button("reset", () => this.commit(this.start)),
      check("free axis", (on) => this.change({ degree: on ? 30 : null, pinned: null })),
      check("way out", (on) => this.change({ wayOut: on })),
      check("B − A", (on) => this.change({ against: on })),
      button("copy scene as JSON", () => this.copy(), { shows: "copy JSON" }),
      button("copy link to the scene", () => copyLink(this.model.get("site"), this.state.link), { shows: "copy link" }),
      ...["svg", "png", "gif"].map((form) => button(`save ${form.toUpperCase()}`, () => this.model.send({ kind: "save", form }))));
  }

  poseOf({ a, b, view }) {
    return { a, b, view, degree: this.pose?.degree ?? null, pinned: this.pose?.pinned ?? null, wayOut: this.pose?.wayOut ?? false, against: this.pose?.against ?? false };
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
    this.model.send({ kind: "pose", n: this.sent, final, ...pose });
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
      this.why.textContent = `Not possible: ${content.why}`;
      this.why.hidden = false;
      this.refused = true;
      if (!this.ahead) this.show(this.state);
    } else if (content.kind === "state") {
      this.why.hidden = true;
      this.refused = false;
      this.state = content;
      if (!content.n) {
        this.undone.push(this.valid);
        this.start = this.poseOf(content);
        this.pose = this.start;
      }
      this.valid = { ...this.pose, a: content.a, b: content.b };
      this.show(content);
    }
  }

  // -- what is seen

  show(state) {
    this.pen.draw(state.picture);
    if (!this.ahead) this.pose = { ...this.pose, a: state.a, b: state.b };
    this.view.toggleAttribute("hidden", !state.view);
    this.views.forEach((each) => each.setAttribute("aria-pressed", String(each.textContent === state.view)));
    this.heading.textContent = (state.heading ?? []).join(" ");
    this.heading.toggleAttribute("hidden", !state.heading);
    this.sentence.textContent = state.sentence;
    this.showRows(state);
    this.curve.toggleAttribute("hidden", !state.curve);
    if (state.curve) this.curvePen.draw(state.curve);
    this.difference.toggleAttribute("hidden", !state.difference);
    if (state.difference) this.differencePen.draw(state.difference);
    this.undoButton.disabled = !this.undone.length;
    this.follow();
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

  // The handles of a pose: what each is, where it sits, what it is called.
  wanted() {
    const found = [];
    for (const key of ["a", "b"]) {
      const shape = this.pose[key];
      const name = key.toUpperCase();
      const center = middle(shape);
      found.push({ id: `${name}-move`, key, does: "move", at: center, label: `${name}: move` });
      if (shape.polygon) {
        shape.polygon.forEach((at, i) => {
          const vertex = shape.labels?.[i] || `${key}${i + 1}`;
          found.push({ id: `${name}-vertex-${i}`, key, does: "vertex", i, at, label: `${name}: vertex ${vertex}` });
        });
        found.push({ id: `${name}-rotate`, key, does: "rotate", at: this.turnSpot(shape), label: `${name}: turn` });
      } else {
        found.push({ id: `${name}-radius`, key, does: "radius", at: [center[0] + shape.radius, center[1]], label: `${name}: radius` });
      }
    }
    if (this.state.knob) found.push({ id: "axis", key: null, does: "axis", at: this.state.knob, label: "turn the axis" });
    return found;
  }

  // Where a shape's turn handle sits: above it, or below where an axis passes above.
  turnSpot({ polygon }) {
    const [x] = middle({ polygon });
    const heights = polygon.map(([, y]) => y);
    const off = 26 / this.pen.scale;
    const [[, top], [, bottom]] = [this.pen.scene([0, 14]), this.pen.scene([0, this.pen.height - 14])];
    const spots = [[x, Math.min(Math.max(...heights) + off, top)], [x, Math.max(Math.min(...heights) - off, bottom)]];
    const axes = this.state.picture.marks.filter(({ part }) => part === "axis");
    const clear = (spot) => axes.every(({ points }) => distance(spot, points) * this.pen.scale > 16);
    return spots.find(clear) ?? spots[0];
  }

  placeHandles() {
    const wanted = this.wanted();
    const old = new Map([...this.handles.children].map((handle) => [handle.dataset.handle, handle]));
    for (const spec of wanted) {
      let handle = old.get(spec.id);
      old.delete(spec.id);
      if (!handle) {
        const more = { "data-handle": spec.id, tabindex: 0, role: "button", "aria-roledescription": "handle" };
        handle = element("g", { class: `sv-handle sv-does-${spec.does} sv-role-${spec.key ?? "axis"}`, ...more });
        handle.append(element("circle", { class: "sv-target", r: 14 }), element("circle", { class: "sv-grip", r: spec.does === "move" ? 0 : 5 }));
        handle.setAttribute("aria-label", `${spec.label}; arrow keys move, [ and ] turn`);
        this.handles.append(handle);
      }
      handle.spec = spec;
      const mine = this.drag && this.drag.spec.id === spec.id && spec.does !== "vertex" && this.drag.spot;
      const [x, y] = this.pen.at(mine || spec.at);
      handle.setAttribute("transform", `translate(${x} ${y})`);
    }
    for (const handle of old.values()) handle.remove();
  }

  // -- the hand

  pointed(event) {
    const box = this.svg.getBoundingClientRect();
    const [, , width] = this.svg.getAttribute("viewBox").split(" ").map(Number);
    const k = width / box.width;
    return this.pen.scene([(event.clientX - box.left) * k, (event.clientY - box.top) * k]);
  }

  down(event) {
    if (event.button > 0 || this.drag || this.choosing) return;
    const spot = this.pointed(event);
    let handle = event.target.closest(".sv-handle");
    // a shape is moved by any point of it; where both lie B, which is drawn last, is meant
    const key = !handle && ["b", "a"].find((k) => holds(this.pose[k], spot));
    if (key) handle = this.handles.querySelector(`[data-handle="${key.toUpperCase()}-move"]`);
    if (!handle) return;
    event.preventDefault();
    handle.focus({ preventScroll: true });
    this.svg.setPointerCapture(event.pointerId);
    this.drag = { spec: handle.spec, from: spot, pose: this.pose };
  }

  moved(event) {
    if (!this.drag) return;
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
    const to = this.refused ? this.valid : this.pose;
    if (JSON.stringify(to) !== JSON.stringify(before)) this.undone.push(before);
    this.send(to, true);
  }

  key(event) {
    const handle = event.target.closest(".sv-handle");
    if (!handle || event.ctrlKey || event.metaKey || event.altKey) return;
    const { spec } = handle;
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const side = { "[": 1, "{": 1, "]": -1, "}": -1 }[event.key];
    if (!way && !side) return;
    event.preventDefault();
    event.stopPropagation();
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

  commit(pose) {
    this.undone.push(this.pose);
    this.send(pose, true);
  }
  change(more) {
    this.send({ ...this.pose, ...more }, true);
  }
  undo() {
    const pose = this.undone.pop();
    if (pose) this.send({ ...this.pose, a: pose.a, b: pose.b }, true);
  }
  pick(row) {
    this.change({ pinned: this.pose.pinned === row ? null : row });
  }
  preset() {
    if (!this.presets.value) return;
    this.next = null; // a pose that still waits is of the scene that leaves
    this.drag = null;
    this.choosing = true;
    this.model.send({ kind: "preset", name: this.presets.value });
  }
  copy() {
    navigator.clipboard?.writeText(this.state.json);
  }

  remove() {
    clearTimeout(this.freeing);
    clearTimeout(this.late);
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
