#include "core/document/model.h"

#include <algorithm>
#include <optional>

namespace penpose::document {

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

base::Result<Model> with_controls(Model model, std::shared_ptr<const rig::BlendShapes> shapes,
                                  std::shared_ptr<const articulation::SketchedDeformers> deformers) {
  auto made = make_model(model.mesh, std::move(shapes), model.skeleton, std::move(deformers));
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

base::Result<Model> with_deformers(Model model, std::shared_ptr<const articulation::SketchedDeformers> deformers) {
  auto shapes = model.shapes;
  return with_controls(std::move(model), std::move(shapes), std::move(deformers));
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

}  // namespace penpose::document
