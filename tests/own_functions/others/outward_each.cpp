// Each shape is projected on the normal that points away from its own middle.
#include <algorithm>
#include "harness.hpp"

static Point middle(const Polygon &p) {
  Point m{0, 0};
  for (auto &v : p) m.x += v.x / p.size(), m.y += v.y / p.size();
  return m;
}

static std::pair<double, double> shadow(const Polygon &p, Point from, Point n) {
  Point m = middle(p);
  if ((m.x - from.x) * n.x + (m.y - from.y) * n.y > 0) n = {-n.x, -n.y};  // outward
  double lo = 1e300, hi = -1e300;
  for (auto &v : p) {
    lo = std::min(lo, v.x * n.x + v.y * n.y);
    hi = std::max(hi, v.x * n.x + v.y * n.y);
  }
  return {lo, hi};
}

std::string answer(const Polygon &a, const Polygon &b) {
  for (auto *p : {&a, &b})
    for (size_t i = 0; i < p->size(); i++) {
      Point from = (*p)[i], to = (*p)[(i + 1) % p->size()], n{to.y - from.y, from.x - to.x};
      auto s = shadow(a, from, n), t = shadow(b, from, n);
      if (s.second < t.first || t.second < s.first) return "false";
    }
  return "true";
}
