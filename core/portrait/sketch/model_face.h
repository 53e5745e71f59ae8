#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/intent/problem.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/sketch/expression.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// The features of a model as one camera sees them at rest, in the frame of FaceLayout.
class ModelFace {
 public:
  /// None: nothing of the curves says where eyes and mouth are. `curves` must outlive it.
  static std::optional<ModelFace> see(const rig::Rig& rig, std::span<const FeatureCurve> curves, const rig::Pose& start,
                                      const geometry::Camera& camera);

  /// What lines drawn along the model's features at rest would show.
  [[nodiscard]] const FaceMeasures& measures() const { return measures_; }
  [[nodiscard]] const FaceLayout& layout() const { return layout_; }

  /// The lines that an artist would draw for an expression: each feature that was drawn, where the expression has it.
  [[nodiscard]] std::vector<intent::DrawnCurve> lines_of(const Expression& expression) const;

  /// The curve that a part of a drawing stands for; none: the model has no such curve. `lower`: of lids and lips.
  [[nodiscard]] std::optional<std::size_t> curve_of(FacePart part, bool right, bool lower) const;
  /// The other border of the same lip; none: the model has one alone, or the curve is no lip.
  [[nodiscard]] std::optional<std::size_t> other_border(std::size_t curve) const;
  /// Whether a place of the frame is below the line between the lips.
  [[nodiscard]] bool below_mouth(const PxPoint& p) const;

 private:
  enum class Feature : unsigned char { brow, upper_lid, lower_lid, upper_lip, lower_lip, nose, other };
  struct Seen {
    Feature feature = Feature::other;
    bool right = false;           ///< of the picture
    std::vector<PxPoint> points;  ///< in the frame, one a point of the curve
    std::vector<PxPoint> px;
  };
  ModelFace(std::span<const FeatureCurve> curves, const geometry::Camera& camera) : curves_(curves), camera_(camera) {}
  void measure_features();
  [[nodiscard]] const Seen* seen(Feature feature, bool right) const;

  std::span<const FeatureCurve> curves_;
  geometry::Camera camera_;
  FaceLayout layout_;
  std::vector<Seen> seen_;
  FaceMeasures measures_;
};

}  // namespace penpose::portrait
