// The edge normals of an outline with a dent are taken for enough.
function collide(a, b) {
  const normals = [];
  for (const poly of [a, b]) {
    poly.forEach(([x, y], i) => {
      const [u, v] = poly[(i + 1) % poly.length];
      normals.push([y - v, u - x]);
    });
  }
  const range = (poly, [nx, ny]) => {
    const on = poly.map(([x, y]) => x * nx + y * ny);
    return [Math.min(...on), Math.max(...on)];
  };
  return normals.every((n) => {
    const [lo, hi] = range(a, n), [low, high] = range(b, n);
    return lo <= high && low <= hi;
  });
}
