#include "core/head/parts.h"

#include <algorithm>
#include <array>
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

namespace {

/// The triangles of a tube whose points are there: rings of as many points each, one after the other, both ends closed.
void close_tube(Surface& tube, std::size_t rings, std::size_t around) {
  const auto at = [&](std::size_t i, std::size_t j) { return static_cast<std::uint32_t>(i * around + j % around); };
  for (std::size_t i = 0; i + 1 < rings; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      tube.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      tube.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  for (std::size_t j = 1; j + 1 < around; ++j) {
    tube.triangles.push_back({at(0, 0), at(0, j), at(0, j + 1)});
    tube.triangles.push_back({at(rings - 1, 0), at(rings - 1, j + 1), at(rings - 1, j)});
  }
}

/// The arch of a row of teeth, an ellipse in the plane of `y` whose ends lie lower by `dip`; the band closes there.
Surface arch(double y, double width, double back, double depth, double thick, double high, double dip = 0) {
  constexpr std::size_t k_along = 19;
  constexpr std::size_t k_around = 8;
  Surface teeth;
  for (std::size_t i = 0; i < k_along; ++i) {
    const double t = (static_cast<double>(i) - 9.0) / 9.0;
    const double angle = base::radians(78) * t;
    const double end = std::sqrt(std::max(1 - t * t * t * t * t * t, 1e-4));
    const ModelPoint middle{width * base::sin(angle), y - dip * t * t * t * t, back + depth * base::cos(angle)};
    const ModelVector out = geometry::normalized({base::sin(angle) * depth, 0, base::cos(angle) * width});
    for (std::size_t j = 0; j < k_around; ++j) {
      const double turn = 2 * base::k_pi * static_cast<double>(j) / k_around;
      teeth.points.push_back(middle +
                             (out * (thick * base::cos(turn)) + ModelVector{0, high * base::sin(turn), 0}) * end);
    }
  }
  close_tube(teeth, k_along, k_around);
  return teeth;
}

}  // namespace

Surface make_teeth() { return arch(k_mouth_y + 0.28, 2.05, 5.35, 2.45, 0.2, 0.5); }

Surface make_teeth_lower() { return arch(k_mouth_y - 0.82, 1.85, 5.25, 2.25, 0.18, 0.42, 0.9); }

Surface make_tongue() {
  constexpr std::size_t k_rings = 9;
  constexpr std::size_t k_segments = 16;
  Surface tongue;
  const ModelPoint tongue_middle{0, k_mouth_y - 0.78, 6.0};
  // Rings from the tip to the root, with a furrow along the top.
  for (std::size_t i = 0; i < k_rings; ++i) {
    const double polar = base::k_pi * (static_cast<double>(i) + 0.35) / (static_cast<double>(k_rings) - 0.3);
    for (std::size_t j = 0; j < k_segments; ++j) {
      const double around = 2 * base::k_pi * static_cast<double>(j) / k_segments;
      const double up = base::sin(around);
      const double furrow = up > 0 ? 0.12 * up * bump(base::cos(around) * base::cos(around) * 9.0) : 0.0;
      tongue.points.push_back(tongue_middle + ModelVector{1.15 * base::sin(polar) * base::cos(around),
                                                          (0.42 * up - furrow) * base::sin(polar),
                                                          1.25 * base::cos(polar)});
    }
  }
  close_tube(tongue, k_rings, k_segments);
  return tongue;
}

void hang_on(Surface& wall, Surface& thing) {
  const auto middle = [](const Surface& surface, const mesh::Triangle& t) {
    return (surface.points[t[0]] + surface.points[t[1]] + surface.points[t[2]]) / 3.0;
  };
  // The nearest two triangles, of which the thing's looks down.
  std::size_t own = 0;
  std::size_t other = 0;
  double nearest = 1e300;
  for (std::size_t i = 0; i < thing.triangles.size(); ++i) {
    const mesh::Triangle& t = thing.triangles[i];
    const ModelVector e = thing.points[t[1]] - thing.points[t[0]];
    const ModelVector f = thing.points[t[2]] - thing.points[t[0]];
    if (!(e.z * f.x - e.x * f.z < 0)) continue;
    for (std::size_t k = 0; k < wall.triangles.size(); ++k) {
      const double distance = geometry::distance(middle(thing, t), middle(wall, wall.triangles[k]));
      if (distance >= nearest) continue;
      nearest = distance;
      own = i;
      other = k;
    }
  }
  const mesh::Triangle hole = wall.triangles[other];
  const mesh::Triangle end = thing.triangles[own];
  wall.triangles.erase(wall.triangles.begin() + static_cast<std::ptrdiff_t>(other));
  thing.triangles.erase(thing.triangles.begin() + static_cast<std::ptrdiff_t>(own));
  std::array<std::uint32_t, 3> ring{};
  for (std::size_t k = 0; k < 3; ++k) {
    ring[k] = static_cast<std::uint32_t>(thing.points.size());
    thing.points.push_back(wall.points[hole[k]]);
  }
  // The wall's edges one way round, the thing's the other.
  const std::array<std::uint32_t, 3> facing{end[1], end[0], end[2]};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    thing.triangles.push_back({ring[k], ring[next], facing[next]});
    thing.triangles.push_back({ring[k], facing[next], facing[k]});
  }
}

}  // namespace penpose::head
