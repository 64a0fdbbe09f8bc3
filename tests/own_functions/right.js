function collide(a, b) {
  const normals = [a, b].flatMap((poly) => poly.map(([x, y], i) => {
    const [u, v] = poly[(i + 1) % poly.length];
    return [v - y, x - u];
  }));
  const range = (poly, n) => {
    const on = poly.map(([x, y]) => x * n[0] + y * n[1]);
    return [Math.min(...on), Math.max(...on)];
  };
  return normals.every((n) => {
    const [lo, hi] = range(a, n), [low, high] = range(b, n);
    return lo <= high && low <= hi;
  });
}
