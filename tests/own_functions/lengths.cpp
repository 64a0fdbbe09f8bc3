// A landing place is taken for a length, which has no sign.
#include "harness.hpp"
#include <algorithm>

std::string answer(const Polygon &a, const Polygon &b) {
  for (const Polygon *poly : {&a, &b})
    for (size_t i = 0; i < poly->size(); i++) {
      Point p = (*poly)[i], q = (*poly)[(i + 1) % poly->size()];
      double nx = q.y - p.y, ny = p.x - q.x, lo[2] = {1e300, 1e300}, hi[2] = {0, 0};
      for (int k = 0; k < 2; k++)
        for (Point r : k ? b : a) {
          double at = std::fabs(r.x * nx + r.y * ny);
          lo[k] = std::min(lo[k], at), hi[k] = std::max(hi[k], at);
        }
      if (hi[0] < lo[1] || hi[1] < lo[0]) return "false";
    }
  return "true";
}
