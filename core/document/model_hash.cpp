#include "core/document/model_hash.h"

namespace penpose::document {
namespace {

void add_point(base::StateHash& hash, const geometry::ModelVector& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

void add_triangles(base::StateHash& hash, const mesh::TriangleMesh& mesh) {
  hash.add(std::uint64_t{mesh.triangle_count()});
  for (const auto& triangle : mesh.triangles()) {
    for (const std::uint32_t v : triangle) hash.add(std::uint64_t{v});
  }
}

void add_mesh(base::StateHash& hash, const mesh::TriangleMesh& mesh) {
  hash.add("mesh");
  hash.add(std::uint64_t{mesh.vertex_count()});
  for (const auto& p : mesh.positions()) add_point(hash, p);
  add_triangles(hash, mesh);
  for (const mesh::Part& part : mesh.parts()) {
    hash.add(part.name);
    hash.add(std::uint64_t{part.vertex_count});
    hash.add(std::uint64_t{part.triangle_count});
  }
}

void add_skeleton(base::StateHash& hash, const rig::Skeleton& skeleton) {
  hash.add("skeleton");
  for (const rig::Joint& joint : skeleton.joints()) {
    hash.add(joint.name);
    hash.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(joint.parent)));
    add_point(hash, joint.translation);
    const glm::dquat& q = joint.rest_rotation;
    add_point(hash, {q.x, q.y, q.z});
    hash.add(q.w);
    add_point(hash, joint.scale);
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) hash.add(joint.inverse_bind[c][r]);
    }
  }
  for (std::uint32_t v = 0; v < skeleton.vertex_count(); ++v) {
    const auto influences = skeleton.influences_of(v);
    hash.add(std::uint64_t{influences.size()});
    for (const rig::Influence& influence : influences) {
      hash.add(std::uint64_t{influence.joint});
      hash.add(influence.weight);
    }
  }
}

void add_shapes(base::StateHash& hash, const rig::BlendShapes& shapes) {
  hash.add("shapes");
  for (const rig::BlendShape& shape : shapes.shapes()) {
    hash.add(shape.parameter.name);
    hash.add(std::uint64_t{shape.vertices.size()});
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
      hash.add(std::uint64_t{shape.vertices[i]});
      add_point(hash, shape.deltas[i]);
    }
  }
}

}  // namespace

base::Hash128 hash_topology(const mesh::TriangleMesh& mesh) {
  base::StateHash hash;
  hash.add("topology");
  hash.add(std::uint64_t{mesh.vertex_count()});
  add_triangles(hash, mesh);
  return hash.digest();
}

base::Hash128 hash_surface(const Model& model) {
  base::StateHash hash;
  add_mesh(hash, *model.mesh);
  if (model.shapes) add_shapes(hash, *model.shapes);
  if (model.skeleton) add_skeleton(hash, *model.skeleton);
  return hash.digest();
}

void add_parameters(base::StateHash& hash, const rig::Rig& rig) {
  for (const rig::Parameter& parameter : rig.parameters()) {
    hash.add(parameter.name);
    hash.add(parameter.rest);
    hash.add(parameter.minimum);
    hash.add(parameter.maximum);
  }
}

void add_mesh_points(base::StateHash& hash, std::span<const mesh::MeshPoint> points) {
  hash.add(std::uint64_t{points.size()});
  for (const mesh::MeshPoint& point : points) {
    hash.add(std::uint64_t{point.triangle});
    hash.add(std::span<const double>(point.barycentric));
  }
}

void add_curves(base::StateHash& hash, std::span<const NamedCurve> curves) {
  hash.add(std::uint64_t{curves.size()});
  for (const NamedCurve& curve : curves) {
    hash.add(curve.name);
    add_mesh_points(hash, curve.points);
  }
}

void add_animations(base::StateHash& hash, std::span<const Animation> animations,
                    std::span<const std::size_t> without) {
  hash.add(std::uint64_t{animations.size() - without.size()});
  for (std::size_t a = 0; a < animations.size(); ++a) {
    if (std::find(without.begin(), without.end(), a) != without.end()) continue;
    const Animation& animation = animations[a];
    hash.add(animation.name);
    hash.add(std::uint64_t{animation.channels.size()});
    for (const Channel& channel : animation.channels) {
      hash.add(static_cast<std::uint64_t>(channel.target));
      hash.add(std::uint64_t{channel.joint});
      hash.add(static_cast<std::uint64_t>(channel.interpolation));
      hash.add(std::span<const double>(channel.times_s));
      hash.add(std::span<const double>(channel.values));
    }
  }
}

}  // namespace penpose::document
