#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/animation/head/head_motion.h"
#include "core/animation/points/curve_transfer.h"
#include "core/animation/signal/blinks.h"
#include "core/animation/track.h"

namespace penpose::animation {

/// The two lids of one eye: places in the list of tracked curves, each of which meets the other.
struct EyeCurves {
  std::size_t one = 0;
  std::size_t other = 0;
};
[[nodiscard]] std::vector<EyeCurves> eyes_of(std::span<const TrackedCurve> curves);

/// Inner points of a curve, each with the one across from it on another curve: as far along, whichever way that runs.
[[nodiscard]] std::vector<std::array<std::size_t, 2>> points_across(const TrackedCurve& one, const TrackedCurve& other,
                                                                    const TrackFrame& neutral);

/// How wide an eye stands open in every frame: the mean distance between its lids, but for the corners, across the line
/// between the corners, as a multiple of that line's own length, times its length in the neutral frame, px. Frames
/// without a face repeat the one before.
[[nodiscard]] std::vector<double> openings(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                                           const TrackedCurve& other);

/// Where the points of both lids but for the corners are across the eye, px of the neutral frame.
[[nodiscard]] LidPoints points_of_lids(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                                       const TrackedCurve& other);

/// What the eyes do, told in what the model's lids should do.
struct EyeMotion {
  /// One list an eye, one value a frame: 0 where the eye is as open as usual, 1 where it is closed, below 0 where it is
  /// so many times its usual opening wider.
  std::vector<std::vector<double>> closed;
  std::vector<double> usual_px;     ///< the usual opening of each eye
  double full_dip = 0;              ///< by how much of the usual opening the points close in a blink; 0: none seen
  std::vector<std::size_t> blinks;  ///< frames in which blinks of both eyes or of one are deepest, ascending
};

/// Finds what the eyes do. `seen`: the openings of each eye; `points`: of each eye, or none.
///
/// Blinks are events: dips of the opening that are over within half a second and stand out of the clip's own tremor, or
/// less deep ones at which the tracker's own column of closing (`column`, one value a frame, or none) rises too
/// (find_blinks). Trackers close lids by a part of what people do; so a blink is as deep as the points of that clip
/// usually go in a blink, that is closed. An eye that dips by far less than the other does not take part: a wink. What
/// is left of the openings without blinks is steadied and lasts: it keeps its own share, by the same measure as long as
/// that stays within the range. `doubt`: of the head, one a frame (StillTrack); eyes are not widened where it is in
/// doubt. `tremor_px`: the standard deviation of the opening's tremor, as far as it is known beforehand.
[[nodiscard]] EyeMotion find_eye_motion(std::span<const std::vector<double>> seen, std::span<const LidPoints> points,
                                        std::span<const double> confidence, double frames_per_s,
                                        std::span<const double> column, double tremor_px,
                                        std::span<const double> doubt);

}  // namespace penpose::animation
