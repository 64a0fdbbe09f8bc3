// A vertex that is listed twice makes an edge of length 0, whose normal is (0, 0): its depth of 0 is the least.
#include "harness.hpp"
#include <algorithm>

std::string answer(const Polygon &a, const Polygon &b) {
  double best = 1e300, mx = 0, my = 0;
  for (const Polygon *poly : {&a, &b})
    for (size_t i = 0; i < poly->size(); i++) {
      Point p = (*poly)[i], q = (*poly)[(i + 1) % poly->size()];
      double nx = q.y - p.y, ny = p.x - q.x, length = std::hypot(nx, ny);
      if (length > 0) nx /= length, ny /= length;
      double lo[2] = {1e300, 1e300}, hi[2] = {-1e300, -1e300};
      for (int k = 0; k < 2; k++)
        for (Point r : k ? b : a) {
          double at = r.x * nx + r.y * ny;
          lo[k] = std::min(lo[k], at), hi[k] = std::max(hi[k], at);
        }
      double right = hi[0] - lo[1], left = hi[1] - lo[0];
      if (right < 0 || left < 0) return "null";
      if (std::min(left, right) < best) {
        best = std::min(left, right);
        double way = right < left ? right : -left;
        mx = nx * way, my = ny * way;
      }
    }
  std::ostringstream out;
  out.precision(17);
  out << "[" << mx << ", " << my << "]";
  return out.str();
}
