#pragma once

#include <span>

#include "core/base/hidden.h"
#include "core/base/result.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/document/drawing/pose_problem.h"
#include "core/document/features/feature_curves.h"
#include "core/portrait/feature_curve.h"

namespace penpose::document {

/// What is worth keeping between commands: the search tree over the surface, scratch memory of the solver. Never
/// changes a result.
class ApplyWorkspace {
 public:
  ApplyWorkspace();
  [[nodiscard]] ApplyParts& parts() { return *parts_; }

 private:
  base::Hidden<ApplyParts> parts_;
};

/// The document after a command. The same document and command give the same bits on any machine (method, section 5).
/// Errors say what is wrong with the command; the place is a member of it or empty.
[[nodiscard]] base::Result<Document> apply(const Document& document, const Command& command, ApplyWorkspace& work);

/// The features of the document's face; empty: none are found. Valid until the next call.
[[nodiscard]] std::span<const portrait::FeatureCurve> features_of(const Document& document, ApplyWorkspace& work);

/// The same with those that are not sure; none: nothing of a face is found.
[[nodiscard]] const FeatureCurves& all_features_of(const Document& document, ApplyWorkspace& work);

/// A line as it would have been drawn through the same camera on a picture of another size: both show the same height
/// of the scene, so that the same rays go through it.
[[nodiscard]] std::vector<PxPoint> rescaled(const std::vector<PxPoint>& line, geometry::Viewport from,
                                            geometry::Viewport to);

/// Where points of the surface are at the document's pose.
[[nodiscard]] std::vector<geometry::ModelPoint> positions_of(const Document& document,
                                                             const std::vector<mesh::MeshPoint>& points);

}  // namespace penpose::document
