// Shapes in scene units, as a pointer or a key changes them.  Python alone decides how two shapes lie.

/** @import { Point } from "./pen.js" */
/** @typedef {{ polygon: Point[], labels?: string[], circle?: undefined, radius?: undefined }} Polygon */
/** @typedef {{ circle: Point, radius: number, polygon?: undefined }} Circle */
/** @typedef {Polygon | Circle} Shape */

const DIGITS = 12; // hides the tail of digits that a multiplication leaves, as in 0.30000000000000004

/**
 * The nearest number on a grid.
 * @param {number} value
 * @param {number} grid
 */
export function snap(value, grid) {
  return Number((Math.round(value / grid) * grid).toPrecision(DIGITS));
}

/**
 * The largest round number (1, 2 or 5 times a power of ten) that is not larger.
 * @param {number} value
 */
export function roundDown(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value / power >= 5 ? 5 : value / power >= 2 ? 2 : 1);
}

/**
 * A number of six digits without an exponent.  A formatter of Intl would take a millisecond for each number.
 * @param {number} value
 */
export function plainNumber(value) {
  const decimals = 5 - Math.floor(Math.log10(Math.abs(value) || 1));
  const text = value.toFixed(Math.min(100, Math.max(0, decimals)));
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/**
 * A number as a screen reader says it.
 * @param {number} value
 */
export function spoken(value) {
  return String(Number(value.toPrecision(4))).replace("-", "\u2212");
}

/** @param {Point} point */
export function spokenPoint([x, y]) {
  return `(${spoken(x)}, ${spoken(y)})`;
}

/**
 * The center of a circle, or the mean of a polygon's vertices.
 * @param {Shape} shape
 * @returns {Point}
 */
export function centerOf({ polygon, circle }) {
  if (circle) return circle;
  const sum = (/** @type {0 | 1} */ k) => polygon.reduce((total, p) => total + p[k], 0);
  return [sum(0) / polygon.length, sum(1) / polygon.length];
}

/**
 * @param {Shape} shape
 * @param {number} dx
 * @param {number} dy
 * @returns {Shape}
 */
export function translated(shape, dx, dy) {
  /** @type {(point: Point) => Point} */
  const move = ([x, y]) => [Number((x + dx).toPrecision(DIGITS)), Number((y + dy).toPrecision(DIGITS))];
  return shape.circle ? { ...shape, circle: move(shape.circle) } : { ...shape, polygon: shape.polygon.map(move) };
}

/**
 * The shape turned about its center.
 * @param {Shape} shape
 * @param {number} angle In radians.
 * @returns {Shape}
 */
export function rotated(shape, angle) {
  if (shape.circle) return shape;
  const [cx, cy] = centerOf(shape);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { ...shape, polygon: shape.polygon.map(([x, y]) => [cx + (x - cx) * c - (y - cy) * s, cy + (x - cx) * s + (y - cy) * c]) };
}

/**
 * A polygon with one vertex moved.
 * @param {Shape} shape
 * @param {number | undefined} number Of the vertex.
 * @param {(vertex: Point) => Point} move
 * @returns {Shape}
 */
export function withVertex(shape, number, move) {
  return shape.polygon ? { ...shape, polygon: shape.polygon.map((p, i) => (i === number ? move(p) : p)) } : shape;
}

/**
 * A circle with another radius.
 * @param {Shape} shape
 * @param {number} radius
 * @returns {Shape}
 */
export function withRadius(shape, radius) {
  return shape.circle ? { ...shape, radius } : shape;
}

/**
 * The distance of a point from a segment.
 * @param {Point} point
 * @param {Point[]} segment
 */
export function distanceToSegment([x, y], [[px, py], [qx, qy]]) {
  const [dx, dy] = [qx - px, qy - py];
  const t = Math.max(0, Math.min(1, ((x - px) * dx + (y - py) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(px + t * dx - x, py + t * dy - y);
}

/**
 * Does the shape contain the point?  Crossing numbers in floating point are enough for a pointer.
 * @param {Shape} shape
 * @param {Point} point
 */
export function contains({ polygon, circle, radius }, [x, y]) {
  if (circle) return Math.hypot(x - circle[0], y - circle[1]) <= radius;
  let inside = false;
  polygon.forEach(([px, py], i) => {
    const [qx, qy] = polygon[(i + 1) % polygon.length];
    if (py > y !== qy > y && x < px + ((y - py) / (qy - py)) * (qx - px)) inside = !inside;
  });
  return inside;
}
