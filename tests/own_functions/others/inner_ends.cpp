// The depth of a physics engine: on each axis from the larger minimum to the smaller maximum.
#include <algorithm>
#include <limits>
#include "harness.hpp"

struct Range {
  double lo = std::numeric_limits<double>::max();
  double hi = std::numeric_limits<double>::lowest();
};

static Range project(const Polygon &p, const Point &n) {
  Range r;
  for (const auto &v : p) {
    const double t = v.x * n.x + v.y * n.y;
    r.lo = std::min(r.lo, t);
    r.hi = std::max(r.hi, t);
  }
  return r;
}

static bool deepen(const Polygon &p, const Polygon &a, const Polygon &b, double &depth) {
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
    Point n{p[i].y - p[j].y, p[j].x - p[i].x};
    const double length = std::sqrt(n.x * n.x + n.y * n.y);
    n = {n.x / length, n.y / length};
    const Range s = project(a, n), t = project(b, n);
    const double overlap = std::min(s.hi, t.hi) - std::max(s.lo, t.lo);
    if (overlap <= 0) return false;
    depth = std::min(depth, overlap);
  }
  return true;
}

std::string answer(const Polygon &a, const Polygon &b) {
  double depth = std::numeric_limits<double>::max();
  if (!deepen(a, a, b, depth) || !deepen(b, a, b, depth)) return "0";
  std::ostringstream text;
  text.precision(17);
  text << depth;
  return text.str();
}
