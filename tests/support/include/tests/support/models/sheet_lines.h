#pragma once

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "core/curve/sheet_line.h"
#include "core/mesh/triangle_mesh.h"
#include "tests/support/models/test_rigs.h"

// Lines drawn by an unsteady hand over a mesh, lips, lids and rims among them: each stays on one sheet.

namespace penpose::tests {

/// Vertices beside each vertex of a mesh, welded.
using Beside = std::vector<std::vector<std::uint32_t>>;

/// The way along edges of the mesh from one triangle to another, at most `most`.
inline double way_over_surface(const mesh::TriangleMesh& mesh, const Beside& beside, std::uint32_t from,
                               std::uint32_t to, double most) {
  std::map<std::uint32_t, double> known;
  std::set<std::pair<double, std::uint32_t>> open;
  for (const std::uint32_t v : mesh.triangles()[from]) open.insert({0.0, mesh.weld()[v]});
  std::set<std::uint32_t> destination;
  for (const std::uint32_t v : mesh.triangles()[to]) destination.insert(mesh.weld()[v]);
  while (!open.empty()) {
    const auto [way, vertex] = *open.begin();
    open.erase(open.begin());
    if (way > most) return way;
    if (destination.count(vertex) > 0) return way;
    if (!known.insert({vertex, way}).second) continue;
    for (const std::uint32_t next : beside[vertex]) {
      if (known.count(next) == 0)
        open.insert({way + geometry::distance(mesh.positions()[vertex], mesh.positions()[next]), next});
    }
  }
  return 1e300;
}

class SheetLines {
 public:
  using ModelPoint = geometry::ModelPoint;
  using PxPoint = geometry::PxPoint;

