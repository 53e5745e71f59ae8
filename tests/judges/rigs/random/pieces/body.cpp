#include "tests/judges/rigs/random/pieces/body.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::judges {
namespace {

/// Rings from pole to pole.
void add_ball(mesh::MeshSource& source, const ModelPoint& center, const ModelVector& radii) {
  constexpr std::uint32_t k_around = 8;
  constexpr std::uint32_t k_rings = 5;
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  for (std::uint32_t r = 0; r <= k_rings; ++r) {
    const double v = base::k_pi * (r + 0.5) / (k_rings + 1);
    for (std::uint32_t a = 0; a < k_around; ++a) {
      const double u = 2 * base::k_pi * a / k_around;
      source.positions.push_back(
          center + radii * ModelVector{base::sin(u) * base::sin(v), base::cos(v), base::cos(u) * base::sin(v)});
    }
  }
  for (std::uint32_t r = 0; r < k_rings; ++r) {
    for (std::uint32_t a = 0; a < k_around; ++a) {
      const std::uint32_t next = (a + 1) % k_around;
      const std::uint32_t high = first + r * k_around;
      const std::uint32_t low = high + k_around;
      source.triangles.push_back({high + a, low + a, low + next});
      source.triangles.push_back({high + a, low + next, high + next});
    }
  }
}

}  // namespace

std::vector<BodyPiece> add_body(Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double h = marks.high - marks.low;
  const double build = dice.real(0.8, 1.2);
  const double z = marks.mouth.z - 0.4 * h;
  struct Planned {
    const char* name;
    const char* above;
    ModelPoint joint;  ///< in heights of the head, from its lowest place
    ModelPoint center;
    ModelVector radii;
  };
  const std::vector<Planned> planned{
      {"hips", "", {0, -2.4, 0}, {0, -2.4, 0}, {0.6, 0.5, 0.4}},
      {"spine", "hips", {0, -1.9, 0}, {0, -1.5, 0}, {0.55, 0.5, 0.38}},
      {"chest", "spine", {0, -1.1, 0}, {0, -0.6, 0}, {0.7, 0.6, 0.42}},
      {"upper_arm_L", "chest", {0.75, -0.35, 0}, {1.3, -0.35, 0}, {0.6, 0.17, 0.17}},
      {"upper_arm_R", "chest", {-0.75, -0.35, 0}, {-1.3, -0.35, 0}, {0.6, 0.17, 0.17}},
      {"lower_arm_L", "upper_arm_L", {1.9, -0.35, 0}, {2.4, -0.35, 0}, {0.6, 0.15, 0.15}},
      {"lower_arm_R", "upper_arm_R", {-1.9, -0.35, 0}, {-2.4, -0.35, 0}, {0.6, 0.15, 0.15}},
      {"leg_L", "hips", {0.3, -2.7, 0}, {0.3, -4.2, 0}, {0.25, 1.5, 0.25}},
      {"leg_R", "hips", {-0.3, -2.7, 0}, {-0.3, -4.2, 0}, {0.25, 1.5, 0.25}}};
  const std::size_t pieces = dice.one_of(std::vector<std::size_t>{3, 5, planned.size(), planned.size()});

  mesh::MeshSource source;
  source.positions.assign(parts.rest().begin(), parts.rest().end());
  source.triangles.assign(parts.mesh->triangles().begin(), parts.mesh->triangles().end());
  source.parts.assign(parts.mesh->parts().begin(), parts.mesh->parts().end());
  mesh::Part part{"body", static_cast<std::uint32_t>(source.positions.size()), 0,
                  static_cast<std::uint32_t>(source.triangles.size()), 0};
  const auto placed = [&](const ModelPoint& p) { return ModelPoint{0, marks.low, z} + p * (build * h); };
  std::vector<BodyPiece> body;
  for (std::size_t k = 0; k < pieces; ++k) {
    const Planned& plan = planned[k];
    BodyPiece piece{plan.name, plan.above, placed(plan.joint), {}};
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    add_ball(source, placed(plan.center), plan.radii * (build * h));
    for (std::uint32_t v = first; v < source.positions.size(); ++v) piece.vertices.push_back(v);
    body.push_back(std::move(piece));
  }
  part.vertex_count = static_cast<std::uint32_t>(source.positions.size()) - part.first_vertex;
  part.triangle_count = static_cast<std::uint32_t>(source.triangles.size()) - part.first_triangle;
  source.parts.push_back(std::move(part));
  const std::size_t count = source.positions.size();
  parts.mesh = mesh::TriangleMesh::build(std::move(source)).value();
  for (auto& [name, field] : parts.fields) field.resize(count, ModelVector{0});
  parts.jaw_share.resize(count, 0.0);
  return body;
}

}  // namespace penpose::judges
