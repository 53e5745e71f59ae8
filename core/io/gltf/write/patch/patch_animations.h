#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "core/io/gltf/write/patch/patch_joints.h"
#include "core/io/gltf/write/patch/patch_state.h"
#include "core/io/gltf/write/patch/patch_weights.h"

namespace penpose::io {

/// Keeps the animations of a file that are as they were, writes those that are not, and takes out those that the model
/// no longer has.
class PatchAnimations {
 public:
  explicit PatchAnimations(PatchState& state) : state_(state) {}

  /// Finds which animations are as they were.
  void compare();
  /// Finds the weights of the pose and of the animations that are written, and what targets these need. After compare.
  void find_weights();
  /// The numbers of the file's animations in the order of the model; empty: that is their own order. After
  /// find_weights.
  std::vector<std::size_t> write(const PatchJoints& joints);
  /// Farthest that a vertex is off between keys, model units.
  [[nodiscard]] double between_error() const { return between_error_; }

 private:
  /// What becomes of an animation of the model.
  struct Fate {
    std::optional<std::size_t> from;  ///< of SourceFile::animations
    bool kept = false;                ///< its keys stay as they are in the file
  };
  [[nodiscard]] bool moves_any(const document::Animation& animation, const std::vector<bool>& columns) const;
  void keep_channels(const json::Json& object, const std::vector<WeightNode>& nodes, json::Json& channels,
                     json::Json& samplers) const;
  void remove_animations(std::vector<std::size_t>& order);

  PatchState& state_;
  document::Model rewritten_;  ///< with the animations that are written again alone
  std::vector<Fate> fates_;    ///< one an animation of the model
  std::set<std::size_t> removed_;
  double between_error_ = 0;
};

}  // namespace penpose::io
