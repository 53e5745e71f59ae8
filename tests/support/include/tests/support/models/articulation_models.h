#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/sketch.h"
#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::tests {

using articulation::Sketch;
using geometry::ModelPoint;
using geometry::PxPoint;

inline constexpr double k_degree = 3.14159265358979323846 / 180.0;

/// Adds a grid of rows x columns vertices as a part; a closed one joins the last column to the first.
inline void add_grid(mesh::MeshSource& source, const char* name, std::uint32_t rows, std::uint32_t columns, bool closed,
                     const std::function<ModelPoint(std::uint32_t, std::uint32_t)>& at) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  const auto first_triangle = static_cast<std::uint32_t>(source.triangles.size());
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) source.positions.push_back(at(r, c));
  }
  for (std::uint32_t r = 0; r + 1 < rows; ++r) {
    for (std::uint32_t c = 0; c < (closed ? columns : columns - 1); ++c) {
      const std::uint32_t a = first + r * columns + c;
      const std::uint32_t b = first + r * columns + (c + 1) % columns;
      source.triangles.push_back({a, b, b + columns});
      source.triangles.push_back({a, b + columns, a + columns});
    }
  }
  source.parts.push_back({name, first, rows * columns, first_triangle,
                          static_cast<std::uint32_t>(source.triangles.size()) - first_triangle});
}

inline std::shared_ptr<const articulation::Canvas> canvas_of(mesh::MeshSource source) {
  return articulation::Canvas::make(mesh::TriangleMesh::build(std::move(source)).value(), nullptr).value();
}

/// An eyeball and a skin in edge loops around the open lids, on a shell just above the ball. Azimuth and elevation as
/// seen from the centre of the ball.
struct Eye {
  static constexpr std::uint32_t k_rings = 24;
  static constexpr std::uint32_t k_columns = 96;
  static constexpr double k_upper = 18;   ///< elevation of the upper lid's margin in its middle, degrees
  static constexpr double k_lower = -15;  ///< and of the lower lid's
  static constexpr double k_corner = 50;  ///< azimuth of the corners

  ModelPoint center{0.3, 0.1, 0.0};
  double radius = 1.2;
  double shell = 1.2 * 1.02;
  geometry::Viewport viewport{1000, 1000};
  geometry::CameraPose camera{{0.3, 0.1, 12}, {0.3, 0.1, 0}, {0, 1, 0}, 20};
  std::shared_ptr<const articulation::Canvas> canvas;

  [[nodiscard]] ModelPoint on_shell(double azimuth, double elevation, double size) const {
    const double a = azimuth * k_degree;
    const double e = elevation * k_degree;
    return center + ModelPoint{std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)} * size;
  }
  [[nodiscard]] ModelPoint lid(std::uint32_t ring, std::uint32_t column) const {
    const double angle = 2 * 180.0 * k_degree * column / k_columns;
    const double s = static_cast<double>(ring) / (k_rings - 1);
    const double up = std::sin(angle);
    const double azimuth = std::cos(angle) * (k_corner + (80 - k_corner) * s);
    const double edge = margin(std::cos(angle) * k_corner, up > 0 ? k_upper : k_lower);
    return on_shell(azimuth, edge + (70 * up - edge) * s, shell);
  }
  [[nodiscard]] static std::uint32_t vertex(std::uint32_t ring, std::uint32_t column) {
    return ring * k_columns + column;
  }
  /// Vertices of the upper margin from corner to corner.
  [[nodiscard]] static std::vector<std::uint32_t> upper_margin() {
    std::vector<std::uint32_t> margin;
    for (std::uint32_t c = 0; c <= k_columns / 2; ++c) margin.push_back(vertex(0, c));
    return margin;
  }
  [[nodiscard]] PxPoint seen(const ModelPoint& p) const {
    return *geometry::Camera::make(camera, viewport).value().project(p);
  }
  [[nodiscard]] PxPoint seen(double azimuth, double elevation) const {
    return seen(on_shell(azimuth, elevation, shell));
  }
  /// The elevation of a margin at an azimuth.
  [[nodiscard]] static double margin(double azimuth, double middle) {
    return std::abs(azimuth) < k_corner ? middle * std::cos(90 * k_degree * azimuth / k_corner) : 0;
  }
  /// A line across the lids from corner to corner at an elevation that follows from the azimuth.
  [[nodiscard]] std::vector<PxPoint> across(double reach, const std::function<double(double)>& elevation,
                                            int samples = 60) const {
    std::vector<PxPoint> line;
    for (int i = 0; i <= samples; ++i) {
      const double azimuth = reach * (2.0 * i / samples - 1.0);
      line.push_back(seen(azimuth, elevation(azimuth)));
    }
    return line;
  }
  /// A lasso between two such lines.
  [[nodiscard]] std::vector<PxPoint> around(double reach, const std::function<double(double)>& low,
                                            const std::function<double(double)>& high) const {
    auto lasso = across(reach, low);
    const auto back = across(reach, high);
    lasso.insert(lasso.end(), back.rbegin(), back.rend());
    return lasso;
  }

  /// Four strokes that close the upper lid over the ball.
  [[nodiscard]] Sketch blink() const {
    Sketch sketch;
    sketch.name = "blink_L";
    sketch.viewport = viewport;
    sketch.camera = camera;
    sketch.general = around(
        55, [](double a) { return margin(a, k_upper - 1.5) - 0.7; }, [](double a) { return 52 - a * a / 70; });
    sketch.specific = around(
        51, [](double a) { return margin(a, k_upper - 1) - 0.5; }, [](double a) { return margin(a, k_upper) + 2; });
    sketch.reference = across(50, [](double a) { return margin(a, k_upper) + 0.3; });
    sketch.target = across(50, [](double a) { return margin(a, k_lower); });
    sketch.surface = articulation::Sphere{center, radius};
    return sketch;
  }
};

