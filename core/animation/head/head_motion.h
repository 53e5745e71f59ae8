#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/animation/track.h"
#include "core/base/result.h"

namespace penpose::animation {

/// How a head stands in a picture, compared with the neutral frame: point X of the neutral frame (relative to `pivot`;
/// x right, y down, z away from the camera, px) appears at scale * (rotation * X).xy + pivot + shift.
struct HeadTurn {
  double scale = 1;
  glm::dmat3 rotation{1};
  PxPoint shift;
  double residual_px = 0;  ///< root mean square distance left at the stable points
};

/// A track without the motion of the head.
struct StillTrack {
  std::size_t neutral = 0;         ///< the frame that all others are compared with
  PxPoint pivot;                   ///< of the head turns: the middle of the stable points in the neutral frame
  std::vector<HeadTurn> turns;     ///< how the head stands, one a frame; frames without a face repeat the one before
  std::vector<double> doubt;       ///< one a frame, 0..1: how little the fit of the head is to be trusted
  std::vector<double> confidence;  ///< one a frame; 0: nothing was seen
  /// How far each point moved from its place in the neutral frame, px of the neutral frame; empty without a face.
  std::vector<std::vector<PxPoint>> offsets;
};

/// Points of a track that tell how the head stands.
struct StablePoints {
  std::vector<std::size_t> stable;  ///< that no expression moves: the bridge of the nose, the corners of the eyes
  /// That expressions move a little or trackers slide along the face, but that lie far in front or behind: they help to
  /// tell how the head stands.
  std::vector<std::size_t> turning;
  /// Of the lids: their offsets are measured on a head that is turned half as far as it stands. Lids that a nod shows
  /// narrower and lids that close look alike, and the fit takes one for the other; half errs least either way.
  std::vector<std::size_t> openings = {};
};

/// Takes the head's motion out of a track: in each frame the similarity that best carries the stable points of the
/// neutral frame to where they are now (least squares). Where the track knows depths, the turn out of the picture's
/// plane is found before it, by Gauss-Newton from the stable points, and how strong the perspective is from the whole
/// clip. A point's offset is what is left, turned back into the neutral frame. How the head stands is told apart from
/// that: by the tracker's own account of it where there is one that agrees with the points, otherwise by the stable and
/// the turning points. Without stable points the head counts as still. Frames of less than `least_confidence` count as
/// not seen, and so do those in which the stable points are so far from where any turn would bring them that they can
/// be no face.
///
/// Errors: no frame with a face, a point that does not exist, stable points at one place, a neutral frame that does not
/// exist or shows no face.
///
/// Doubt grows with the turn out of the picture's plane (one half at 11 degrees) and with what is left at the stable
/// points (one half at 3 % of their extent): a face is not the common face, and the farther it turns the more that
/// shows.
[[nodiscard]] base::Result<StillTrack> take_head_motion_out(const PointTrack& track, const StablePoints& points,
                                                            std::optional<std::size_t> neutral,
                                                            double least_confidence);

}  // namespace penpose::animation
