#pragma once

#include <cstdint>
#include <vector>

#include "core/document/document.h"
#include "core/intent/problem.h"
#include "core/posing/problem.h"

// The problems that the drawn curves of a document pose for the solvers.

namespace penpose::document {

/// The most references, the latest ones, that are brought to their targets at a time. After more, the artist has long
/// moved on to another expression; without a bound, every stroke of a long session would cost more than the one before.
inline constexpr std::size_t k_most_pairs = 48;
/// The most drawn targets that core/intent reads at a time, where each curve is matched again.
inline constexpr std::size_t k_most_meant = 16;

/// The error of a hand, as a share of the size of the drawing (2.1 of 700 px).
inline constexpr double k_hand_share = 3.0e-3;
/// The error of a known target, which is only rounded by files, as the same share.
inline constexpr double k_known_share = 5e-4;

/// Converts points on the document's mesh to points of the solver.
[[nodiscard]] std::vector<posing::CurvePoint> curve_points(const Document& document,
                                                           const std::vector<mesh::MeshPoint>& points);

/// For the lowest sum of distances: the latest references with a target, every constraint, and all parameters that are
/// not locked, starting from the pose as it is.
[[nodiscard]] posing::PoseProblem pose_problem(const Document& document);

/// The width of doubt of the artist's hand in a view, px.
[[nodiscard]] double hand_px(const Document& document, geometry::Viewport viewport);

/// For core/intent: targets as lines in the pictures in which they were drawn, each with the hand's doubt there.
/// Constraints have the same doubt as drawn lines, in model units. Targets with an invalid view are left out.
[[nodiscard]] intent::IntentProblem intent_problem(const Document& document);

/// The same for the lines of a moment, from the pose before them; the last one is new. Redrawn lines are left out.
[[nodiscard]] intent::IntentProblem moment_problem(const Document& document, const Moment& moment);

}  // namespace penpose::document
