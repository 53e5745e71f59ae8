#include "core/document/model.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/document/expressions.h"
#include "core/rig/character_rig.h"

namespace penpose::document {
namespace {

using articulation::CorrectionSketch;

/// Those that are there already are not built again where what they were drawn on is the same, to the bit.
base::Result<Model> with_corrections(Model model, std::span<const CorrectionSketch> corrections,
                                     const articulation::Corrections* known) {
  std::vector<std::shared_ptr<const articulation::Correction>> built;
  const auto in_place = [](std::size_t i, base::Error error) {
    error.place = std::to_string(i) + (error.place.empty() ? "" : "/" + error.place);
    return error;
  };
  for (std::size_t i = 0; i < corrections.size(); ++i) {
    const CorrectionSketch& drawn = corrections[i];
    if (rig::find_parameter(model.rig->parameters(), drawn.sketch.name)) {
      return base::Error{"a control has the name \"" + drawn.sketch.name + "\" already", std::to_string(i) + "/name",
                         "give the correction another name"};
    }
    auto canvas = make_posed_canvas(model, drawn.drivers);
    if (!canvas) return in_place(i, canvas.error());
    std::shared_ptr<const articulation::Correction> same;
    for (std::size_t k = 0; known != nullptr && k < known->size(); ++k) {
      const articulation::Correction& one = *known->all()[k];
      const auto was = one.canvas->positions();
      const auto is = (*canvas)->positions();
      if (one.drawn == drawn && std::equal(was.begin(), was.end(), is.begin(), is.end())) same = known->all()[k];
    }
    if (!same) {
      auto made = articulation::build_correction(drawn, *canvas);
      if (!made) return in_place(i, made.error());
      same = std::move(*made);
    }
    built.push_back(std::move(same));
    auto layer = articulation::Corrections::make(built, model.rig->parameters());
    if (!layer) return layer.error();
    auto made = make_model(model.mesh, model.shapes, model.skeleton, model.deformers, *layer);
    if (!made) return made;
    model.corrections = made->corrections;
    model.rig = made->rig;
  }
  return model;
}

}  // namespace

base::Result<Model> make_model(std::shared_ptr<const mesh::TriangleMesh> mesh,
                               std::shared_ptr<const rig::BlendShapes> shapes,
                               std::shared_ptr<const rig::Skeleton> skeleton,
                               std::shared_ptr<const articulation::SketchedDeformers> deformers,
                               std::shared_ptr<const articulation::Corrections> corrections) {
  if (shapes && shapes->vertex_count() != mesh->vertex_count()) {
    return base::Error{"the blend shapes are for another number of vertices", "", "make them for this mesh"};
  }
  if (deformers && deformers->size() == 0) deformers.reset();
  std::vector<std::shared_ptr<const rig::DisplacementLayer>> layers;
  if (shapes) layers.push_back(shapes);
  if (deformers) layers.push_back(deformers);
  if (corrections && corrections->size() == 0) corrections.reset();
  if (corrections) layers.push_back(corrections);
  auto rig = rig::CharacterRig::make(mesh, std::move(layers), skeleton);
  if (!rig) return rig.error();
  Model model;
  model.materials.resize(mesh->parts().size());
  model.mesh = std::move(mesh);
  model.shapes = std::move(shapes);
  model.deformers = std::move(deformers);
  model.corrections = std::move(corrections);
  model.skeleton = std::move(skeleton);
  model.rig = std::move(rig).value();
  model.pose = rig::rest_pose(*model.rig);
  return model;
}

void move_rest(Model& from, Model& to) {
  to.materials = std::move(from.materials);
  to.curves = std::move(from.curves);
  to.features = std::move(from.features);
  to.animations = std::move(from.animations);
  to.humanoid = from.humanoid;
  to.front_yaw_degrees = from.front_yaw_degrees;
  to.look = std::move(from.look);
  to.notes = std::move(from.notes);
  to.source = std::move(from.source);
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
  move_rest(model, *made);
  made->expressions = expressions_for(std::move(model.expressions), model.rig->parameters(), parameters);
  if (!model.corrections) return made;
  std::vector<CorrectionSketch> kept = correction_sketches(model);
  std::erase_if(kept, [&](const CorrectionSketch& one) {
    return std::any_of(one.drivers.begin(), one.drivers.end(), [&](const articulation::Driver& driver) {
      return !rig::find_parameter(parameters, driver.control);
    });
  });
  auto corrected = with_corrections(std::move(made).value(), kept, model.corrections.get());
  if (corrected) return corrected;
  base::Error error = corrected.error();
  std::size_t number = 0;
  for (std::size_t i = 0; i < error.place.size() && error.place[i] >= '0' && error.place[i] <= '9'; ++i) {
    number = 10 * number + static_cast<std::size_t>(error.place[i] - '0');
  }
  const std::string name = number < kept.size() ? kept[number].sketch.name : kept.front().sketch.name;
  return base::Error{"the correction \"" + name + "\" does not fit any more: " + error.what, "",
                     "delete the correction first"};
}

base::Result<Model> with_corrections(Model model, std::span<const CorrectionSketch> corrections) {
  auto bare = make_model(model.mesh, model.shapes, model.skeleton, model.deformers);
  if (!bare) return bare;
  const auto known = std::exchange(model.corrections, nullptr);
  model.rig = bare->rig;
  return with_corrections(std::move(model), corrections, known.get());
}

std::vector<CorrectionSketch> correction_sketches(const Model& model) {
  std::vector<CorrectionSketch> sketches;
  if (!model.corrections) return sketches;
  for (const auto& one : model.corrections->all()) sketches.push_back(one->drawn);
  return sketches;
}

base::Result<std::shared_ptr<const articulation::Canvas>> make_posed_canvas(
    const Model& model, std::span<const articulation::Driver> drivers) {
  rig::Pose pose = rig::rest_pose(*model.rig);
  const std::size_t weights = weight_count(model);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    const auto parameter = rig::find_parameter(model.rig->parameters(), drivers[i].control);
    const std::string place = "drivers/" + std::to_string(i);
    if (!parameter) {
      return base::Error{"there is no control \"" + drivers[i].control + "\"", place, "look at the names in the model"};
    }
    if (*parameter >= weights) {
      return base::Error{"\"" + drivers[i].control + "\" turns a joint, which brings in no correction", place,
                         "put joints at rest and correct what shapes and sketched controls do"};
    }
    pose[*parameter] = drivers[i].value;
  }
  std::vector<geometry::ModelVector> moves(model.mesh->vertex_count(), geometry::ModelVector{0});
  const std::span<const double> values(pose);
  const std::size_t shapes = model.shapes ? model.shapes->parameters().size() : 0;
  if (model.shapes) model.shapes->add(values.first(shapes), moves);
  if (model.deformers) model.deformers->add(values.subspan(shapes, model.deformers->size()), moves);
  if (model.corrections) model.corrections->add(values, moves);
  return articulation::Canvas::make_posed(model.mesh, model.skeleton.get(), moves);
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

geometry::Box rest_box_of_shapes(const Model& model) {
  rig::Pose pose = rig::rest_pose(*model.rig);
  std::vector<geometry::ModelPoint> rest(model.mesh->vertex_count());
  model.rig->evaluate(pose, rest);
  const auto* character = dynamic_cast<const rig::CharacterRig*>(model.rig.get());
  const std::size_t shapes =
      character != nullptr ? character->first_parameter(character->layers().size()) : pose.size();
  for (std::size_t p = 0; p < shapes; ++p) pose[p] = model.rig->parameters()[p].maximum;
  std::vector<geometry::ModelPoint> moved(rest.size());
  model.rig->evaluate(pose, moved);
  geometry::Box box;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (rest[v] != moved[v]) box.add(rest[v]);
  }
  return box.empty() ? rest_world_box(model) : box;
}

}  // namespace penpose::document
