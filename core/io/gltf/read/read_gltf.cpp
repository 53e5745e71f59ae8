#include "core/io/gltf/read/read_gltf.h"

#include <algorithm>
#include <cmath>

#include "core/base/text/letters.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/internal/gltf_source.h"
#include "core/io/gltf/read/internal/gltf_animations.h"
#include "core/io/gltf/read/internal/gltf_deformers.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_expressions.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_nodes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"
#include "core/io/gltf/read/internal/gltf_skins.h"
#include "core/io/gltf/read/internal/gltf_weight_ranges.h"
#include "core/io/gltf/read/internal/look/gltf_look.h"
#include "core/io/gltf/vrm/vrm_extension.h"
#include "core/io/model/model_formats.h"
#include "core/io/project/internal/older_project.h"
#include "core/io/project/internal/project_json.h"
#include "core/io/project/write_document.h"
#include "core/mesh/topology.h"
#include "core/rig/mirrored_triangles.h"

namespace penpose::io {
namespace {

/// The first vertex that is moved farther than can be shown. Moderate transforms one below the other may still multiply
/// to such a way.
std::optional<std::size_t> too_far(const document::Model& model) {
  const auto positions = document::posed_positions(model);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!(std::abs(positions[v].x) < 1e30 && std::abs(positions[v].y) < 1e30 && std::abs(positions[v].z) < 1e30))
      return v;
  }
  return std::nullopt;
}

/// A pose that cannot be shown is left out: the model is shown at rest.
base::Status check_positions(document::Model& model) {
  if (!model.skeleton) return base::Done{};
  const auto posed = too_far(model);
  if (!posed) return base::Done{};
  model.pose = rig::rest_pose(*model.rig);
  if (const auto vertex = too_far(model)) {
    return base::Error{"the transforms of the nodes move vertex " + std::to_string(*vertex) + " too far away", "/nodes",
                       "export the file again with valid transforms"};
  }
  model.notes.push_back("the pose of the file moves vertex " + std::to_string(*posed) +
                        " too far away and was left out");
  return base::Done{};
}

/// Keeps the first `kept` of `all` weights of each key.
void drop_weights(document::Animation& animation, std::size_t all, std::size_t kept) {
  for (document::Channel& channel : animation.channels) {
    if (channel.target != document::ChannelTarget::weights || all == kept) continue;
    std::vector<double> values;
    for (std::size_t row = 0; row * all < channel.values.size(); ++row) {
      const auto begin = channel.values.begin() + static_cast<std::ptrdiff_t>(row * all);
      values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(kept));
    }
    channel.values = std::move(values);
  }
}

std::optional<std::size_t> shape_named(const GltfShapes& shapes, const std::string& name) {
  for (std::size_t i = 0; i < shapes.shapes.size(); ++i) {
    if (shapes.shapes[i].parameter.name == name) return i;
  }
  return std::nullopt;
}

/// Gives a target's weight back to the one of which it is a part.
void put_together(const OneWayName& one, GltfShapes& shapes, std::vector<document::Animation>& animations) {
  const std::size_t to = *shape_named(shapes, one.name);
  const std::size_t from = *shape_named(shapes, one.target);
  shapes.values[to] += one.factor * shapes.values[from];
  rig::Parameter& range = shapes.shapes[to].parameter;
  range.minimum = std::min(range.minimum, shapes.values[to]);
  range.maximum = std::max(range.maximum, shapes.values[to]);
  const std::size_t width = shapes.shapes.size();
  for (document::Animation& animation : animations) {
    for (document::Channel& channel : animation.channels) {
      if (channel.target != document::ChannelTarget::weights) continue;
      for (std::size_t row = 0; row + width <= channel.values.size(); row += width) {
        channel.values[row + to] += one.factor * channel.values[row + from];
      }
    }
  }
}

/// Builds the corrections of a file again. One that does not fit any more, or whose controls are gone, is left out with
/// a note.
void add_corrections(const RootExtras& root, document::Model& model) {
  std::vector<articulation::CorrectionSketch> kept;
  for (const articulation::CorrectionSketch& one : root.corrections) {
    kept.push_back(one);
    auto made = document::with_corrections(model, kept);
    if (made) {
      model = std::move(made).value();
      continue;
    }
    kept.pop_back();
    model.notes.push_back("correction " + one.sketch.name +
                          " cannot be built again from its strokes and was left out: " + made.error().what);
  }
}

