// An arrow-function person: reduce, spread, and a response vector along the line of the centers.
const centre = (poly) => poly.reduce(([sx, sy], [x, y]) => [sx + x / poly.length, sy + y / poly.length], [0, 0]);
const unitNormals = (poly) =>
  poly.map(([x, y], i) => {
    const [u, v] = poly[(i + 1) % poly.length];
    const len = Math.hypot(u - x, v - y);
    return [(v - y) / len, (x - u) / len];
  });
const extent = (poly, [nx, ny]) => {
  const ts = poly.map(([x, y]) => x * nx + y * ny);
  return { lo: Math.min(...ts), hi: Math.max(...ts) };
};

function collide(a, b) {
  let depth = Infinity;
  for (const n of [...unitNormals(a), ...unitNormals(b)]) {
    const p = extent(a, n), q = extent(b, n);
    const o = Math.min(p.hi - q.lo, q.hi - p.lo);
    if (o <= 0) return null;
    depth = Math.min(depth, o);
  }
  const [ax, ay] = centre(a), [bx, by] = centre(b);
  const d = Math.hypot(bx - ax, by - ay) || 1;
  return { x: ((bx - ax) / d) * depth, y: ((by - ay) / d) * depth };
}
