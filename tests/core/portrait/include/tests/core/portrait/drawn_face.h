#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

/// A face of a few lines, as somebody draws it: px of a sheet, y down. Sides: the left of the picture first.
struct DrawnFace {
  using Line = std::vector<geometry::PxPoint>;

  std::array<double, 2> brow_inner{0, 0}, brow_outer{0, 0};  ///< up from where they rest
  std::array<bool, 2> shut{false, false};
  double lowered = 0;  ///< upper lids, of the eye: the iris below is left out
  double smile = 0;    ///< corners up from the middle of the mouth
  double gap = 0;      ///< of an open mouth, a closed line
  double half_width = 40;
  double turn = 0;  ///< radians about the middle
  bool outline = true;

  [[nodiscard]] std::vector<Line> lines() const {
    std::vector<Line> out;
    if (outline) out.push_back(ring({200, 240}, 120, 150));
    for (const int side : {-1, 1}) {
      const std::size_t s = side < 0 ? 0 : 1;
      const double x = 200 + side * 50.0;
      out.push_back({{x - side * 22.0, 160 - brow_inner[s]}, {x + side * 24.0, 160 - brow_outer[s]}});
      if (shut[s]) {
        out.push_back(bow({x - 20, 200}, {x + 20, 200}, 8));
      } else {
        out.push_back(ring({x, 200}, 20, 14));
        for (geometry::PxPoint& p : out.back()) p.y = std::max(p.y, 186 + 28 * lowered);
        if (!(lowered > 0)) out.push_back(ring({x, 200}, 4, 4));
      }
    }
    out.push_back({{200, 220}, {192, 250}, {204, 252}});
    const geometry::PxPoint left{200 - half_width, 300 - smile}, right{200 + half_width, 300 - smile};
    if (gap > 0) {
      Line mouth = bow(left, right, smile - 0.5 * gap);
      const Line lower = bow(right, left, smile + 0.5 * gap);
      mouth.insert(mouth.end(), lower.begin(), lower.end());
      out.push_back(std::move(mouth));
    } else {
      out.push_back(bow(left, right, smile));
    }
    for (Line& line : out) {
      for (geometry::PxPoint& p : line) {
        const geometry::PxPoint d = p - geometry::PxPoint{200, 240};
        p = geometry::PxPoint{200, 240} +
            geometry::PxPoint{d.x * std::cos(turn) - d.y * std::sin(turn), d.x * std::sin(turn) + d.y * std::cos(turn)};
      }
    }
    return out;
  }

  static Line ring(geometry::PxPoint center, double rx, double ry) {
    Line line;
    for (int i = 0; i <= 48; ++i) {
      const double a = 6.283185307179586 * i / 48;
      line.push_back(center + geometry::PxPoint{rx * std::cos(a), ry * std::sin(a)});
    }
    return line;
  }
  /// Returns an arc whose middle hangs below its ends by `down`.
  static Line bow(geometry::PxPoint from, geometry::PxPoint to, double down) {
    Line line;
    for (int i = 0; i <= 24; ++i) {
      const double t = i / 24.0;
      line.push_back(from * (1 - t) + to * t + geometry::PxPoint{0, 4 * t * (1 - t) * down});
    }
    return line;
  }
};

}  // namespace penpose::portrait
