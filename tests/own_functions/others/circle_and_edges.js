// A circle against a polygon: every edge normal of the polygon, and nothing else.
function project(shape, nx, ny) {
  if (shape.circle) {
    var c = shape.circle[0] * nx + shape.circle[1] * ny;
    var r = shape.radius * Math.sqrt(nx * nx + ny * ny);
    return [c - r, c + r];
  }
  var lo = Infinity, hi = -Infinity;
  for (var i = 0; i < shape.length; i++) {
    var t = shape[i][0] * nx + shape[i][1] * ny;
    if (t < lo) lo = t;
    if (t > hi) hi = t;
  }
  return [lo, hi];
}

function collide(a, b) {
  var polygons = [a, b].filter(function (s) { return !s.circle; });
  for (var k = 0; k < polygons.length; k++) {
    var p = polygons[k];
    for (var i = 0, j = p.length - 1; i < p.length; j = i++) {
      var nx = p[i][1] - p[j][1], ny = p[j][0] - p[i][0];
      var s = project(a, nx, ny), t = project(b, nx, ny);
      if (s[1] < t[0] || t[1] < s[0]) return false;
    }
  }
  return true;
}
