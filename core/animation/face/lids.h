#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"
#include "core/animation/points/curve_transfer.h"
#include "core/animation/signal/blinks.h"
#include "core/animation/track.h"

namespace penpose::animation {

/// The two lids of one eye: indices into the list of tracked curves, which meet each other.
struct EyeCurves {
  std::size_t one = 0;
  std::size_t other = 0;
};
[[nodiscard]] std::vector<EyeCurves> eyes_of(std::span<const TrackedCurve> curves);

/// Inner points of a curve, each with its opposite on another curve: equally far along, in whichever direction that
/// runs.
[[nodiscard]] std::vector<std::array<std::size_t, 2>> points_across(const TrackedCurve& one, const TrackedCurve& other,
                                                                    const TrackFrame& neutral);

/// The opening of an eye in every frame, px: the mean distance between its lids (without the corners) across the line
/// between the corners, divided by that line's length and multiplied by its length in the neutral frame. Frames without
/// a face repeat the one before.
[[nodiscard]] std::vector<double> openings(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                                           const TrackedCurve& other);

/// Positions of the points of both lids (without the corners) across the eye, px of the neutral frame.
[[nodiscard]] LidPoints points_of_lids(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                                       const TrackedCurve& other);

/// The motion of the eyes, as the motion that the model's lids should make.
struct EyeMotion {
  /// One list an eye, one value a frame: 0 where the eye is open as usual, 1 where it is closed, below 0 where it is
  /// wider, as a multiple of the usual opening.
  std::vector<std::vector<double>> closed;
  std::vector<double> usual_px;     ///< the usual opening of each eye
  double full_dip = 0;              ///< share of the usual opening that the points close in a blink; 0: no blink
  std::vector<std::size_t> blinks;  ///< frames in which blinks (of one eye or both) are deepest, ascending
};

/// Finds the motion of the eyes. `seen`: the openings of each eye; `points`: of each eye, or none.
///
/// Blinks are events: dips of the opening that are over within half a second and exceed the clip's own tremor, or less
/// deep ones at which the tracker's own closing (`column`, one value a frame, or none) also rises (find_blinks).
/// Trackers close lids less than people do, so a dip as deep as the points of that clip usually go in a blink counts as
/// closed. An eye that dips far less than the other does not take part: a wink. The openings without blinks are
/// denoised and keep their share, scaled by the same measure as long as that stays within the range. `doubt`: of the
/// head, one a frame (StillTrack); eyes are not widened where the head is in doubt. `tremor_px`: the standard deviation
/// of the opening's tremor, as far as it is known beforehand.
[[nodiscard]] EyeMotion find_eye_motion(std::span<const std::vector<double>> seen, std::span<const LidPoints> points,
                                        std::span<const double> confidence, double frames_per_s,
                                        std::span<const double> column, double tremor_px,
                                        std::span<const double> doubt);

}  // namespace penpose::animation