struct OpenedModel {
  document::Model model;
  GltfOrigins origins;
  bool of_another_edition = false;
  std::vector<std::string> parameters_of_file;  ///< in its order; empty: they are the model's
};

/// Controls that stay blend shapes keep their ranges.
void keep_ranges(const RootExtras& root, const std::vector<std::string>& deformers, GltfShapes& shapes) {
  for (const articulation::Sketch& sketch : root.deformers) {
    if (std::find(deformers.begin(), deformers.end(), sketch.name) != deformers.end()) continue;
    if (const auto shape = shape_named(shapes, sketch.name)) {
      shapes.shapes[*shape].parameter.minimum = sketch.minimum;
      shapes.shapes[*shape].parameter.maximum = sketch.maximum;
    }
  }
}

/// The names of the parameters as poses of the file have them: those of shapes, of all controls, and of joints.
std::vector<std::string> parameters_of(const RootExtras& root, const document::Model& model) {
  std::vector<std::string> names;
  for (const rig::Parameter& shape : root.shapes) names.push_back(shape.name);
  for (const articulation::Sketch& sketch : root.deformers) names.push_back(sketch.name);
  const auto all = model.rig->parameters();
  const std::size_t shapes = model.shapes ? model.shapes->parameters().size() : 0;
  const std::size_t deformers = model.deformers ? model.deformers->size() : 0;
  for (std::size_t p = shapes + deformers; p < all.size(); ++p) names.push_back(all[p].name);
  return names;
}

/// What became of the controls of a project of an older edition.
std::string older_note(const RootExtras& root, std::size_t rebuilt) {
  std::string note = "the project was drawn in edition " + std::to_string(root.older_edition);
  if (root.deformers.empty()) return note;
  return note + ": " + std::to_string(rebuilt) + " of its " + std::to_string(root.deformers.size()) +
         " controls can be drawn on, as they were";
}

