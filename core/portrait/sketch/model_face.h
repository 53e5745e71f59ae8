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
  /// Returns nothing if the curves name no eyes or no mouth. `curves` must outlive the result.
  static std::optional<ModelFace> see(const rig::Rig& rig, std::span<const FeatureCurve> curves, const rig::Pose& start,
                                      const geometry::Camera& camera);

  /// Returns the measures of the model's features at rest.
  [[nodiscard]] const FaceMeasures& measures() const { return measures_; }
  [[nodiscard]] const FaceLayout& layout() const { return layout_; }

  /// Returns the lines that an artist would draw over the model for an expression, one a feature that it has a value
  /// for.
  [[nodiscard]] std::vector<intent::DrawnCurve> lines_of(const Expression& expression) const;

  /// Returns the model's curve for a part of a drawing, if it has one. `lower` chooses the lower lid or lip.
  [[nodiscard]] std::optional<std::size_t> curve_of(FacePart part, bool right, bool lower) const;
  /// Returns whether a curve is of the lips.
  [[nodiscard]] bool is_lip(std::size_t curve) const {
    return seen_[curve].feature == Feature::upper_lip || seen_[curve].feature == Feature::lower_lip;
  }
  /// Returns the other border of the same lip, if the curve is a lip with two borders.
  [[nodiscard]] std::optional<std::size_t> other_border(std::size_t curve) const;
  /// Returns whether a place of the frame is below the line between the lips.
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
