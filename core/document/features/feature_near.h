#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/features/feature_curves.h"

namespace penpose::document {

/// Where the points of a feature are at a pose.
[[nodiscard]] std::vector<geometry::ModelPoint> positions_of(const Model& model, const rig::Pose& pose,
                                                             const portrait::FeatureCurve& curve);

/// The feature along which a line on the posed surface runs, sure or not: near it for the length of both, and about in
/// its direction. Nothing: none does, or another one about as well, such as lips that touch.
[[nodiscard]] std::optional<std::string> feature_near(const Model& model, const rig::Pose& pose,
                                                      const FeatureCurves& features,
                                                      const std::vector<geometry::ModelPoint>& line);

/// The features that a line may mean, by the same measure, the nearest first. Empty: it is near none.
[[nodiscard]] std::vector<std::string> features_near(const Model& model, const rig::Pose& pose,
                                                     std::span<const portrait::FeatureCurve> features,
                                                     const std::vector<geometry::ModelPoint>& line);

/// Whether a line runs the other way than the feature of that name; than features do, to the face's own left or up,
/// where it has none.
[[nodiscard]] bool runs_backwards(const Model& model, const rig::Pose& pose, const FeatureCurves& features,
                                  const std::string& name, const std::vector<geometry::ModelPoint>& line);

/// Names that a line of the face may be given: those of its features, sure or not, those that were said to be missing,
/// and those that are looked for in every face.
[[nodiscard]] std::vector<std::string> nameable_features(const Model& model, const FeatureCurves& features);

}  // namespace penpose::document
