#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/animation/track.h"
#include "core/base/result.h"

namespace penpose::animation {

/// The placement of a head in a picture, relative to the neutral frame: point X of the neutral frame (relative to
/// `pivot`; x right, y down, z away from the camera, px) appears at scale * (rotation * X).xy + pivot + shift.
struct HeadTurn {
  double scale = 1;
  glm::dmat3 rotation{1};
  PxPoint shift;
  double residual_px = 0;  ///< root mean square distance left at the stable points
};

/// A track without the motion of the head.
struct StillTrack {
  std::size_t neutral = 0;         ///< the frame that all others are relative to
  PxPoint pivot;                   ///< of the head turns: the middle of the stable points in the neutral frame
  std::vector<HeadTurn> turns;     ///< one a frame; frames without a face repeat the one before
  std::vector<double> doubt;       ///< one a frame, 0..1: the doubt about the fit of the head
  std::vector<double> confidence;  ///< one a frame; 0: nothing was seen
  /// How far each point moved from its place in the neutral frame, px of the neutral frame; empty without a face.
  std::vector<std::vector<PxPoint>> offsets;
};

/// Points of a track from which the head's placement is found.
struct StablePoints {
  std::vector<std::size_t>
      stable;  ///< points that no expression moves: the bridge of the nose, the corners of the eyes
  /// Points that expressions move a little or trackers slide along the face, but that are far in front or behind: they
  /// help to find the head's turn.
  std::vector<std::size_t> turning;
  /// Points of the lids: their offsets are measured on a head that is turned half as far. A nod and closing lids look
  /// alike, and the fit confuses them; half the turn gives the least error either way.
  std::vector<std::size_t> openings = {};
};

/// Removes the head's motion from a track: in each frame, the similarity that best maps the stable points of the
/// neutral frame to their positions (least squares). If the track has depths, the turn out of the picture's plane is
/// found first, by Gauss-Newton from the stable points, and the strength of the perspective from the whole clip. A
/// point's offset is what is left, turned back into the neutral frame. The head's turn is reported separately: from the
/// tracker's own turn if it agrees with the points, otherwise from the stable and the turning points. Without stable
/// points the head counts as still. Frames of less than `least_confidence` count as not seen, and so do those in which
/// the stable points are too far from where any turn would put them to be a face.
///
/// Errors: no frame with a face, a point that does not exist, stable points at one place, a neutral frame that does not
/// exist or shows no face.
///
/// Doubt grows with the turn out of the picture's plane (one half at 11 degrees) and with the distance left at the
/// stable points (one half at 3 % of their extent): a face differs from the average, and a larger turn shows more of
/// that.
[[nodiscard]] base::Result<StillTrack> take_head_motion_out(const PointTrack& track, const StablePoints& points,
                                                            std::optional<std::size_t> neutral,
                                                            double least_confidence);

}  // namespace penpose::animation
