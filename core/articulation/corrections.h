#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/articulation/deformer.h"
#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/rig/displacement_layer.h"

namespace penpose::articulation {

/// A control that brings in a correction, and its value in the corrected pose; never its value at rest.
struct Driver {
  std::string control;
  double value = 1;
  friend bool operator==(const Driver&, const Driver&) = default;
};

/// Fewer controls are no combination (use another target of the one), more are a pose rather than a combination.
inline constexpr std::size_t k_fewest_drivers = 2, k_most_drivers = 8;

/// The strokes that correct a pose of several controls: a sketch on the model in that pose.
struct CorrectionSketch {
  Sketch sketch;
  std::vector<Driver> drivers;
  friend bool operator==(const CorrectionSketch&, const CorrectionSketch&) = default;
};

/// A built correction: displacements of rest vertices for the pose in which its drivers have their values.
struct Correction {
  CorrectionSketch drawn;
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::vector<ModelVector> moves;
  std::shared_ptr<const Canvas> canvas;      ///< the canvas it was drawn on
  std::shared_ptr<const Deformer> deformer;  ///< the deformer built there
};

/// Errors: those of build_deformer, and a correction with other targets.
[[nodiscard]] base::Result<std::shared_ptr<const Correction>> build_correction(CorrectionSketch drawn,
                                                                               std::shared_ptr<const Canvas> canvas);

/// Corrections of a rig. They have no parameters of their own: the amount of each follows from the rig's weights. It is
/// the product over its drivers of how far each is from rest to its value, clamped to 0..1. So it is 1 in the pose
/// where it was drawn and beyond, and 0 where any driver is at rest.
class Corrections final : public rig::DisplacementLayer {
 public:
  using Shared = std::shared_ptr<const Corrections>;

  /// `parameters` of the whole rig. Errors (place "N/drivers/K"): a driver that is no parameter; two corrections of one
  /// name.
  static base::Result<Shared> make(std::vector<std::shared_ptr<const Correction>> corrections,
                                   std::span<const rig::Parameter> parameters);

  [[nodiscard]] std::span<const std::shared_ptr<const Correction>> all() const { return corrections_; }
  [[nodiscard]] std::size_t size() const { return corrections_.size(); }
  /// The amount of a correction, 0..1. Precondition: `pose` has at least all weights of the rig.
  [[nodiscard]] double amount(std::size_t correction, std::span<const double> pose) const;

  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return {}; }
  [[nodiscard]] bool driven() const override { return true; }
  void add(std::span<const double> pose, std::span<ModelVector> displacements) const override;
  [[nodiscard]] std::unique_ptr<rig::BoundLayer> bind(std::span<const std::uint32_t> vertices) const override;

  /// The number of a driver's parameter, and its values at rest and where it was drawn.
  struct Lever {
    std::size_t parameter = 0;
    double rest = 0;
    double value = 1;
  };
  [[nodiscard]] std::span<const Lever> levers(std::size_t correction) const { return levers_[correction]; }

 private:
  std::vector<std::shared_ptr<const Correction>> corrections_;
  std::vector<std::vector<Lever>> levers_;
};

/// Adds the sketch of every correction, in order.
void add_to_hash(base::StateHash& hash, const CorrectionSketch& correction);

}  // namespace penpose::articulation
