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

/// The frame chosen as the rest pose, and how near to rest it is.
struct RestChoice {
  std::size_t frame = 0;
  std::vector<std::size_t> like_it;  ///< frames almost as near to rest, ascending, including the frame itself
  double lips_apart = 0;             ///< in it, as a share of the mouth's width
  double lips_together = 0;          ///< gap between the points of touching lips in this clip, px of the frame
  double eyes_open = 1;              ///< in it, as a multiple of the clip's usual opening
  bool near_rest = true;             ///< false: the lips touch in no frame of the clip
};

/// Curves that touch at rest, such as the lips: indices into the list of curves.
[[nodiscard]] std::optional<EyeCurves> lips_of(std::span<const TrackedCurve> curves);

/// Searches the whole clip for a face at rest: among the frames with the lips together, the one in which the eyes are
/// nearest to their usual opening, all other curves nearest to their median (in units of their usual deviation), and
/// the head turned least from its usual direction. Nothing where the curves have no lips, or where fewer than ten
/// frames show a face. `still` is seen from any frame. `tremor_px`: differences below it say nothing.
[[nodiscard]] std::optional<RestChoice> choose_rest(const PointTrack& track, const StillTrack& still,
                                                    std::span<const TrackedCurve> curves, double tremor_px);

/// The choice in words, for the user.
[[nodiscard]] std::string explain(const RestChoice& choice);

}  // namespace penpose::animation
