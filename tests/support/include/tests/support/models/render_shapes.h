#pragma once

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <vector>

#include "core/document/model.h"
#include "ui/render/appearance.h"
#include "ui/render/framing.h"
#include "ui/render/picture/image.h"
#include "ui/render/renderer.h"

namespace penpose::render {

/// Adds a closed sphere; the pole looks along +Z. `bulge` lifts the cap within 30 degrees of it.
inline void add_sphere(mesh::MeshSource& source, geometry::ModelPoint middle, double radius, int rings = 24,
                       double bulge = 0) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  const int sides = 2 * rings;
  const auto ring_first = [&](int ring) { return first + 1 + static_cast<std::uint32_t>((ring - 1) * sides); };
  const auto put = [&](double polar, double turn) {
    const double r = radius * (1 + (polar < std::numbers::pi / 6 ? bulge : 0));
    source.positions.push_back(middle + r * geometry::ModelVector{std::sin(polar) * std::cos(turn),
                                                                  std::sin(polar) * std::sin(turn), std::cos(polar)});
  };
  put(0, 0);
  for (int ring = 1; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      put(std::numbers::pi * ring / rings, 2 * std::numbers::pi * side / sides);
    }
  }
  put(std::numbers::pi, 0);
  const auto last = static_cast<std::uint32_t>(source.positions.size()) - 1;
  for (int side = 0; side < sides; ++side) {
    const auto a = static_cast<std::uint32_t>(side);
    const auto b = static_cast<std::uint32_t>((side + 1) % sides);
    source.triangles.push_back({first, ring_first(1) + a, ring_first(1) + b});
    source.triangles.push_back({last, ring_first(rings - 1) + b, ring_first(rings - 1) + a});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      const std::uint32_t u = ring_first(ring);
      const std::uint32_t w = ring_first(ring + 1);
      source.triangles.push_back({u + a, w + a, w + b});
      source.triangles.push_back({u + a, w + b, u + b});
    }
  }
}

/// Adds a box of the given half sizes, 8 vertices.
inline void add_box(mesh::MeshSource& source, geometry::ModelPoint middle, geometry::ModelVector half) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  for (int corner = 0; corner < 8; ++corner) {
    const geometry::ModelVector sign{(corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                     (corner & 4) != 0 ? 1 : -1};
    source.positions.push_back(middle + sign * half);
  }
  constexpr std::uint32_t k_quads[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                           {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
  for (const auto& q : k_quads) {
    source.triangles.push_back({first + q[0], first + q[1], first + q[2]});
    source.triangles.push_back({first + q[0], first + q[2], first + q[3]});
  }
}

inline document::Model model_of(mesh::MeshSource source) {
  return document::make_model(mesh::TriangleMesh::build(std::move(source)).value(), nullptr, nullptr).value();
}

inline document::Model sphere_model(double radius, geometry::ModelPoint middle = geometry::ModelPoint{0}) {
  mesh::MeshSource source;
  add_sphere(source, middle, radius, 48);
  return model_of(std::move(source));
}

inline std::vector<glm::vec3> to_float(const std::vector<geometry::ModelPoint>& points) {
  return {points.begin(), points.end()};
}

/// A model with everything that a scene of it needs.
struct Shown {
  explicit Shown(document::Model shown) : model(std::move(shown)) {
    PosedMesh posed = posed_mesh(model);
    positions = std::move(posed.positions);
    normals = std::move(posed.normals);
  }
  [[nodiscard]] Scene scene() const {
    Scene made;
    made.positions = positions;
    made.normals = normals;
    made.triangles = model.mesh->triangles();
    return made;
  }
  document::Model model;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
};

/// Pixels in which two pictures of one size differ by more than `step` in any channel.
inline int differing(const Image& a, const Image& b, int step = 2) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    bool far = false;
    for (std::size_t c = 0; c < 4; ++c) far = far || std::abs(a.pixels[i + c] - b.pixels[i + c]) > step;
    count += far ? 1 : 0;
  }
  return count;
}

/// The test machine's renderer, of the best way or of one. Every test that uses one of OpenGL fails where there is
/// none.
inline std::unique_ptr<Renderer> make_renderer(std::optional<DrawWay> way = std::nullopt) {
  auto made = make_offscreen_renderer(way);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().line());
  return made.ok() ? std::move(*made) : nullptr;
}

/// A test of what holds for each way to draw.
class EachWay : public testing::TestWithParam<DrawWay> {};
inline std::string way_name(const testing::TestParamInfo<DrawWay>& way) { return std::string(name_of(way.param)); }

}  // namespace penpose::render
