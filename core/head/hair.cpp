#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/head/parts.h"

namespace penpose::head {
namespace {

constexpr std::uint32_t k_none = 0xffffffffU;
constexpr double k_degree = 0.13;  // length of a degree around the head
constexpr double k_axis_z = -0.9;
constexpr double k_edge = 0.08;

/// Height of the hair line, by the angle around the head (0 front, 180 back).
double hair_line(double degrees) {
  return profile({{0, 7.6}, {15, 7.7}, {30, 7.4}, {42, 6.4}, {50, 5.0}, {57, 3.6}, {63, 1.6}, {67, 0.0}, {73, -0.2},
                  {79, 1.4}, {86, 2.7}, {100, 2.7}, {110, 1.2}, {120, -2.0}, {135, -4.4}, {180, -5.2}},
                 degrees);
}

/// Where a point is around the head, and how far inside the hair line.
struct Place {
  double degrees = 0;
  double slope = 0;  ///< of the line
  double above = 0;  ///< distance to the line, not height: where the line is steep, it is a side burn
};
Place distance_to_line(const ModelPoint& p) {
  Place place;
  place.degrees = base::degrees(base::atan2(p.x, p.z - k_axis_z));
  const double line = hair_line(place.degrees);
  place.slope = (hair_line(place.degrees + 1) - hair_line(place.degrees - 1)) / (2 * k_degree);
  place.above = (p.y - line) / std::sqrt(1 + place.slope * place.slope);
  return place;
}

/// Slides a point outside the line along the head until it is k_edge outside, so that the cap ends parallel to the line.
ModelPoint drawn_to_line(ModelPoint p) {
  for (int i = 0; i < 3; ++i) {
    const Place place = distance_to_line(p);
    const double step = -k_edge - place.above;
    if (step <= 0) break;
    const double size = std::sqrt(1 + place.slope * place.slope);
    const double degrees = place.degrees - step * place.slope / size / k_degree;
    if (p.x > 0) {
      const double radius = std::sqrt(p.x * p.x + (p.z - k_axis_z) * (p.z - k_axis_z));
      p.x = radius * base::sin(base::radians(degrees));
      p.z = k_axis_z + radius * base::cos(base::radians(degrees));
    }
    p.y += step / size;
  }
  return p;
}

ModelPoint grown(const ModelPoint& p, double above_line) {
  const ModelVector out = geometry::normalized(p - ModelPoint{0, 3.2, -0.9});
  double thick = profile({{-0.08, -0.07}, {0, -0.01}, {0.35, 0.32}, {1.2, 0.65}, {4, 1.0}, {8, 1.1}}, above_line);
  const double body = ramp(0.2, 1.5, above_line);
  // The parting on the +x side, the swept front on the other.
  const double x = p.x - 2.4;
  const double top = ramp(4.0, 8.0, p.y);
  thick -= 0.55 * body * bump(x * x * 1.6) * top * ramp(-4, 0, p.z);
  const double fx = (p.x + 1.2) / 5.5;
  const double fz = (p.z - 5.2) / 5.0;
  const double front = body * bump(fx * fx + fz * fz) * top;
  // Strands.
  const double phase = base::atan2(p.x - 2.4, p.y - 2.0) * 6.5 + 0.2 * p.z;
  thick += 0.15 * body * base::sin(phase);
  return p + out * thick + ModelVector{-0.3, 1.3, 0.7} * front;
}

}  // namespace

Surface make_hair(const Half& half) {
  std::vector<ModelPoint> points = half.points;
  std::vector<mesh::Triangle> triangles;
  std::vector<double> above(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool ear = half.marks[v].z > 1.2 && half.marks[v].y > 4.5;
    above[v] = ear ? -9 : distance_to_line(points[v]).above;
  }
  for (const mesh::Quad& q : half.quads) {
    bool all = true;
    for (const std::uint32_t v : q) all = all && above[v] > -1.0;
    if (!all) continue;
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  std::vector<std::uint32_t> number(points.size(), k_none);
  std::vector<ModelPoint> used;
  std::vector<double> used_above;
  for (mesh::Triangle& t : triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == k_none) {
        number[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(drawn_to_line(points[v]));
        used_above.push_back(std::max(above[v], -k_edge));
      }
      v = number[v];
    }
  }
  Surface hair = mirrored(used, triangles);
  std::size_t mirror = 0;
  for (std::size_t v = 0; v < hair.points.size(); ++v) {
    if (v >= used.size()) {
      while (used[mirror].x == 0) ++mirror;
    }
    const double height = v < used.size() ? used_above[v] : used_above[mirror++];
    hair.points[v] = grown(hair.points[v], height);
  }
  return hair;
}

}  // namespace penpose::head
