// The SVG pen: draws a picture's marks, keeps their elements, and moves them from step to step.
// LOOK (weights, sizes, dashes in points) comes from pictures/theme.py; colours are CSS variables.

const SVG = "http://www.w3.org/2000/svg";
const MOVE_MS = 450;

export function element(tag, attributes = {}, ...children) {
  const made = tag === "svg" || PARTS.has(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value !== null && value !== false) made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}
const PARTS = new Set(["g", "path", "circle", "rect", "text", "tspan"]);

export class Pen {
  // `svg`: the element to draw in.  Layers: fills, then strokes from guides to brackets, solids, labels.
  constructor(svg) {
    this.svg = svg;
    this.drawn = new Map(); // id -> {mark, parts}
    this.frame = 0;
    this.layers = Object.fromEntries(
      ["fill", "0", "1", "2", "3", "4", "5", "solid", "label"].map((name) => {
        const layer = element("g", { "data-layer": name });
        svg.append(layer);
        return [name, layer];
      }),
    );
  }

  // Show a picture {marks, limits, size, sentence}; `animate` moves what comes new or changes.
  draw(picture, { animate = false } = {}) {
    cancelAnimationFrame(this.frame);
    const before = this.drawn;
    this.view(picture);
    this.drawn = new Map();
    const moves = [];
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    for (const mark of picture.marks) {
      const old = before.get(mark.id);
      const keep = old && old.mark.kind === mark.kind && old.mark.role === mark.role && old.mark.weight === mark.weight;
      const entry = { mark, parts: keep ? old.parts : this.parts(mark) };
      entry.parts.forEach((part) => part.removeAttribute("opacity")); // of a fade cut short
      if (!keep && old) old.parts.forEach((part) => part.remove());
      // in the order of the picture: later marks lie on top
      entry.parts.forEach((part) => part.parentNode.append(part));
      this.drawn.set(mark.id, entry);
      before.delete(mark.id);
      if (mark.kind === "label") this.write(entry);
      const from = animate && !still ? origin(mark, old?.mark) : null;
      this.place(entry, mark);
      if (from) moves.push({ entry, from });
    }
    for (const { parts } of before.values()) parts.forEach((part) => part.remove());
    this.svg.setAttribute("aria-label", picture.sentence);
    if (moves.length) this.move(moves);
  }

  view({ limits: [x0, y0, x1], size: [width, height] }) {
    this.x0 = x0;
    this.y0 = y0;
    this.scale = width / (x1 - x0);
    this.width = width;
    this.height = height;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  }

  // scene units -> points from the upper left corner, and back
  at([x, y]) {
    return [(x - this.x0) * this.scale, this.height - (y - this.y0) * this.scale];
  }
  scene([x, y]) {
    return [x / this.scale + this.x0, (this.height - y) / this.scale + this.y0];
  }

  // Move marks by hand (a shape under the pointer), until the next picture says where they are.
  patch(where) {
    for (const entry of this.drawn.values()) {
      const there = where(entry.mark);
      if (there) this.place(entry, { ...entry.mark, ...there });
    }
  }

  parts(mark) {
    const make = (layer, tag, more = {}) => {
      const classes = `sv-${mark.kind} sv-${mark.role} ${mark.weight ? `sv-${mark.weight}` : ""}`.trim();
      const made = element(tag, { class: classes, "data-id": mark.id, ...more });
      this.layers[layer].append(made);
      return made;
    };
    const stroke = (tag) => {
      const { layer, width, dash, faint } = strokeOf(mark);
      return make(layer, tag, {
        fill: "none",
        stroke: `var(--sv-${mark.role})`,
        "stroke-width": width,
        "stroke-dasharray": dash ? dash.map((d) => d * width).join(" ") : null,
        "stroke-opacity": faint ? 0.55 : null,
        "stroke-linejoin": "round",
      });
    };
    const colour = `var(--sv-${mark.role})`;
    if (mark.kind === "label") {
      const bold = mark.weight === "title";
      const more = { fill: `var(--sv-text-${mark.role})`, "font-size": bold ? LOOK.titleText : LOOK.text };
      return [make("label", "text", { "text-anchor": "middle", "font-weight": bold ? "bold" : null, ...more })];
    }
    if (mark.kind === "dot") return [make("solid", "path", { fill: colour })];
    if (mark.kind === "arrow") return [stroke("path"), make("solid", "path", { fill: colour })];
    if (mark.kind !== "outline" && mark.kind !== "disc") return [stroke("path")];
    const opacity = LOOK.fill / (mark.weight === "faint" ? 3 : 1);
    return [make("fill", "path", { fill: colour, "fill-opacity": opacity }), stroke("path")];
  }

  write({ mark, parts: [text] }) {
    if (text.dataset.text === mark.text) return;
    text.dataset.text = mark.text;
    text.replaceChildren(...mark.text.split("\n").map((line) => Object.assign(element("tspan"), { textContent: line })));
  }

