#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/head/head_motion.h"
#include "core/animation/points/curve_transfer.h"
#include "core/animation/track.h"

namespace penpose::animation {

/// The frame that is taken for a face at rest, and how near to rest it is.
struct RestChoice {
  std::size_t frame = 0;
  std::vector<std::size_t> like_it;  ///< frames that are all but as near to rest, ascending, the frame among them
  double lips_apart = 0;             ///< in it, as a share of the mouth's width
  double lips_together = 0;  ///< what the points of lips that touch leave between them in this clip, px of the frame
  double eyes_open = 1;      ///< in it, as a multiple of the clip's usual opening
  bool near_rest = true;     ///< false: in no frame of the clip do the lips touch
};

/// Curves that touch at rest, as the lips do: places in the list of curves.
[[nodiscard]] std::optional<EyeCurves> lips_of(std::span<const TrackedCurve> curves);

/// Looks for rest in the whole clip: the lips together, and of the frames in which they are, the one in which the eyes
/// are most nearly as open as usual, all other curves most nearly where they mostly are (the median, each measured by
/// how far it usually is from there), and the head turned least from how it is usually held. Nothing where the curves
/// have no lips, or where fewer than ten frames show a face. `still` is seen from any frame. `tremor_px`: differences
/// below it say nothing.
[[nodiscard]] std::optional<RestChoice> choose_rest(const PointTrack& track, const StillTrack& still,
                                                    std::span<const TrackedCurve> curves, double tremor_px);

/// The choice in words, for the user.
[[nodiscard]] std::string explain(const RestChoice& choice);

}  // namespace penpose::animation
