#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/write/baked_deformer.h"

namespace penpose::io {

/// The morph targets that a file needs to show a model: its blend shapes, a sample of each deformer at amount 1, and
/// what baking adds to the samples (baked_deformer.h) and the corrections, whose weights follow from those of others,
/// in this order. Neither copied nor moved: `all` points into it.
class GlbTargets {
 public:
  /// `tolerance`: of baking, share of the model's size. A quarter of it is left to keys (dense_keys.h). The model must
  /// outlive it.
  GlbTargets(const document::Model& model, double tolerance);
  GlbTargets(const GlbTargets&) = delete;
  GlbTargets& operator=(const GlbTargets&) = delete;

  [[nodiscard]] std::span<const rig::BlendShape* const> all() const { return targets_; }
  /// Blend shapes and samples: the targets whose weights are the model's own parameters.
  [[nodiscard]] std::size_t own_count() const { return targets_.size() - made_count(); }
  /// Names of the targets that baking made, one list a deformer.
  [[nodiscard]] const std::vector<std::vector<std::string>>& baked_names() const { return names_; }
  /// The diagonal of the model at rest.
  [[nodiscard]] double size() const { return size_; }
  /// What is left of the tolerance to weights between keys, model units.
  [[nodiscard]] double between_tolerance() const { return between_tolerance_; }
  /// Farthest that baking moves a vertex, share of the model's size.
  [[nodiscard]] double bake_error() const { return bake_error_; }

  /// The weights of all targets where the model's weights have these values (more values may follow).
  [[nodiscard]] std::vector<double> weights(std::span<const double> values) const;
  /// The same for tangents: slopes of the weights at the values, times the parameters' own tangents.
  [[nodiscard]] std::vector<double> tangents(std::span<const double> tangents, std::span<const double> values) const;

 private:
  [[nodiscard]] std::size_t made_count() const { return places_.size() + corrections_.size(); }
  void add_corrections(const document::Model& model);

  /// Where a target that baking made comes from.
  struct Place {
    std::size_t parameter;
    std::size_t deformer;
    std::size_t target;
  };
  void bake(const document::Model& model, double tolerance);

  std::vector<rig::BlendShape> samples_;
  std::vector<rig::BlendShape> corrections_;
  std::shared_ptr<const articulation::Corrections> amounts_;  ///< of those
  std::vector<BakedDeformer> baked_;                          ///< one a deformer
  std::vector<Place> places_;
  std::vector<std::vector<std::string>> names_;
  std::vector<const rig::BlendShape*> targets_;
  double size_ = 0;
  double between_tolerance_ = 0;
  double bake_error_ = 0;
};

}  // namespace penpose::io