  place({ parts }, mark) {
    const points = mark.points.map((p) => this.at(p));
    const d = (path) => parts.forEach((part) => part.setAttribute("d", path));
    if (mark.kind === "label") {
      const [[x, y]] = points;
      const [text] = parts;
      const size = mark.weight === "title" ? LOOK.titleText : LOOK.text;
      const lines = [...text.children];
      lines.forEach((line, i) => {
        line.setAttribute("x", round(x));
        // a letter's middle lies about a third of its size above the baseline
        line.setAttribute("y", round(y + (i - (lines.length - 1) / 2) * size * 1.2 + size * 0.35));
      });
      text.dataset.at = points[0].map(round).join(" ");
    } else if (mark.kind === "dot") {
      d(mark.role === "B" ? square(points[0], LOOK.dot * 0.45) : circle(points[0], LOOK.dot / 2));
    } else if (mark.kind === "disc") {
      d(circle(points[0], mark.radius * this.scale));
    } else if (mark.kind === "outline") {
      d(`${line(points)}Z`);
    } else if (mark.kind === "arrow") {
      const [shaft, head] = arrow(points);
      parts[0].setAttribute("d", shaft);
      parts[1].setAttribute("d", head);
    } else if (mark.kind === "segment") {
      let path = "";
      for (let i = 0; i + 1 < points.length; i += 2) path += line(points.slice(i, i + 2));
      d(path);
    } else {
      d(line(points));
    }
  }

  move(moves) {
    const start = performance.now();
    const tick = (now) => {
      const part = Math.min(1, Math.max(0, (now - start) / MOVE_MS));
      const eased = 1 - (1 - part) ** 3;
      for (const { entry, from } of moves) {
        if (from === "fade") {
          entry.parts.forEach((p) => (part < 1 ? p.setAttribute("opacity", eased) : p.removeAttribute("opacity")));
        } else {
          const points = entry.mark.points.map(([x, y], i) => [
            from[i][0] + (x - from[i][0]) * eased,
            from[i][1] + (y - from[i][1]) * eased,
          ]);
          this.place(entry, part < 1 ? { ...entry.mark, points } : entry.mark);
        }
      }
      if (part < 1) this.frame = requestAnimationFrame(tick);
    };
    tick(start);
  }

  remove() {
    cancelAnimationFrame(this.frame);
  }
}

// Which layer, how wide and how dashed a mark's line is: the rules of the matplotlib pen.
function strokeOf({ kind, role, weight }) {
  const faint = weight === "faint";
  if (kind === "outline" || kind === "disc") {
    const width = faint ? LOOK.guide : LOOK.outline;
    return { layer: faint ? "1" : "2", width, dash: role === "B" ? LOOK.dash : null, faint };
  }
  const layer = { interval: "4", bracket: "5" }[kind] ?? { faint: "1", strong: "3" }[weight] ?? "2";
  if (kind === "interval") return { layer, width: role === "overlap" ? LOOK.overlapBar : LOOK.bar, faint };
  if (kind === "arrow") {
    return { layer, width: weight === "strong" || role === "A" || role === "B" ? LOOK.outline : LOOK.axis, faint };
  }
  if (role === "guide") return { layer: "0", width: LOOK.guide, dash: LOOK.dotted, faint };
  if (weight === "strong") return { layer, width: LOOK.strong, faint };
  return { layer, width: kind === "segment" ? LOOK.guide * 1.5 : LOOK.outline, faint };
}

// The points a mark moves from, "fade" for what only appears, null for what is simply there.
function origin({ kind, points, start }, old) {
  if (kind === "label") return old ? null : "fade";
  if (!old) return start ? points.map((_, i) => start[i] ?? start[0]) : "fade";
  return old.points.length === points.length && String(old.points) !== String(points) ? old.points : null;
}

const round = (value) => Math.round(value * 1000) / 1000;

function line(points) {
  return points.map(([x, y], i) => `${i ? "L" : "M"}${round(x)} ${round(y)}`).join("");
}

function circle([x, y], r) {
  const [a, b, size] = [round(x - r), round(x + r), round(r)];
  return `M${a} ${round(y)}A${size} ${size} 0 1 1 ${b} ${round(y)}A${size} ${size} 0 1 1 ${a} ${round(y)}Z`;
}

function square([x, y], r) {
  return `${line([[x - r, y - r], [x + r, y - r], [x + r, y + r], [x - r, y + r]])}Z`;
}

function arrow([[x0, y0], [x1, y1]]) {
  const size = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / size, (y1 - y0) / size];
  const [length, half] = [Math.min(LOOK.head[0], size), LOOK.head[1] / 2];
  const [bx, by] = [x1 - ux * length, y1 - uy * length];
  const head = [[x1, y1], [bx + uy * half, by - ux * half], [bx - uy * half, by + ux * half]];
  return [line([[x0, y0], [x1 - ux * length * 0.8, y1 - uy * length * 0.8]]), `${line(head)}Z`];
}
