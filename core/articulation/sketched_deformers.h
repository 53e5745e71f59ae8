#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/deformer.h"
#include "core/articulation/region/canvas.h"
#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/rig/displacement_layer.h"

namespace penpose::articulation {

/// Any number of sketched deformers. Their displacements, each computed from the mesh at rest, are added in order.
/// Immutable: editing gives another set, which shares unchanged deformers.
class SketchedDeformers final : public rig::DisplacementLayer {
 public:
  using Shared = std::shared_ptr<const SketchedDeformers>;

  /// Errors (place "N/name"): two deformers of one name.
  static base::Result<Shared> make(std::vector<std::shared_ptr<const Deformer>> deformers);
  /// Builds all. Errors: those of build_deformer with the number of the sketch in front ("3/target").
  static base::Result<Shared> build(std::span<const Sketch> sketches, const Canvas& canvas,
                                    std::size_t points = k_curve_points);

  [[nodiscard]] std::span<const std::shared_ptr<const Deformer>> deformers() const { return deformers_; }
  [[nodiscard]] std::vector<Sketch> sketches() const;
  [[nodiscard]] std::size_t size() const { return deformers_.size(); }

  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return parameters_; }
  void add(std::span<const double> values, std::span<ModelVector> displacements) const override;
  [[nodiscard]] std::unique_ptr<rig::BoundLayer> bind(std::span<const std::uint32_t> vertices) const override;

 private:
  std::vector<std::shared_ptr<const Deformer>> deformers_;
  std::vector<rig::Parameter> parameters_;
};

/// Adds the sketch of every deformer, in order.
void add_to_hash(base::StateHash& hash, const SketchedDeformers& deformers);

}  // namespace penpose::articulation
