// The depth is the length that the ranges share, also where one range holds the other.
function collide(a, b) {
  let best = Infinity, out = null;
  for (const poly of [a, b]) {
    for (let i = 0; i < poly.length; i++) {
      const p = poly[i], q = poly[(i + 1) % poly.length];
      const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
      const n = { x: (q[1] - p[1]) / length, y: (p[0] - q[0]) / length };
      const s = a.map(([x, y]) => x * n.x + y * n.y), t = b.map(([x, y]) => x * n.x + y * n.y);
      const depth = Math.min(Math.max(...s), Math.max(...t)) - Math.max(Math.min(...s), Math.min(...t));
      if (depth < 0) return null;
      if (depth < best) {
        best = depth;
        const sign = Math.max(...s) - Math.min(...t) < Math.max(...t) - Math.min(...s) ? 1 : -1;
        out = { x: sign * n.x * depth, y: sign * n.y * depth };
      }
    }
  }
  return out;
}
