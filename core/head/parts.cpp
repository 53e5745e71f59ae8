#include "core/head/parts.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::head {

Surface make_eye_cap(double radius, double from_degrees, double to_degrees, int rings, int segments) {
  Surface cap;
  const ModelPoint center{k_eye_center[0], k_eye_center[1], k_eye_center[2]};
  const bool front_pole = from_degrees == 0;
  const bool back_pole = to_degrees == 180;
  std::vector<std::vector<std::uint32_t>> loops;
  for (int i = 0; i <= rings; ++i) {
    const double polar = base::radians(from_degrees + (to_degrees - from_degrees) * i / rings);
    const bool pole = (i == 0 && front_pole) || (i == rings && back_pole);
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (int j = 0; j < segments; ++j) {
      if (pole && j > 0) {
        loop.push_back(loop[0]);
        continue;
      }
      const double around = 2 * base::k_pi * j / segments;
      const double sine = pole ? 0 : base::sin(polar);
      loop.push_back(static_cast<std::uint32_t>(cap.points.size()));
      cap.points.push_back(center + ModelVector{sine * base::cos(around), sine * base::sin(around), base::cos(polar)} *
                                        (k_eye_radius * radius));
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(rings); ++i) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(segments); ++j) {
      const std::size_t k = (j + 1) % static_cast<std::size_t>(segments);
      const std::array<std::uint32_t, 4> q{loops[i][j], loops[i + 1][j], loops[i + 1][k], loops[i][k]};
      if (q[0] != q[3]) cap.triangles.push_back({q[0], q[2], q[3]});
      if (q[1] != q[2]) cap.triangles.push_back({q[0], q[1], q[2]});
    }
  }
  return cap;
}

Surface make_teeth() {
  constexpr std::size_t k_along = 19;
  constexpr std::size_t k_around = 8;
  Surface teeth;
  for (std::size_t i = 0; i < k_along; ++i) {
    const double t = (static_cast<double>(i) - 9.0) / 9.0;
    const double angle = base::radians(78) * t;
    // The arch of the jaw, an ellipse; the band closes at its ends.
    const double end = std::sqrt(std::max(1 - t * t * t * t * t * t, 1e-4));
    const ModelPoint middle{2.05 * base::sin(angle), k_mouth_y + 0.28, 5.35 + 2.45 * base::cos(angle)};
    const ModelVector out = geometry::normalized({base::sin(angle) * 2.45, 0, base::cos(angle) * 2.05});
    for (std::size_t j = 0; j < k_around; ++j) {
      const double turn = 2 * base::k_pi * static_cast<double>(j) / k_around;
      teeth.points.push_back(middle + (out * (0.2 * base::cos(turn)) + ModelVector{0, 0.5 * base::sin(turn), 0}) * end);
    }
  }
  const auto at = [](std::size_t i, std::size_t j) { return static_cast<std::uint32_t>(i * k_around + j % k_around); };
  for (std::size_t i = 0; i + 1 < k_along; ++i) {
    for (std::size_t j = 0; j < k_around; ++j) {
      teeth.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      teeth.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  for (std::size_t j = 1; j + 1 < k_around; ++j) {
    teeth.triangles.push_back({at(0, 0), at(0, j), at(0, j + 1)});
    teeth.triangles.push_back({at(k_along - 1, 0), at(k_along - 1, j + 1), at(k_along - 1, j)});
  }
  return teeth;
}

}  // namespace penpose::head
