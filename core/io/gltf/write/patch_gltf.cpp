#include "core/io/gltf/write/patch_gltf.h"

#include <algorithm>

#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/vrm/vrm_extension.h"
#include "core/io/gltf/write/patch/patch_animations.h"
#include "core/io/gltf/write/patch/patch_columns.h"
#include "core/io/gltf/write/patch/patch_container.h"
#include "core/io/gltf/write/patch/patch_joints.h"
#include "core/io/gltf/write/patch/patch_state.h"
#include "core/io/gltf/write/patch/patch_vrm.h"
#include "core/io/gltf/write/patch/patch_weights.h"

namespace penpose::io {
namespace {

using document::SourceFile;

/// Whether the controls have the names and ranges that they were read with.
bool same_parameters(const document::Model& model) {
  const auto& was_read = model.source->shapes;
  if (static_cast<bool>(model.shapes) != static_cast<bool>(was_read)) return false;
  if (!model.shapes) return true;
  const auto now = model.shapes->parameters();
  const auto was = was_read->parameters();
  return std::equal(now.begin(), now.end(), was.begin(), was.end(), [](const auto& a, const auto& b) {
    return a.name == b.name && a.rest == b.rest && a.minimum == b.minimum && a.maximum == b.maximum;
  });
}

/// Root extras are changed where something needs them. `order`: of animations, empty where it is that of the file.
void write_root(PatchState& state, const json::Json& project, const std::vector<std::size_t>& order) {
  const document::Model& model = state.model;
  json::Json made = write_root_extras(model, state.morphs.baked_names(), state.targets.one_way_names(*state.weights),
                                      project)[k_extras_key];
  // The avatar says it itself.
  if (is_vrm_avatar(state.document.json)) made.erase("humanoid");
  if (!order.empty()) made["animation_order"] = json::Json(order);
  const json::Json* extras = json::find(state.builder.root, "extras");
  const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
  const bool needed = state.changed || !project.is_null() || model.deformers || model.corrections ||
                      !model.curves.empty() || !model.features.empty() || !same_parameters(model);
  if (own != nullptr ? *own == made : !needed) return;
  state.changed = true;
  own_extras_of(state.builder.root) = std::move(made);
}

}  // namespace

base::Result<PatchedGltf> patch_gltf(const document::Model& model, const WriteOptions& options,
                                     const json::Json& project, GltfContainer container) {
  const SourceFile& source = *model.source;
  const auto cannot = [](std::string why) {
    PatchedGltf none;
    none.cannot = std::move(why);
    return none;
  };
  if (model.mesh != source.mesh) return cannot("its surface is another one");
  if (model.skeleton != source.skeleton &&
      !(model.skeleton && carries_the_rest(*model.skeleton, source.skeleton.get())))
    return cannot("its joints are others");
  auto opened = open_gltf(*source.bytes, resolver_of(source));
  if (!opened) return opened.error();
  const auto root = read_root_extras(opened->json);
  if (!root) return root.error();

  const GlbTargets morphs(model, options.bake_tolerance);
  PatchTargets targets(model, morphs, *opened, *root);
  PatchContainer layout(source, *opened, container, options.stem);
  GltfBuilder builder(layout.document(), layout.buffer(), layout.start());
  builder.reuse(layout.known());
  PatchState state{model, source, *opened, morphs, targets, builder};
  PatchAnimations animations(state);
  PatchJoints joints(state);
  animations.compare();
  animations.find_weights();
  if (model.skeleton != source.skeleton) joints.write_carrier();
  PatchColumns(state).write();
  patch_vrm(state);
  PatchWeights(state).write();
  joints.write_pose();
  write_root(state, project, animations.write(joints));

  PatchedGltf patched;
  const double size = morphs.size();
  patched.report.targets = state.weights->targets().size();
  patched.report.baked = morphs.all().size() - morphs.own_count();
  patched.report.bake_error = morphs.bake_error() + (size > 0 ? animations.between_error() / size : 0.0);
  if (joints.pose_is_apart()) {
    patched.report.notes.emplace_back(
        "the joints of a VRM avatar stay in T-pose in the file; penpose shows the pose again, and for other programs "
        "it "
        "can be written as .vrma");
  }
  auto bytes = layout.finish(builder, state.changed, patched.report.files);
  if (!bytes) return bytes.error();
  patched.bytes = std::move(bytes).value();
  return patched;
}

}  // namespace penpose::io