  explicit SheetLines(const mesh::TriangleMesh& mesh)
      : mesh_(mesh),
        positions_(mesh.positions().begin(), mesh.positions().end()),
        tree_(positions_, mesh.triangles()),
        sheets_(mesh),
        beside_(mesh.vertex_count()) {
    std::vector<geometry::ModelVector> normals(mesh.vertex_count(), geometry::ModelVector{0});
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    double sum = 0;
    for (const mesh::Triangle& t : mesh.triangles()) {
      const ModelPoint& a = mesh.positions()[t[0]];
      const ModelPoint e = mesh.positions()[t[1]] - a, f = mesh.positions()[t[2]] - a;
      const ModelPoint normal{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t one = mesh.weld()[t[k]], two = mesh.weld()[t[(k + 1) % 3]];
        beside_[one].push_back(two);
        beside_[two].push_back(one);
        normals[one] += normal;
        ++uses[std::minmax(one, two)];
        sum += geometry::distance(mesh.positions()[one], mesh.positions()[two]);
      }
    }
    const double edge = sum / (3.0 * static_cast<double>(mesh.triangle_count()));
    for (const auto& [ends, count] : uses) {
      if (count == 1) seams_.push_back(ends.first);
    }
    // Where two sheets face each other: lips that are closed, lids.
    std::map<std::tuple<int, int, int>, std::vector<std::uint32_t>> cells;
    const auto cell = [&](const ModelPoint& p, int x, int y, int z) {
      return std::tuple{static_cast<int>(std::floor(p.x / edge)) + x, static_cast<int>(std::floor(p.y / edge)) + y,
                        static_cast<int>(std::floor(p.z / edge)) + z};
    };
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.weld()[v] == v && !beside_[v].empty()) cells[cell(mesh.positions()[v], 0, 0, 0)].push_back(v);
    }
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.weld()[v] != v || beside_[v].empty()) continue;
      const auto own = geometry::normalized(normals[v]);
      for (int i = 0; i < 27; ++i) {
        const auto found = cells.find(cell(mesh.positions()[v], i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
        if (found == cells.end()) continue;
        for (const std::uint32_t other : found->second) {
          const auto n = geometry::normalized(normals[other]);
          const bool faces = own.x * n.x + own.y * n.y + own.z * n.z < -0.3;
          if (faces && geometry::distance(mesh.positions()[v], mesh.positions()[other]) < edge) seams_.push_back(v);
        }
      }
    }
  }

  [[nodiscard]] std::size_t seam_count() const { return seams_.size(); }

  /// Draws lines and checks each; returns how many touched the mesh. `along_seams`: from one place of a seam to another
  /// that is near, else from anywhere to anywhere.
  int draw(int lines, std::uint64_t seed, bool along_seams) {
    Random random(seed);
    int drawn = 0;
    for (int i = 0; i < lines; ++i) {
      const auto camera = geometry::frame_box(mesh_.rest_box(), {1280, 960}, random(-50, 50), random(-15, 15));
      const std::size_t from = along_seams ? seams_[random.index(seams_.size())] : random.index(mesh_.vertex_count());
      const PxPoint start = camera.project(mesh_.positions()[from]).value_or(PxPoint{640, 480});
      double length = random(30, 300);
      double across = random(-1, 1), along = random(-1, 1);
      for (int tries = 0; along_seams && tries < 200; ++tries) {
        const std::size_t to = seams_[random.index(seams_.size())];
        const auto end = camera.project(mesh_.positions()[to]);
        if (!end || geometry::distance(*end, start) < 20 || geometry::distance(*end, start) > 160) continue;
        length = geometry::distance(*end, start);
        along = end->x - start.x;
        across = end->y - start.y;
        break;
      }
      const double bend = along_seams ? random(-0.001, 0.001) : random(-0.01, 0.01);
      const double norm = std::max(1e-9, std::hypot(across, along));
      std::vector<PxPoint> line;
      for (double s = 0; s < length; s += 3) {
        const double way = bend * s * s;
        line.push_back({start.x + (along * s - across * way) / norm + random(-2, 2),
                        start.y + (across * s + along * way) / norm + random(-2, 2)});
      }
      drawn += check(line, camera, length, i) ? 1 : 0;
    }
    return drawn;
  }

  /// Whether a line touches the mesh; expects that it stays on one sheet. `length`: px. `number`: named in failures.
  bool check(const std::vector<PxPoint>& line, const geometry::Camera& camera, double length, int number) {
    const auto curve = curve::sheet_curve(line, 32, camera, {tree_, positions_, mesh_.triangles(), sheets_});
    if (!curve) return false;
    for (std::size_t k = 0; k + 1 < curve->points.size(); ++k) {
      const std::uint32_t one = curve->points[k].triangle, two = curve->points[k + 1].triangle;
      // A walk looks at least 2 px of a picture 1000 px high ahead.
      const double step = std::max(length / 31, 2.0) * camera.units_per_px(camera.depth(curve->positions[k]));
      if (sheets_.component(one) != sheets_.component(two)) {
        EXPECT_LT(geometry::distance(curve->positions[k], curve->positions[k + 1]), 8 * step + 1e-9)
            << "parts may be crossed where they touch; line " << number;
        continue;
      }
      double edge = 0;
      for (const std::uint32_t t : {one, two}) {
        const mesh::Triangle& c = mesh_.triangles()[t];
        for (std::size_t e = 0; e < 3; ++e)
          edge = std::max(edge, geometry::distance(mesh_.positions()[c[e]], mesh_.positions()[c[(e + 1) % 3]]));
      }
      const double chord = geometry::distance(curve->positions[k], curve->positions[k + 1]);
      const double most = 2 * chord + 6 * step + 4 * edge;
      EXPECT_LE(way_over_surface(mesh_, beside_, one, two, most), most) << "line " << number << " at point " << k;
    }
    return true;
  }

 private:
  const mesh::TriangleMesh& mesh_;
  std::vector<glm::vec3> positions_;
  geometry::TriangleBvh tree_;
  curve::Sheets sheets_;
  Beside beside_;
  std::vector<std::uint32_t> seams_;
};

}  // namespace penpose::tests