inline Eye make_eye() {
  Eye eye;
  mesh::MeshSource source;
  add_grid(source, "skin", Eye::k_rings, Eye::k_columns, true,
           [&](std::uint32_t r, std::uint32_t c) { return eye.lid(r, c); });
  add_grid(source, "ball_L", 41, 80, true, [&](std::uint32_t r, std::uint32_t c) {
    return eye.on_shell(c * 4.5, std::min(89.9, std::max(-89.9, r * 4.5 - 90.0)), eye.radius);
  });
  eye.canvas = canvas_of(std::move(source));
  return eye;
}

/// The same without the triangles about x = 0.9, y = 0.
inline mesh::MeshSource with_hole(mesh::MeshSource source) {
  std::erase_if(source.triangles, [&](const mesh::Triangle& t) {
    const geometry::ModelPoint& p = source.positions[t[0]];
    return std::abs(p.x - 0.9) < 0.25 && std::abs(p.y) < 0.25;
  });
  source.parts.front().triangle_count = static_cast<std::uint32_t>(source.triangles.size());
  return source;
}

/// The same triangles, each with vertices of its own.
inline mesh::MeshSource triangle_soup(const mesh::MeshSource& source) {
  mesh::MeshSource soup;
  for (const mesh::Triangle& t : source.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : t) soup.positions.push_back(source.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  soup.parts.push_back({"soup", 0, static_cast<std::uint32_t>(soup.positions.size()), 0,
                        static_cast<std::uint32_t>(soup.triangles.size())});
  return soup;
}

/// A tube along +x that grows out of a body around x = -1.
struct Trunk {
  static constexpr std::uint32_t k_rings = 120;
  static constexpr std::uint32_t k_around = 24;
  static constexpr double k_radius = 0.2;
  static constexpr double k_tip = 3.0;

  geometry::Viewport viewport{1000, 1000};
  geometry::CameraPose camera{{0.5, 0, 14}, {0.5, 0, 0}, {0, 1, 0}, 30};
  std::shared_ptr<const articulation::Canvas> canvas;

  [[nodiscard]] static double along(std::uint32_t ring) { return -2.0 + 5.0 * ring / (k_rings - 1); }
  [[nodiscard]] static ModelPoint at(std::uint32_t ring, std::uint32_t column) {
    const double x = along(ring);
    const double t = std::min(1.0, std::max(0.0, (0.3 - x) / 0.6));
    const double radius = k_radius + t * t * (3 - 2 * t);
    const double angle = 360.0 * k_degree * column / k_around;
    return {x, radius * std::cos(angle), radius * std::sin(angle)};
  }
  [[nodiscard]] PxPoint seen(const ModelPoint& p) const {
    return *geometry::Camera::make(camera, viewport).value().project(p);
  }
  [[nodiscard]] std::vector<PxPoint> box(double from, double to, double half) const {
    return {seen({from, -half, 0}), seen({to, -half, 0}), seen({to, half, 0}), seen({from, half, 0})};
  }
  /// Four strokes: the trunk from `root` on bends down by 90 degrees along a quarter of a circle of its own length.
  [[nodiscard]] Sketch curl(double root = 0.6) const {
    Sketch sketch;
    sketch.name = "curl";
    sketch.viewport = viewport;
    sketch.camera = camera;
    sketch.general = box(0.35, 3.5, 0.6);
    sketch.specific = box(root, 3.4, 0.5);
    const double length = k_tip - root;
    const double bend = length / (90 * k_degree);
    for (int i = 0; i <= 50; ++i) {
      sketch.reference.push_back(seen({root + (length - 0.02) * i / 50, 0, 0}));
      const double angle = 90 * k_degree * i / 50;
      sketch.target.push_back(seen({root + bend * std::sin(angle), -bend * (1 - std::cos(angle)), 0}));
    }
    return sketch;
  }
};

inline Trunk make_trunk() {
  Trunk trunk;
  mesh::MeshSource source;
  add_grid(source, "elephant", Trunk::k_rings, Trunk::k_around, true,
           [](std::uint32_t r, std::uint32_t c) { return Trunk::at(r, c); });
  trunk.canvas = canvas_of(std::move(source));
  return trunk;
}

}  // namespace penpose::tests
