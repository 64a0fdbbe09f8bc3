// The SVG pen draws a picture's marks, keeps their elements, and moves them from step to step.
// How a mark looks (layer, widths, dashes, sizes in points) comes with it; colours are CSS variables.

import { element } from "./elements.js";

/** @typedef {[number, number]} Point */
/**
 * @typedef {object} Mark
 * @property {string} id
 * @property {number} style The mark's row in the table of styles.
 * @property {string} part What the mark is: "outline", "vertex", "axis".
 * @property {Point[]} points In scene units.
 * @property {Point[]} [start] Where the points come from: a point each, or one for all.
 * @property {string} [owner]
 * @property {number} [number]
 * @property {number} [radius]
 * @property {string} [text]
 */
/**
 * @typedef {object} Style
 * @property {"outline" | "disc" | "segment" | "arrow" | "interval" | "bracket" | "dot" | "label"} kind
 * @property {string} role
 * @property {number} [layer] Of its line.
 * @property {number} [width] None: the mark has no line.
 * @property {number[]} [dash] In widths.
 * @property {number} [opacity]
 * @property {number} [fill] The opacity of its inside.
 * @property {number} [size] A dot's width, or the size of the letters.
 * @property {boolean} [square] A dot is round otherwise.
 * @property {boolean} [bold]
 * @property {Point} [head] The length and width of an arrow's head.
 */
/**
 * @typedef {object} Picture
 * @property {Mark[]} marks
 * @property {Style[]} styles
 * @property {[number, number, number, number]} limits In scene units: x0, y0, x1, y1.
 * @property {Point} size In points.
 * @property {string} sentence
 */
/** @typedef {{ mark: Mark, style: Style, parts: SVGElement[] }} Drawn */
/** @typedef {{ drawn: Drawn, from: Point[] | "fade" }} Move */

const MOVE_MS = 450;

export class Pen {
  /**
   * The layers: fills, then strokes from guides to brackets, solids, labels.
   * @param {SVGSVGElement} svg The element to draw in.
   */
  constructor(svg) {
    this.svg = svg;
    /** @type {Map<string, Drawn>} By the id of the mark. */
    this.drawn = new Map();
    this.frame = 0;
    this.x0 = 0;
    this.y0 = 0;
    this.width = 0; // in points
    this.height = 0;
    this.scale = 1; // points per scene unit
    this.layers = Object.fromEntries(
      ["fill", "0", "1", "2", "3", "4", "5", "solid", "label"].map((name) => {
        const layer = element("g", { "data-layer": name });
        svg.append(layer);
        return [name, layer];
      }),
    );
  }

  /**
   * Show a picture.  `animate` moves the marks that are new or that change.
   * @param {Picture} picture
   */
  draw(picture, { animate = false } = {}) {
    cancelAnimationFrame(this.frame);
    const before = this.drawn;
    this.fit(picture);
    this.drawn = new Map();
    /** @type {Move[]} */
    const moves = [];
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    for (const mark of picture.marks) {
      const old = before.get(mark.id);
      const style = picture.styles[mark.style];
      const kept = old && JSON.stringify(old.style) === JSON.stringify(style) ? old.parts : null;
      const drawn = { mark, style, parts: kept ?? this.makeParts(mark, style) };
      this.unfade(drawn); // a move may have been cut short
      if (!kept && old) for (const part of old.parts) part.remove();
      // The elements follow the order of the picture: later marks lie on top.
      for (const part of drawn.parts) part.parentNode?.append(part);
      this.drawn.set(mark.id, drawn);
      before.delete(mark.id);
      if (style.kind === "label") this.write(drawn);
      const from = animate && !still ? startOfMove(drawn, old) : null;
      this.place(drawn, mark);
      if (from) moves.push({ drawn, from });
    }
    for (const { parts } of before.values()) for (const part of parts) part.remove();
    this.svg.setAttribute("aria-label", picture.sentence);
    if (moves.length) this.move(moves);
  }

  /** @param {Picture} picture */
  fit({ limits: [x0, y0, x1], size: [width, height] }) {
    Object.assign(this, { x0, y0, width, height, scale: width / (x1 - x0) });
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  }

  /**
   * From scene units to points from the upper left corner.
   * @param {Point} point
   * @returns {Point}
   */
  toPicture([x, y]) {
    return [(x - this.x0) * this.scale, this.height - (y - this.y0) * this.scale];
  }

  /**
   * The inverse of `toPicture`.
   * @param {Point} point
   * @returns {Point}
   */
  toScene([x, y]) {
    return [x / this.scale + this.x0, (this.height - y) / this.scale + this.y0];
  }

  /**
   * Move the marks for which `moved` returns new points (a shape that is dragged), until the next picture is drawn.
   * @param {(mark: Mark) => Partial<Mark> | null} moved
   */
  patch(moved) {
    for (const drawn of this.drawn.values()) {
      const changes = moved(drawn.mark);
      if (changes) this.place(drawn, { ...drawn.mark, ...changes });
    }
  }

  /**
   * @param {Mark} mark
   * @param {Style} style
   */
  makeParts({ id }, { kind, role, layer, width, dash, opacity, fill, size, bold }) {
    /** @type {SVGElement[]} */
    const parts = [];
    /** @type {(layer: string | number, tag: "path" | "text", attributes: Record<string, import("./elements.js").Attribute>) => void} */
    const make = (where, tag, attributes) => {
      const part = element(tag, { "data-id": id, ...attributes });
      parts.push(part);
      this.layers[where].append(part);
    };
    const colour = `var(--sv-${role})`;
    if (kind === "label") make("label", "text", { fill: `var(--sv-text-${role})`, "font-size": size ?? null, "font-weight": bold ? "bold" : null, "text-anchor": "middle" });
    if (fill) make("fill", "path", { fill: colour, "fill-opacity": fill });
    if (width) {
      const dashes = dash ? dash.map((d) => d * width).join(" ") : null;
      const line = { "stroke-width": width, "stroke-dasharray": dashes, "stroke-opacity": opacity ?? null, "stroke-linejoin": "round" };
      make(layer ?? 0, "path", { fill: "none", stroke: colour, ...line });
    }
    if (kind === "dot" || kind === "arrow") make("solid", "path", { fill: colour });
    return parts;
  }

