#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/posing/problem.h"

namespace penpose::intent {

using geometry::ModelPoint;
using geometry::ModelVector;
using geometry::PxPoint;

/// Strokes shorter than this are dots, px.
inline constexpr double k_shortest_px = 0.5;

/// How far a practised hand strays from the intended line, px of a view 1000 px high. It scales with the height, so
/// that a dense screen behaves like any other.
inline constexpr double k_doubt_px = 2.2;
[[nodiscard]] double doubt_px(geometry::Viewport viewport);

/// The width of doubt of one stroke: the hand's, but at most a fiftieth of the stroke's length (and at least three
/// tenths of the hand's), plus the stroke's own roughness (its root mean square
/// distance from the line smoothed over a tenth of its length) beyond half of that. px. Precondition: hand_px > 0.
[[nodiscard]] double stroke_doubt_px(std::span<const PxPoint> line, double hand_px);

/// A reference curve and the line drawn for it. The line gives no depth, and does not say where along it a point of the
/// reference goes.
struct DrawnCurve {
  std::vector<posing::CurvePoint> reference;  ///< at least two, in order along the curve
  geometry::Camera camera;
  std::vector<PxPoint> target;  ///< at least two, not all at one place
  double doubt_px = k_doubt_px;
  std::vector<double> weights;  ///< one a reference point, mean 1 (posing::pressure_weights); empty: all 1
  /// From each reference point to where the pen drew it, model units: a line that snapped to a rim next to it is
  /// meant to move as far as it was drawn. Empty: no offset.
  std::vector<ModelVector> aside = {};
  /// Of a line that corrects a part of what was drawn before it: the points that it does not touch, one a reference
  /// point; empty: it touches all. Those stay in the picture where they are at the start.
  std::vector<bool> stays = {};
  /// Drawn and solved before the others: unless everything is read again, it stays as that solve left it.
  bool before = false;
};

/// A curve with a known target for each point.
struct KnownCurve {
  std::vector<posing::CurvePoint> reference;
  std::vector<ModelPoint> target;  ///< one a reference point
  double doubt = 0;                ///< model units, > 0
};

/// The question: which pose did these strokes mean, starting from this pose?
struct IntentProblem {
  std::vector<DrawnCurve> drawn;
  std::vector<KnownCurve> known;
  std::vector<KnownCurve> kept;   ///< constraints: curves that stay where they were when they were set
  std::vector<std::size_t> free;  ///< parameters that may move, ascending
  /// Parameters that the strokes might mean but the artist locked, ascending. Where a locked one was meant, the
  /// solution moves no more controls than it would with that one free.
  std::vector<std::size_t> locked;
  rig::Pose start;  ///< one value a parameter
  /// The result of an earlier solve from the same start, one value a parameter; empty: none. A reading that continues
  /// it is kept unless another one is clearly better.
  rig::Pose posed = {};
  /// For each parameter, what the artist's choices on this rig add to the cost of moving it; negative if the artist
  /// means it more often than others. Empty: no choices.
  std::vector<double> taught = {};
};

/// Where the reference of a drawn curve is at a pose.
[[nodiscard]] std::vector<ModelPoint> reference_at(const rig::Rig& rig, const rig::Pose& pose, const DrawnCurve& curve);

/// Errors: nothing to match, lines of fewer than two points or of no length, other numbers of targets than of points,
/// numbers that are not finite, vertices or parameters out of range, a start outside its ranges, a reference behind its
/// camera or without length in its view.
[[nodiscard]] base::Status check_problem(const rig::Rig& rig, const IntentProblem& problem);

}  // namespace penpose::intent