base::Result<OpenedModel> read_opened(GltfDocument& document, const FileResolver& resolve) {
  if (is_vrm_animation(document.json)) {
    return base::Error{"it is a VRM animation and holds no model", "",
                       "give it as a track: animate MODEL --track FILE"};
  }
  const auto root = read_root_extras(document.json);
  if (!root) return root.error();
  const auto node_extras = read_node_extras(document.json, *root);
  if (!node_extras) return node_extras.error();
  NodeTree tree = make_node_tree(document);
  for (std::int32_t& parent : tree.parent) {
    if (parent >= 0 && (*node_extras)[static_cast<std::size_t>(parent)].group) parent = -1;
  }
  auto meshes = read_meshes(document, tree);
  if (!meshes) return meshes.error();
  auto look = read_look(document, *meshes, resolve);
  auto shapes = read_shapes(document, *meshes, *root);
  if (!shapes) return shapes.error();
  GltfOrigins origins = origins_of(*meshes, *shapes);
  auto joints = read_skeleton(document, tree, *meshes, *node_extras);
  if (!joints) return joints.error();
  const std::size_t vertices = meshes->source.positions.size();
  std::shared_ptr<const rig::Skeleton> skeleton;
  if (!joints->joints.empty()) {
    auto made = rig::Skeleton::make(std::move(joints->joints), std::move(joints->first_influence),
                                    std::move(joints->influences));
    if (!made) return made.error();
    skeleton = std::move(made).value();
    rig::turn_mirrored(*skeleton, meshes->source.triangles);
  }
  auto mesh = mesh::TriangleMesh::build(std::move(meshes->source));
  if (!mesh) return mesh.error();
  meshes->source.parts.assign((*mesh)->parts().begin(), (*mesh)->parts().end());
  if (const auto status = check_curves(*root, (*mesh)->triangle_count()); !status) return status.error();
  if (root->of_another_edition) {
    document.notes.push_back(
        "the project was drawn under another edition of penpose, which this one does not know: its controls are the "
        "blend shapes that they were baked to, and can no longer be drawn again");
  }
  const auto deformers = read_deformers(*mesh, skeleton.get(), *root, *shapes, document.notes);
  std::vector<std::string> deformer_names;
  for (std::size_t i = 0; deformers && i < deformers->size(); ++i) {
    deformer_names.push_back(deformers->parameters()[i].name);
  }
  if (root->older_edition > 0) document.notes.push_back(older_note(*root, deformer_names.size()));
  keep_ranges(*root, deformer_names, *shapes);
  // What only shows the deformers to other programs comes last and is dropped.
  std::vector<std::string> not_shapes = deformer_names;
  for (std::size_t i = 0; i < root->deformers.size(); ++i) {
    if (std::find(deformer_names.begin(), deformer_names.end(), root->deformers[i].name) == deformer_names.end())
      continue;
    for (const std::string& name : root->baked[i]) {
      const bool there = std::any_of(shapes->shapes.begin(), shapes->shapes.end(),
                                     [&](const rig::BlendShape& shape) { return shape.parameter.name == name; });
      if (there && std::find(not_shapes.begin(), not_shapes.end(), name) == not_shapes.end())
        not_shapes.push_back(name);
    }
  }
  for (const articulation::CorrectionSketch& one : root->corrections) {
    const bool free = shape_named(*shapes, one.sketch.name) &&
                      std::find(not_shapes.begin(), not_shapes.end(), one.sketch.name) == not_shapes.end();
    if (free) not_shapes.push_back(one.sketch.name);
  }
  std::vector<OneWayName> one_way;
  for (const OneWayName& one : root->one_way) {
    const bool there = shape_named(*shapes, one.target) && shape_named(*shapes, one.name);
    if (!there || std::find(not_shapes.begin(), not_shapes.end(), one.target) != not_shapes.end()) continue;
    not_shapes.push_back(one.target);
    one_way.push_back(one);
  }
  const std::size_t shape_count = order_shapes(*shapes, *root, not_shapes);
  const std::size_t weights = shape_count + deformer_names.size();
  std::vector<document::Expression> expressions = read_expressions(document, *meshes, *shapes, shape_count);
  auto animations = read_animations(document, *meshes, *shapes, joints->joint_of_node, origins.animations);
  put_in_order(*root, animations, origins.animations);
  for (const OneWayName& one : one_way) put_together(one, *shapes, animations);
  widen_ranges(animations, *root, *shapes);
  for (document::Animation& animation : animations) drop_weights(animation, shapes->shapes.size(), weights);
  shapes->values.resize(weights);
  shapes->shapes.resize(shape_count);  // deformers say themselves what their samples say
  for (std::size_t i = 0; i < deformer_names.size(); ++i) {
    const rig::Parameter& range = deformers->parameters()[i];
    double& value = shapes->values[shape_count + i];
    value = std::clamp(value, range.minimum, range.maximum);
  }
  std::shared_ptr<const rig::BlendShapes> blend_shapes;
  if (!shapes->shapes.empty()) {
    auto made = rig::BlendShapes::make(std::move(shapes->shapes), vertices);
    if (!made) return made.error();
    blend_shapes = std::move(made).value();
  }
  auto model = document::make_model(*mesh, std::move(blend_shapes), std::move(skeleton), deformers);
  if (!model) return model.error();
  model->materials = std::move(meshes->materials);
  model->look = fitting_look(std::move(look), **mesh, document.notes);
  model->pose = std::move(shapes->values);
  model->pose.insert(model->pose.end(), joints->values.begin(), joints->values.end());
  model->curves = root->curves;
  model->features = root->features;
  model->expressions = std::move(expressions);
  model->front_yaw_degrees = vrm_front_yaw_degrees(document.json);
  model->animations = std::move(animations);
  model->notes = std::move(document.notes);
  add_corrections(*root, *model);
  if ((*mesh)->dropped_triangles() > 0) {
    model->notes.push_back(std::to_string((*mesh)->dropped_triangles()) + " triangles without area were left out");
  }
  if (auto note = mesh::note_of_extra_triangles(**mesh); !note.empty()) model->notes.push_back(std::move(note));
  if (const auto status = check_positions(*model); !status) return status.error();
  model->humanoid = vrm_humanoid(document.json, joints->joint_of_node);
  origins.joint_of_node = std::move(joints->joint_of_node);
  const bool all_built = deformer_names.size() == root->deformers.size();
  auto parameters = all_built ? std::vector<std::string>() : parameters_of(*root, *model);
  return OpenedModel{std::move(model).value(), std::move(origins), root->of_another_edition, std::move(parameters)};
}

}  // namespace