  /** @param {Drawn} drawn A label. */
  write({ mark: { text = "" }, parts: [letters] }) {
    if (letters.dataset.text === text) return;
    letters.dataset.text = text;
    letters.replaceChildren(...text.split("\n").map((line) => element("tspan", {}, line)));
  }

  /**
   * @param {Drawn} drawn
   * @param {Mark} mark The same mark, perhaps on its way to its points.
   */
  place({ style, parts }, mark) {
    const { size = 0 } = style;
    const points = mark.points.map((p) => this.toPicture(p));
    /** @param {string} path */
    const setPath = (path) => {
      for (const part of parts) part.setAttribute("d", path);
    };
    if (style.kind === "label") {
      const [[x, y]] = points;
      const [text] = parts;
      const lines = [...text.children];
      lines.forEach((line, i) => {
        line.setAttribute("x", String(round(x)));
        // The middle of a letter lies about a third of its size above the baseline.
        line.setAttribute("y", String(round(y + (i - (lines.length - 1) / 2) * size * 1.2 + size * 0.35)));
      });
      text.dataset.at = points[0].map(round).join(" ");
    } else if (style.kind === "dot") {
      setPath((style.square ? squarePath : circlePath)(points[0], size / 2));
    } else if (style.kind === "disc") {
      setPath(circlePath(points[0], (mark.radius ?? 0) * this.scale));
    } else if (style.kind === "outline") {
      setPath(`${linePath(points)}Z`);
    } else if (style.kind === "arrow") {
      const [shaft, head] = arrowPaths(points, style.head ?? [0, 0]);
      parts[0].setAttribute("d", shaft);
      parts[1].setAttribute("d", head);
    } else if (style.kind === "segment") {
      setPath(linePath(points, 2));
    } else {
      setPath(linePath(points));
    }
  }

  /** @param {Move[]} moves */
  move(moves) {
    const start = performance.now();
    /** @param {number} now */
    const tick = (now) => {
      const part = Math.min(1, Math.max(0, (now - start) / MOVE_MS));
      const eased = 1 - (1 - part) ** 3;
      for (const { drawn, from } of moves) {
        if (from === "fade") {
          for (const p of drawn.parts) p.setAttribute("opacity", String(eased));
          if (part === 1) this.unfade(drawn);
        } else {
          /** @type {Point[]} */
          const points = drawn.mark.points.map(([x, y], i) => [from[i][0] + (x - from[i][0]) * eased, from[i][1] + (y - from[i][1]) * eased]);
          this.place(drawn, part < 1 ? { ...drawn.mark, points } : drawn.mark);
        }
      }
      if (part < 1) this.frame = requestAnimationFrame(tick);
    };
    tick(start);
  }

  // End a move at once: each mark is where it goes.
  arrive() {
    cancelAnimationFrame(this.frame);
    for (const drawn of this.drawn.values()) {
      this.unfade(drawn);
      this.place(drawn, drawn.mark);
    }
  }

  /** @param {Drawn} drawn */
  unfade({ parts }) {
    for (const part of parts) part.removeAttribute("opacity");
  }

  remove() {
    cancelAnimationFrame(this.frame);
  }
}

/**
 * The points that a mark moves from, "fade" for one that only appears, null for one that does not move.
 * @param {Drawn} drawn
 * @param {Drawn | undefined} old
 * @returns {Point[] | "fade" | null}
 */
function startOfMove({ mark: { points, start }, style }, old) {
  if (style.kind === "label") return old ? null : "fade";
  if (!old) return start ? points.map((_, i) => start[i] ?? start[0]) : "fade";
  const from = old.mark.points;
  return from.length === points.length && String(from) !== String(points) ? from : null;
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 1000) / 1000;
}

/**
 * The path through the points, or of pieces of `piece` points each.
 * @param {Point[]} points
 */
function linePath(points, piece = points.length) {
  return points.map(([x, y], i) => `${i % piece ? "L" : "M"}${round(x)} ${round(y)}`).join("");
}

/**
 * @param {Point} center
 * @param {number} r
 */
function circlePath([x, y], r) {
  const [a, b, size] = [round(x - r), round(x + r), round(r)];
  return `M${a} ${round(y)}A${size} ${size} 0 1 1 ${b} ${round(y)}A${size} ${size} 0 1 1 ${a} ${round(y)}Z`;
}

/**
 * @param {Point} center
 * @param {number} r Half of the width.
 */
function squarePath([x, y], r) {
  return `${linePath([[x - r, y + r], [x + r, y + r], [x + r, y - r], [x - r, y - r]])}Z`;
}

/**
 * The shaft and the head.
 * @param {Point[]} points The tail and the tip.
 * @param {Point} head The largest length of the head, and its width.
 */
function arrowPaths([[x0, y0], [x1, y1]], [most, width]) {
  const size = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / size, (y1 - y0) / size];
  const [length, half] = [Math.min(most, size), width / 2];
  const [bx, by] = [x1 - ux * length, y1 - uy * length];
  /** @type {Point[]} */
  const head = [[x1, y1], [bx + uy * half, by - ux * half], [bx - uy * half, by + ux * half]];
  return [linePath([[x0, y0], [x1 - ux * length * 0.8, y1 - uy * length * 0.8]]), `${linePath(head)}Z`];
}
