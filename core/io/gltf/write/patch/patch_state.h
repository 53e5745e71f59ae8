#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/document/source_file.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/glb_targets.h"
#include "core/io/gltf/write/internal/glb_weights.h"
#include "core/io/gltf/write/internal/gltf_builder.h"
#include "core/io/gltf/write/patch/patch_targets.h"

namespace penpose::io {

/// What the steps that change a file share. All that is referred to outlives it.
struct PatchState {
  const document::Model& model;
  const document::SourceFile& source;
  GltfDocument& document;
  const GlbTargets& morphs;
  PatchTargets& targets;
  GltfBuilder& builder;
  std::optional<GlbWeights> weights{};  ///< there after PatchAnimations::compare
  std::vector<bool> posed{};            ///< one a target of morphs: its weight is another than in the file
  bool changed = false;                 ///< the file is no longer the one that was read

  /// How many weights the model has.
  [[nodiscard]] std::size_t width() const { return document::weight_count(model); }
  /// The number of a target of morphs; k_no_target: there is none of that name.
  [[nodiscard]] std::size_t target_named(const std::string& name) const;
  /// How many nodes of the written file show a mesh, in any scene.
  [[nodiscard]] std::size_t users_of(std::size_t mesh) const;
};

/// The member "penpose" of an object's extras, made where it is not there. Extras that are no object give way to it.
[[nodiscard]] json::Json& own_extras_of(json::Json& object);
/// Whether a channel of an animation moves the weights of a node.
[[nodiscard]] bool moves_weights_of(const json::Json& channel, std::size_t node);

}  // namespace penpose::io
