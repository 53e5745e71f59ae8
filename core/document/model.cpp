#include "core/document/model.h"

#include <algorithm>
#include <optional>

namespace penpose::document {
namespace {

void add_vector(base::StateHash& hash, const geometry::ModelVector& v) {
  hash.add(v.x);
  hash.add(v.y);
  hash.add(v.z);
}

void add_mesh(base::StateHash& hash, const mesh::TriangleMesh& mesh) {
  hash.add("mesh");
  hash.add(std::uint64_t{mesh.vertex_count()});
  for (const auto& p : mesh.positions()) add_vector(hash, p);
  hash.add(std::uint64_t{mesh.triangle_count()});
  for (const auto& triangle : mesh.triangles()) {
    for (const std::uint32_t v : triangle) hash.add(std::uint64_t{v});
  }
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
    add_vector(hash, joint.translation);
    const glm::dquat& q = joint.rest_rotation;
    add_vector(hash, {q.x, q.y, q.z});
    hash.add(q.w);
    add_vector(hash, joint.scale);
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

}  // namespace

base::Result<Model> make_model(std::shared_ptr<const mesh::TriangleMesh> mesh,
                               std::shared_ptr<const rig::BlendShapes> shapes,
                               std::shared_ptr<const rig::Skeleton> skeleton,
                               std::shared_ptr<const articulation::SketchedDeformers> deformers) {
  if (shapes && shapes->vertex_count() != mesh->vertex_count()) {
    return base::Error{"the blend shapes are for another number of vertices", "", "make them for this mesh"};
  }
  if (deformers && deformers->size() == 0) deformers.reset();
  std::vector<std::shared_ptr<const rig::DisplacementLayer>> layers;
  if (shapes) layers.push_back(shapes);
  if (deformers) layers.push_back(deformers);
  auto rig = rig::CharacterRig::make(mesh, std::move(layers), skeleton);
  if (!rig) return rig.error();
  Model model;
  model.materials.resize(mesh->parts().size());
  model.mesh = std::move(mesh);
  model.shapes = std::move(shapes);
  model.deformers = std::move(deformers);
  model.skeleton = std::move(skeleton);
  model.rig = std::move(rig).value();
  model.pose = rig::rest_pose(*model.rig);
  return model;
}

base::Result<Model> with_deformers(Model model, std::shared_ptr<const articulation::SketchedDeformers> deformers) {
  auto made = make_model(model.mesh, model.shapes, model.skeleton, std::move(deformers));
  if (!made) return made;
  const auto parameters = made->rig->parameters();
  // Where each parameter's value was before.
  std::vector<std::optional<std::size_t>> before;
  for (const rig::Parameter& parameter : parameters) {
    before.push_back(rig::find_parameter(model.rig->parameters(), parameter.name));
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (before[i]) made->pose[i] = std::clamp(model.pose[*before[i]], parameters[i].minimum, parameters[i].maximum);
  }
  const std::size_t old_count = weight_count(model);
  const std::size_t new_count = weight_count(*made);
  for (Animation& animation : model.animations) {
    for (Channel& channel : animation.channels) {
      if (channel.target != ChannelTarget::weights || old_count == 0) continue;
      std::vector<double> values;
      for (std::size_t row = 0; row < channel.values.size() / old_count; ++row) {
        // The tangents of what is new are flat.
        const bool tangent = channel.interpolation == Interpolation::cubic_spline && row % 3 != 1;
        for (std::size_t i = 0; i < new_count; ++i) {
          values.push_back(before[i] && *before[i] < old_count ? channel.values[row * old_count + *before[i]]
                           : tangent                           ? 0.0
                                                               : parameters[i].rest);
        }
      }
      channel.values = std::move(values);
    }
  }
  made->materials = std::move(model.materials);
  made->curves = std::move(model.curves);
  made->animations = std::move(model.animations);
  made->notes = std::move(model.notes);
  return made;
}

base::Result<std::shared_ptr<const articulation::Canvas>> make_canvas(const Model& model) {
  return articulation::Canvas::make(model.mesh, model.skeleton.get());
}

std::size_t weight_count(const Model& model) {
  return (model.shapes ? model.shapes->parameters().size() : 0) + (model.deformers ? model.deformers->size() : 0);
}

std::vector<geometry::ModelPoint> posed_positions(const Model& model) {
  std::vector<geometry::ModelPoint> positions(model.mesh->vertex_count());
  model.rig->evaluate(model.pose, positions);
  return positions;
}

geometry::Box rest_world_box(const Model& model) {
  std::vector<geometry::ModelPoint> positions(model.mesh->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), positions);
  geometry::Box box;
  for (const auto& p : positions) box.add(p);
  return box;
}

base::Hash128 state_hash(const Model& model) {
  base::StateHash hash;
  hash.add("penpose model 1");
  add_mesh(hash, *model.mesh);
  if (model.shapes) {
    for (const rig::BlendShape& shape : model.shapes->shapes()) {
      hash.add(shape.parameter.name);
      hash.add(std::uint64_t{shape.vertices.size()});
      for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        hash.add(std::uint64_t{shape.vertices[i]});
        add_vector(hash, shape.deltas[i]);
      }
    }
  }
  if (model.deformers) articulation::add_to_hash(hash, *model.deformers);
  if (model.skeleton) add_skeleton(hash, *model.skeleton);
  for (const rig::Parameter& parameter : model.rig->parameters()) {
    hash.add(parameter.name);
    hash.add(parameter.rest);
    hash.add(parameter.minimum);
    hash.add(parameter.maximum);
  }
  hash.add(std::span<const double>(model.pose));
  for (const NamedCurve& curve : model.curves) {
    hash.add(curve.name);
    hash.add(std::uint64_t{curve.points.size()});
    for (const mesh::MeshPoint& point : curve.points) {
      hash.add(std::uint64_t{point.triangle});
      hash.add(std::span<const double>(point.barycentric));
    }
  }
  for (const Animation& animation : model.animations) {
    hash.add(animation.name);
    for (const Channel& channel : animation.channels) {
      hash.add(static_cast<std::uint64_t>(channel.target));
      hash.add(std::uint64_t{channel.joint});
      hash.add(static_cast<std::uint64_t>(channel.interpolation));
      hash.add(std::span<const double>(channel.times_s));
      hash.add(std::span<const double>(channel.values));
    }
  }
  return hash.digest();
}

}  // namespace penpose::document
