#pragma once

#include <cstdint>
#include <vector>

#include "core/document/document.h"
#include "core/intent/problem.h"
#include "core/posing/problem.h"

// What the drawn curves of a document ask of a solver.

namespace penpose::document {

/// The most references that are brought to their targets at a time, the latest ones. Who draws more has long gone on to
/// another expression; without a bound every stroke of a long session would cost more than the one before.
inline constexpr std::size_t k_most_pairs = 48;
/// The most drawn targets that are read at a time for what was meant, where each curve is matched anew.
inline constexpr std::size_t k_most_meant = 16;

/// How far a hand strays, as a share of the size of what it draws (2.1 of 700 px).
inline constexpr double k_hand_share = 3.0e-3;
/// Where a target that is known goes is exact but for what files round; the same share.
inline constexpr double k_known_share = 5e-4;

/// Points of the solver for points on the document's mesh.
[[nodiscard]] std::vector<posing::CurvePoint> curve_points(const Document& document,
                                                           const std::vector<mesh::MeshPoint>& points);

/// For the lowest sum of distances: the latest references that have a target, every constraint, all parameters free
/// that are not locked, starting from the pose as it is.
[[nodiscard]] posing::PoseProblem pose_problem(const Document& document);

/// The width of doubt of the artist's hand in a view, px.
[[nodiscard]] double hand_px(const Document& document, geometry::Viewport viewport);

/// For what was meant: targets as lines in the pictures in which they were drawn, each with the hand's doubt there.
/// Constraints are doubted like what is drawn, in model units. Targets whose view cannot be are left out.
[[nodiscard]] intent::IntentProblem intent_problem(const Document& document);

/// The same for the lines of a moment, from the pose before them; the last one is new. Lines that were drawn anew are
/// left out.
[[nodiscard]] intent::IntentProblem moment_problem(const Document& document, const Moment& moment);

}  // namespace penpose::document
