// Normalises every axis, as vectors should be, and wants touching shapes to collide.
function collide(a, b) {
  const axes = [];
  [a, b].forEach((poly) => {
    poly.forEach(([x, y], i) => {
      const next = poly[i + 1] || poly[0];
      const edge = [next[0] - x, next[1] - y];
      const inverse = 1 / Math.sqrt(edge[0] ** 2 + edge[1] ** 2);
      axes.push([-edge[1] * inverse, edge[0] * inverse]);
    });
  });
  return axes.every(([nx, ny]) => {
    const [s, t] = [a, b].map((poly) => poly.map(([x, y]) => x * nx + y * ny));
    return Math.max(...s) >= Math.min(...t) && Math.max(...t) >= Math.min(...s);
  });
}
