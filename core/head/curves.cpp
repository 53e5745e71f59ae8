#include "core/head/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/math.h"
#include "core/geometry/bvh.h"
#include "core/head/sculpt.h"

namespace penpose::head {
namespace {

using Points = std::vector<ModelPoint>;

bool near(double a, double b) { return std::abs(a - b) < 1e-6; }

/// The outer edge of the rim of the +x eye's upper or lower lid, from the inner to the outer corner.
Points lid_edge(const Half& half, bool upper) {
  Points loop;
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    if (near(half.marks[v].x, 1)) loop.push_back(half.points[v]);
  }
  std::stable_sort(loop.begin(), loop.end(), [](const ModelPoint& a, const ModelPoint& b) { return a.x < b.x; });
  const ModelPoint inner = loop.front();
  const ModelPoint outer = loop.back();
  std::erase_if(loop, [&](const ModelPoint& p) {
    const double side = (outer.x - inner.x) * (p.y - inner.y) - (outer.y - inner.y) * (p.x - inner.x);
    return upper ? side < 0 : side > 0;
  });
  return loop;
}

/// Vertices of one mouth loop on the upper or lower lip, from the -x corner to the +x corner.
Points lip_edge(const Half& half, double loop, double lip) {
  Points points;
  for (std::size_t v = 0; v < half.points.size(); ++v) {
    if (near(half.marks[v].y, loop) && half.marks[v].z * lip > -1e-6) points.push_back(half.points[v]);
  }
  // Upper and lower lip have the corner in common; only the middle has x = 0.
  std::stable_sort(points.begin(), points.end(), [](const ModelPoint& a, const ModelPoint& b) { return a.x < b.x; });
  Points both;
  for (std::size_t i = points.size(); i-- > 1;) both.emplace_back(-points[i].x, points[i].y, points[i].z);
  both.insert(both.end(), points.begin(), points.end());
  return both;
}

Points mirror(Points points) {
  for (ModelPoint& p : points) p.x = -p.x;
  return points;
}

struct Gluer {
  const mesh::TriangleMesh& mesh;
  double unit;
  geometry::TriangleBvh bvh;
  std::vector<std::uint32_t> triangle_of;  ///< one a skin vertex

  static std::vector<glm::vec3> floats(const mesh::TriangleMesh& mesh) {
    return {mesh.positions().begin(), mesh.positions().end()};
  }
  Gluer(const mesh::TriangleMesh& of, std::uint32_t triangles, double metre)
      : mesh(of), unit(metre), bvh(floats(of), of.triangles().first(triangles)) {
    for (std::uint32_t t = 0; t < triangles; ++t) {
      for (const std::uint32_t v : of.triangles()[t]) {
        if (v >= triangle_of.size()) triangle_of.resize(v + 1);
        triangle_of[v] = t;
      }
    }
  }

  /// Points that are vertices of the mesh: the vertex nearest to each.
  [[nodiscard]] document::NamedCurve at_vertices(std::string name, const Points& points) const {
    document::NamedCurve curve{std::move(name), {}};
    for (const ModelPoint& p : points) {
      const ModelPoint wanted = p * unit;
      double nearest = 1e300;
      std::uint32_t vertex = 0;
      for (std::uint32_t v = 0; v < triangle_of.size(); ++v) {
        const ModelVector d = mesh.positions()[v] - wanted;
        const double square = d.x * d.x + d.y * d.y + d.z * d.z;
        if (square >= nearest) continue;
        nearest = square;
        vertex = v;
      }
      const mesh::Triangle& triangle = mesh.triangles()[triangle_of[vertex]];
      mesh::MeshPoint point{triangle_of[vertex], {0, 0, 0}};
      for (std::size_t k = 0; k < 3; ++k) point.barycentric[k] = triangle[k] == vertex ? 1 : 0;
      curve.points.push_back(point);
    }
    return curve;
  }
  /// Points of the surface that a ray from outside meets on its way to each of `points`, coming along -outward.
  [[nodiscard]] document::NamedCurve from_outside(std::string name, const Points& points,
                                                  const std::vector<ModelVector>& outward) const {
    document::NamedCurve curve{std::move(name), {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto hit = bvh.nearest_hit({(points[i] + outward[i] * 40.0) * unit, -outward[i]});
      if (hit) curve.points.push_back({hit->triangle, hit->barycentric});
    }
    return curve;
  }
};

}  // namespace

std::vector<document::NamedCurve> make_curves(const Half& half, const mesh::TriangleMesh& mesh,
                                              std::uint32_t skin_triangles, double unit) {
  const Gluer glue(mesh, skin_triangles, unit);
  std::vector<document::NamedCurve> curves;
  for (const bool right : {false, true}) {
    const std::string side = right ? "_R" : "_L";
    for (const bool upper : {true, false}) {
      const Points edge = lid_edge(half, upper);
      curves.push_back(glue.at_vertices((upper ? "eyelid_upper" : "eyelid_lower") + side, right ? mirror(edge) : edge));
    }
    Points brow;
    for (int i = 0; i <= 24; ++i) {
      const double x = 1.0 + 4.5 * i / 24;
      brow.emplace_back(right ? -x : x, brow_line(x), 0);
    }
    curves.push_back(glue.from_outside("brow" + side, brow, {brow.size(), ModelVector{0, 0, 1}}));
  }
  curves.push_back(glue.at_vertices("lip_upper", lip_edge(half, 2, 1)));
  curves.push_back(glue.at_vertices("lip_lower", lip_edge(half, 2, -1)));
  curves.push_back(glue.at_vertices("lip_upper_inner", lip_edge(half, 0, 1)));
  curves.push_back(glue.at_vertices("lip_lower_inner", lip_edge(half, 0, -1)));
  Points jaw;
  std::vector<ModelVector> outward;
  for (int i = -20; i <= 20; ++i) {
    const double angle = base::radians(88) * i / 20;
    const ModelPoint edge = point_at_angle(row(12), std::abs(base::degrees(angle)));
    jaw.emplace_back(0, edge.y + 0.35, 0);
    outward.emplace_back(base::sin(angle), 0, base::cos(angle));
  }
  curves.push_back(glue.from_outside("jaw", jaw, outward));
  Points nose;
  for (int i = 0; i <= 16; ++i) nose.emplace_back(0, 1.6 - 4.9 * i / 16, 0);
  curves.push_back(glue.from_outside("nose_bridge", nose, {nose.size(), ModelVector{0, 0, 1}}));
  return curves;
}

}  // namespace penpose::head
