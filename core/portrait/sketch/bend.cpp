#include "core/portrait/sketch/bend.h"

#include <algorithm>
#include <cmath>

namespace penpose::portrait {

Extent extent_of(const Marks& marks) {
  Extent e;
  for (const FaceMark* mark : marks) {
    e.low = {std::min(e.low.x, mark->low.x), std::min(e.low.y, mark->low.y)};
    e.high = {std::max(e.high.x, mark->high.x), std::max(e.high.y, mark->high.y)};
  }
  return e;
}

Bend bend_of(const Marks& marks, const Extent& extent) {
  const double half = 0.5 * extent.width();
  double n = 0, st = 0, stt = 0, sy = 0, sty = 0;
  double sqq = 0, sqy = 0, sq = 0, stq = 0;
  for (const FaceMark* mark : marks) {
    for (std::size_t i = 0; i + 1 < mark->points.size(); ++i) {
      const PxPoint& a = mark->points[i];
      const PxPoint& b = mark->points[i + 1];
      const double w = geometry::distance(a, b);
      const double t = half > 0 ? (0.5 * (a.x + b.x) - extent.middle()) / half : 0;
      const double q = t * t - 1.0 / 3.0;
      const double y = 0.5 * (a.y + b.y);
      n += w;
      st += w * t;
      stt += w * t * t;
      sy += w * y;
      sty += w * t * y;
      sq += w * q;
      sqq += w * q * q;
      sqy += w * q * y;
      stq += w * t * q;
    }
  }
  Bend out;
  if (n <= 0) return out;
  // Three normal equations, by Cramer's rule.
  const double a[3][3] = {{n, st, sq}, {st, stt, stq}, {sq, stq, sqq}};
  const double r[3] = {sy, sty, sqy};
  const auto determinant = [](const double m[3][3]) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  const double d = determinant(a);
  if (!(std::abs(d) > 1e-9 * n * n * n)) {
    out.at = sy / n;
    return out;
  }
  double solved[3] = {};
  for (int k = 0; k < 3; ++k) {
    double m[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[i][j] = j == k ? r[i] : a[i][j];
    }
    solved[k] = determinant(m) / d;
  }
  out.at = solved[0];
  out.slope = solved[1];
  out.curve = solved[2];
  return out;
}

}  // namespace penpose::portrait
