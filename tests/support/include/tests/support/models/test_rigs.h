#pragma once

#include <cmath>
#include <glm/matrix.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/rotation.h"
#include "core/mesh/triangle_mesh.h"
#include "core/rig/blend_shapes.h"
#include "core/rig/character_rig.h"
#include "core/rig/skeleton.h"
#include "tests/support/random.h"

namespace penpose::tests {

/// A flat grid of (columns + 1) x (rows + 1) vertices over 0..width x 0..height at z = 0, facing +z.
inline std::shared_ptr<const mesh::TriangleMesh> grid_mesh(std::uint32_t columns, std::uint32_t rows, double width = 1,
                                                           double height = 1) {
  mesh::MeshSource source;
  for (std::uint32_t r = 0; r <= rows; ++r) {
    for (std::uint32_t c = 0; c <= columns; ++c)
      source.positions.emplace_back(width * c / columns, height * r / rows, 0.0);
  }
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t i = r * (columns + 1) + c;
      source.triangles.push_back({i, i + 1, i + columns + 2});
      source.triangles.push_back({i, i + columns + 2, i + columns + 1});
    }
  }
  return mesh::TriangleMesh::build(std::move(source)).value();
}

/// Smooth random bumps: shape i moves the vertices around a random centre in a random direction.
inline std::shared_ptr<const rig::BlendShapes> random_shapes(const mesh::TriangleMesh& mesh, std::size_t count,
                                                             std::uint64_t seed, double reach = 0.3,
                                                             double size = 0.2) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<rig::BlendShape> shapes;
  for (std::size_t s = 0; s < count; ++s) {
    rig::BlendShape shape;
    shape.parameter.name = "shape" + std::to_string(s);
    const geometry::ModelPoint center = mesh.positions()[random() % mesh.vertex_count()];
    const geometry::ModelVector direction{uniform() - 0.5, uniform() - 0.5, uniform() - 0.5};
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const double d = geometry::distance(mesh.positions()[v], center) / reach;
      if (d >= 1) continue;
      shape.vertices.push_back(v);
      shape.deltas.emplace_back(direction * (2 * size * (1 - d * d)));
    }
    shapes.push_back(std::move(shape));
  }
  return rig::BlendShapes::make(std::move(shapes), mesh.vertex_count()).value();
}

/// A ball of `rows` bands and `columns` sectors, closed at the poles, facing outwards.
inline std::shared_ptr<const mesh::TriangleMesh> ball_mesh(std::uint32_t rows, std::uint32_t columns,
                                                           double radius = 1) {
  mesh::MeshSource source;
  source.positions.emplace_back(0, radius, 0);
  for (std::uint32_t r = 1; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double a = 3.14159265358979 * r / rows;
      const double b = 2 * 3.14159265358979 * c / columns;
      source.positions.emplace_back(radius * std::sin(a) * std::sin(b), radius * std::cos(a),
                                    radius * std::sin(a) * std::cos(b));
    }
  }
  const auto last = static_cast<std::uint32_t>(source.positions.size());
  source.positions.emplace_back(0, -radius, 0);
  const auto at = [&](std::uint32_t r, std::uint32_t c) { return 1 + (r - 1) * columns + c % columns; };
  for (std::uint32_t c = 0; c < columns; ++c) {
    source.triangles.push_back({0, at(1, c), at(1, c + 1)});
    for (std::uint32_t r = 1; r + 1 < rows; ++r) {
      source.triangles.push_back({at(r, c), at(r + 1, c), at(r + 1, c + 1)});
      source.triangles.push_back({at(r, c), at(r + 1, c + 1), at(r, c + 1)});
    }
    source.triangles.push_back({at(rows - 1, c), last, at(rows - 1, c + 1)});
  }
  return mesh::TriangleMesh::build(std::move(source)).value();
}

/// A chain of joints along +x, `spacing` apart and each turned `bend` radians about z against its parent at rest; every
/// vertex is shared by the two joints that are nearest along x. The inverse bind matrices take the rest pose to the
/// identity.
inline std::shared_ptr<const rig::Skeleton> chain_skeleton(const mesh::TriangleMesh& mesh, std::size_t count,
                                                           double spacing, double bend = 0) {
  std::vector<rig::Joint> joints(count);
  glm::dmat4 world(1);
  for (std::size_t j = 0; j < count; ++j) {
    joints[j].name = "joint" + std::to_string(j);
    joints[j].parent = static_cast<std::int32_t>(j) - 1;
    joints[j].translation = {j == 0 ? 0.0 : spacing, 0, 0};
    joints[j].rest_rotation = geometry::quaternion_from_xyz({0, 0, bend});
    world = world * geometry::compose(joints[j].translation, joints[j].rest_rotation, {1, 1, 1});
    joints[j].inverse_bind = glm::inverse(world);
  }
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  for (const auto& p : mesh.positions()) {
    const double along = std::fmin(std::fmax(p.x / spacing, 0.0), static_cast<double>(count - 1));
    const auto joint = static_cast<std::uint32_t>(along);
    const double share = along - joint;
    influences.push_back({joint, 1 - share});
    if (joint + 1 < count) influences.push_back({joint + 1, share});
    first.push_back(static_cast<std::uint32_t>(influences.size()));
  }
  return rig::Skeleton::make(std::move(joints), std::move(first), std::move(influences)).value();
}

/// One value a parameter, each somewhere in its range.
inline rig::Pose random_pose(const rig::Rig& rig, Random& random) {
  rig::Pose pose;
  for (const rig::Parameter& p : rig.parameters()) pose.push_back(random(p.minimum, p.maximum));
  return pose;
}

/// Positions of all vertices.
inline std::vector<geometry::ModelPoint> all_positions(const rig::Rig& rig, const rig::Pose& pose) {
  std::vector<geometry::ModelPoint> positions(rig.vertex_count());
  rig.evaluate(pose, positions);
  return positions;
}

}  // namespace penpose::tests
