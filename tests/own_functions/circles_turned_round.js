// The comparison is the wrong way round.
function collide(a, b) {
  const [x, y] = a.circle, [u, v] = b.circle;
  const distance = Math.sqrt((u - x) * (u - x) + (v - y) * (v - y));
  return a.radius + b.radius < distance;
}
