// Each normal is brought to length 1, and so rounded.
function collide(a, b) {
  for (const poly of [a, b]) {
    for (let i = 0; i < poly.length; i++) {
      const [px, py] = poly[i], [qx, qy] = poly[(i + 1) % poly.length];
      const length = Math.sqrt((qx - px) ** 2 + (qy - py) ** 2);
      const nx = (qy - py) / length, ny = (px - qx) / length;
      const s = a.map(([x, y]) => x * nx + y * ny), t = b.map(([x, y]) => x * nx + y * ny);
      if (Math.max(...s) < Math.min(...t) || Math.max(...t) < Math.min(...s)) return false;
    }
  }
  return true;
}
