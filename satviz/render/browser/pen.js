// The SVG pen: draws a picture's marks, keeps their elements, and moves them from step to step.
// How a mark looks (layer, widths, dashes, sizes in points) comes with it; colours are CSS variables.

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
    this.drawn = new Map(); // id -> {mark, look, parts}
    this.frame = 0;
    this.layers = Object.fromEntries(
      ["fill", "0", "1", "2", "3", "4", "5", "solid", "label"].map((name) => {
        const layer = element("g", { "data-layer": name });
        svg.append(layer);
        return [name, layer];
      }),
    );
  }

  // Show a picture {marks, looks, limits, size, sentence}; `animate` moves what comes new or changes.
  draw(picture, { animate = false } = {}) {
    cancelAnimationFrame(this.frame);
    const before = this.drawn;
    this.view(picture);
    this.drawn = new Map();
    const moves = [];
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    for (const mark of picture.marks) {
      const old = before.get(mark.id);
      const look = picture.looks[mark.look];
      const keep = old && JSON.stringify(old.look) === JSON.stringify(look);
      const entry = { mark, look, parts: keep ? old.parts : this.parts(mark, look) };
      entry.parts.forEach((part) => part.removeAttribute("opacity")); // of a fade cut short
      if (!keep && old) old.parts.forEach((part) => part.remove());
      // in the order of the picture: later marks lie on top
      entry.parts.forEach((part) => part.parentNode.append(part));
      this.drawn.set(mark.id, entry);
      before.delete(mark.id);
      if (look.kind === "label") this.write(entry);
      const from = animate && !still ? origin(entry, old) : null;
      this.place(entry, mark);
      if (from) moves.push({ entry, from });
    }
    for (const { parts } of before.values()) parts.forEach((part) => part.remove());
    this.svg.setAttribute("aria-label", picture.sentence);
    if (moves.length) this.move(moves);
  }

  view({ limits: [x0, y0, x1], size: [width, height] }) {
    Object.assign(this, { x0, y0, width, height, scale: width / (x1 - x0) });
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

  parts({ id }, { kind, role, layer, width, dash, opacity, fill, size, bold }) {
    const parts = [];
    const make = (where, tag, more) => {
      parts.push(element(tag, { "data-id": id, ...more }));
      this.layers[where].append(parts.at(-1));
    };
    const colour = `var(--sv-${role})`;
    const letters = { "font-size": size, "font-weight": bold ? "bold" : null, "text-anchor": "middle" };
    if (kind === "label") make("label", "text", { fill: `var(--sv-text-${role})`, ...letters });
    if (fill) make("fill", "path", { fill: colour, "fill-opacity": fill });
    const dashes = dash ? dash.map((d) => d * width).join(" ") : null;
    const line = { "stroke-width": width, "stroke-dasharray": dashes, "stroke-opacity": opacity ?? null, "stroke-linejoin": "round" };
    if (width) make(layer ?? 0, "path", { fill: "none", stroke: colour, ...line });
    if (kind === "dot" || kind === "arrow") make("solid", "path", { fill: colour });
    return parts;
  }

  write({ mark, parts: [text] }) {
    if (text.dataset.text === mark.text) return;
    text.dataset.text = mark.text;
    text.replaceChildren(...mark.text.split("\n").map((line) => Object.assign(element("tspan"), { textContent: line })));
  }

  place({ look, parts }, mark) {
    const points = mark.points.map((p) => this.at(p));
    const d = (path) => parts.forEach((part) => part.setAttribute("d", path));
    if (look.kind === "label") {
      const [[x, y]] = points;
      const [text] = parts;
      const lines = [...text.children];
      lines.forEach((line, i) => {
        line.setAttribute("x", round(x));
        // a letter's middle lies about a third of its size above the baseline
        line.setAttribute("y", round(y + (i - (lines.length - 1) / 2) * look.size * 1.2 + look.size * 0.35));
      });
      text.dataset.at = points[0].map(round).join(" ");
    } else if (look.kind === "dot") {
      d((look.square ? square : circle)(points[0], look.size / 2));
    } else if (look.kind === "disc") {
      d(circle(points[0], mark.radius * this.scale));
    } else if (look.kind === "outline") {
      d(`${line(points)}Z`);
    } else if (look.kind === "arrow") {
      const [shaft, head] = arrow(points, look.head);
      parts[0].setAttribute("d", shaft);
      parts[1].setAttribute("d", head);
    } else if (look.kind === "segment") {
      d(line(points, 2));
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

  // All that moves is where it goes.
  arrive() {
    cancelAnimationFrame(this.frame);
    for (const entry of this.drawn.values()) {
      entry.parts.forEach((part) => part.removeAttribute("opacity"));
      this.place(entry, entry.mark);
    }
  }

  remove() {
    cancelAnimationFrame(this.frame);
  }
}

// Light or dark as what lies around an element is, whatever the system likes; until the function it gives is called.
export function themed(root) {
  const match = () => {
    const theme = dark(root) ? "dark" : "light";
    if (root.dataset.theme !== theme) root.dataset.theme = theme;
  };
  const late = () => {
    match();
    clearTimeout(again);
    again = setTimeout(match, 500); // colours may fade over
  };
  let again = 0;
  const placed = new ResizeObserver(() => { // what lies nowhere yet is looked at when it does, before it is painted
    placed.disconnect();
    match();
  });
  const system = matchMedia("(prefers-color-scheme: dark)");
  const changes = new MutationObserver(late);
  for (const page of [document.documentElement, document.body]) changes.observe(page, { attributes: true });
  system.addEventListener("change", late);
  if (root.isConnected) late();
  else placed.observe(root);
  return () => {
    clearTimeout(again);
    placed.disconnect();
    changes.disconnect();
    system.removeEventListener("change", late);
  };
}

// Is the page dark?  As JupyterLab and VS Code say it, else by the colour that shows behind the element.
function dark(root) {
  const { body } = document;
  if (body.dataset.jpThemeLight) return body.dataset.jpThemeLight === "false";
  if (body.matches(".vscode-light, .vscode-high-contrast-light")) return false;
  if (body.matches(".vscode-dark, .vscode-high-contrast")) return true;
  for (let around = root.parentNode; around; around = around.parentNode ?? around.host) {
    const [r, g, b, opacity = 1] = around instanceof Element ? rgba(getComputedStyle(around).backgroundColor) : [0, 0, 0, 0];
    if (opacity > 0.5) return 0.3 * r + 0.6 * g + 0.1 * b < 0.5;
  }
  const scheme = getComputedStyle(document.documentElement).colorScheme;
  return scheme.includes("dark") && (!scheme.includes("light") || matchMedia("(prefers-color-scheme: dark)").matches);
}

// Any colour of CSS in numbers to 1.  Not from a canvas: who guards against being recognized gets noise back from it.
function rgba(colour) {
  if (!colour) return [0, 0, 0, 0]; // of what is on no page
  const probe = document.body.appendChild(element("i", { hidden: true }));
  probe.style.color = `color-mix(in srgb, ${colour}, ${colour})`;
  const found = getComputedStyle(probe).color.match(/-?[\d.]+(e-\d+)?/g).map(Number);
  probe.remove();
  return found;
}

// The points a mark moves from, "fade" for what only appears, null for what is simply there.
function origin({ mark: { points, start }, look }, old) {
  if (look.kind === "label") return old ? null : "fade";
  if (!old) return start ? points.map((_, i) => start[i] ?? start[0]) : "fade";
  const from = old.mark.points;
  return from.length === points.length && String(from) !== String(points) ? from : null;
}

const round = (value) => Math.round(value * 1000) / 1000;

function line(points, piece = points.length) {
  return points.map(([x, y], i) => `${i % piece ? "L" : "M"}${round(x)} ${round(y)}`).join("");
}

function circle([x, y], r) {
  const [a, b, size] = [round(x - r), round(x + r), round(r)];
  return `M${a} ${round(y)}A${size} ${size} 0 1 1 ${b} ${round(y)}A${size} ${size} 0 1 1 ${a} ${round(y)}Z`;
}

function square([x, y], r) {
  return `${line([[x - r, y + r], [x + r, y + r], [x + r, y - r], [x - r, y - r]])}Z`;
}

function arrow([[x0, y0], [x1, y1]], [most, width]) {
  const size = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / size, (y1 - y0) / size];
  const [length, half] = [Math.min(most, size), width / 2];
  const [bx, by] = [x1 - ux * length, y1 - uy * length];
  const head = [[x1, y1], [bx + uy * half, by - ux * half], [bx - uy * half, by + ux * half]];
  return [line([[x0, y0], [x1 - ux * length * 0.8, y1 - uy * length * 0.8]]), `${line(head)}Z`];
}