base::Result<document::Model> read_gltf(base::Bytes bytes, const FileResolver& resolve) {
  ReadBeside beside(resolve);
  auto opened = open_kept_gltf(bytes, beside.resolver());
  if (!opened) return opened.error();
  auto read = read_opened(*opened, resolve);
  if (!read) return read.error();
  read->model.source = keep_source(beside, *opened, std::move(read->origins), read->model);
  return std::move(read->model);
}

base::Result<document::Document> read_gltf_document(base::Bytes bytes, const FileResolver& resolve) {
  ReadBeside beside(resolve);
  auto opened = open_kept_gltf(bytes, beside.resolver());
  if (!opened) return opened.error();
  auto read_model = read_opened(*opened, resolve);
  if (!read_model) return read_model.error();
  document::Model& model = read_model->model;
  model.source = keep_source(beside, *opened, std::move(read_model->origins), model);
  const json::Json* extras = json::find(opened->json, "extras");
  const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
  const json::Json* project = own == nullptr ? nullptr : json::find(*own, "project");
  if (project == nullptr || read_model->of_another_edition) return document::make_document(std::move(model));
  const json::Json today = todays_project(*project, read_model->parameters_of_file, model.rig->parameters());
  auto read = read_project(today, json::child(json::child("/extras", k_extras_key), "project"), std::move(model));
  if (!read) return read;
  // Clips that were made here stand in the project exactly, and for other programs as the first animations, unless they
  // move nothing that animations know.
  document::Model rest = *read->model;
  for (const std::string& name : document::made_animations(*read)) {
    if (!rest.animations.empty() && rest.animations.front().name == name)
      rest.animations.erase(rest.animations.begin());
  }
  for (const auto& clip : read->clips) {
    if (clip->animation && *clip->animation >= rest.animations.size())
      return base::Error{"the clip \"" + clip->name + "\" has no animation", "", "save the project again"};
  }
  if (rest.animations.size() != read->model->animations.size())
    read->model = std::make_shared<const document::Model>(std::move(rest));
  return read;
}

ModelFormat glb_format() {
  return {.name = "glTF (.glb)",
          .extension = ".glb",
          .looks_like = [](base::Bytes bytes) { return base::as_text(bytes).starts_with("glTF"); },
          .read = read_gltf,
          .read_project = read_gltf_document,
          .write = [](const document::Model& model, const WriteOptions& options,
                      WriteReport& report) { return write_glb(model, options, &report); },
          .write_project = [](const document::Document& document, const WriteOptions& options,
                              WriteReport& report) { return write_project(document, options, &report); },
          .holds = "The face that moves",
          .detail = "With its controls and keys"};
}

ModelFormat gltf_format() {
  return {.name = "glTF (.gltf)",
          .extension = ".gltf",
          .looks_like =
              [](base::Bytes bytes) {
                const std::string_view text = base::without_mark(base::as_text(bytes));
                const std::size_t first = text.find_first_not_of(" \t\r\n");
                return first != std::string_view::npos && text[first] == '{';
              },
          .read = read_gltf,
          .read_project = read_gltf_document,
          .write = [](const document::Model& model, const WriteOptions& options,
                      WriteReport& report) { return write_gltf(model, options, &report); },
          .write_project = [](const document::Document& document, const WriteOptions& options,
                              WriteReport& report) { return write_gltf_project(document, options, &report); },
          .holds = "The face that moves, its files beside it",
          .detail = "With its controls and keys"};
}

}  // namespace penpose::io
