// The normal of an edge (dx, dy) has its sign at the wrong place.
const dot = (p, n) => p[0] * n[0] + p[1] * n[1];
const axes = (poly) => poly.map((p, i) => { const q = poly[(i + 1) % poly.length]; return [q[0] - p[0], -(q[1] - p[1])]; });
function collide(a, b) {
  for (const n of [...axes(a), ...axes(b)]) {
    const s = a.map((p) => dot(p, n)), t = b.map((p) => dot(p, n));
    if (Math.max(...s) < Math.min(...t) || Math.max(...t) < Math.min(...s)) return false;
  }
  return true;
}
