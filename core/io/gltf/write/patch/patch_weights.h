#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/io/gltf/write/internal/glb_animations.h"
#include "core/io/gltf/write/patch/patch_state.h"

namespace penpose::io {

/// Gives the nodes of a file the weights of the pose. Those that were not posed stay what they are.
class PatchWeights {
 public:
  explicit PatchWeights(PatchState& state) : state_(state) {}

  void write();
  /// The nodes whose weights animations move.
  [[nodiscard]] std::vector<WeightNode> nodes() const;

 private:
  [[nodiscard]] std::optional<double> weight_to_write(const TargetColumn& column) const;
  [[nodiscard]] double posed_weight(std::size_t target) const;
  [[nodiscard]] std::string base_of(const std::string& helper) const;
  void set_weight(const MeshTargets& mesh, std::size_t column, double weight);

  PatchState& state_;
};

}  // namespace penpose::io
