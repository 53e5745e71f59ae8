#pragma once

#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/write/dense_keys.h"
#include "core/io/gltf/write/glb_targets.h"
#include "core/io/gltf/write/one_way_targets.h"

namespace penpose::io {

/// Stands for a morph target that the writer does not know: its weight is 0.
inline constexpr std::size_t k_no_target = static_cast<std::size_t>(-1);

/// The morph targets of a file and their weights, in its pose and over time. A target whose weight leaves 0..1 is
/// helped by others that go on from there (one_way_targets.h). The model and the targets outlive it.
class GlbWeights {
 public:
  /// `posed`: one a target of morphs, whether its weight in the pose is written; empty: all are.
  GlbWeights(const document::Model& model, const GlbTargets& morphs, std::vector<bool> posed = {})
      : model_(model), morphs_(morphs), written_(std::move(posed)) {
    find_keys();
    find_one_way_targets();
  }

  /// A channel of weights and its keys in the file.
  struct KeysOf {
    const document::Channel* channel;
    DenseKeys keys;
  };

  /// The model's targets, and behind them those that help.
  [[nodiscard]] const std::vector<const rig::BlendShape*>& targets() const { return targets_; }
  [[nodiscard]] std::vector<OneWayName> one_way_names() const;
  [[nodiscard]] bool is_weight_channel(const document::Channel& channel) const;
  [[nodiscard]] static bool is_cubic(const document::Channel& channel, const DenseKeys& keys);
  /// The keys of a channel of weights.
  [[nodiscard]] const DenseKeys& keys_of(const document::Channel& channel) const;
  /// The weight of a target in the model's pose.
  [[nodiscard]] double posed(std::size_t target) const { return weight_of(target, pose_weights_); }
  /// Rows of weights of all targets, or of those and their tangents, as a sampler of some of the targets has them.
  [[nodiscard]] std::vector<float> values_of(const std::vector<std::vector<double>>& rows, bool cubic,
                                             std::span<const std::size_t> shapes) const;

 private:
  void find_keys();
  void find_one_way_targets();
  [[nodiscard]] double weight_of(std::size_t target, const std::vector<double>& weights) const;
  [[nodiscard]] double tangent_of(std::size_t target, const std::vector<double>& tangents,
                                  const std::vector<double>& weights) const;

  const document::Model& model_;
  const GlbTargets& morphs_;
  std::vector<bool> written_;
  std::vector<KeysOf> keys_;
  std::vector<double> pose_weights_;   ///< of the targets of morphs_
  std::vector<OneWayTarget> one_way_;  ///< behind those
  std::vector<bool> helped_;           ///< one a target of morphs_: some of one_way_ are for it
  std::vector<const rig::BlendShape*> targets_;
};

}  // namespace penpose::io
