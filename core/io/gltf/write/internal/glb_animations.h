#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/write/internal/glb_weights.h"
#include "core/io/gltf/write/internal/gltf_builder.h"

namespace penpose::io {

/// A node whose mesh has morph targets: which of GlbWeights::targets they are, in the order of the mesh; k_no_target:
/// one whose weight is 0.
struct WeightNode {
  std::size_t node = 0;
  std::vector<std::size_t> targets;
};

/// Writes animations as lists of channels and samplers. All outlive it.
class GlbAnimations {
 public:
  /// `node_of_joint`: none where no node stands for the joint.
  GlbAnimations(const GlbWeights& weights, std::span<const WeightNode> weight_nodes,
                std::function<std::optional<std::size_t>(std::size_t joint)> node_of_joint, GltfBuilder& builder)
      : weights_(weights), weight_nodes_(weight_nodes), node_of_joint_(std::move(node_of_joint)), builder_(builder) {}

  /// Appends the channels of an animation; both lists may have entries already.
  void write(const document::Animation& animation, json::Json& channels, json::Json& samplers);
  /// Farthest that a vertex is off between keys, model units.
  [[nodiscard]] double between_error() const { return between_error_; }

  /// The rate of which all keys are whole frames, or 0. glTF itself knows seconds alone.
  [[nodiscard]] static double rate_of(const document::Animation& animation);

 private:
  /// Samplers of one channel share its times.
  struct Times {
    std::size_t input = 0;
    document::Interpolation interpolation = document::Interpolation::linear;
    std::vector<std::size_t> added;  ///< keys that are there for other programs alone
    json::Json spline;               ///< what the keys are straight lines of, or null
  };
  Times write_times(std::vector<float> times_s, const document::Channel& channel);
  void write_sampler(const Times& times, std::size_t node, const char* path, std::span<const float> values,
                     const char* type, json::Json& channels, json::Json& samplers);
  void write_channel(const document::Channel& channel, json::Json& channels, json::Json& samplers);
  void write_weight_keys(const document::Channel& channel, json::Json& channels, json::Json& samplers);

  const GlbWeights& weights_;
  std::span<const WeightNode> weight_nodes_;
  std::function<std::optional<std::size_t>(std::size_t)> node_of_joint_;
  GltfBuilder& builder_;
  double between_error_ = 0;
};

}  // namespace penpose::io
