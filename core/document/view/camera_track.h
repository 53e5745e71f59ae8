#pragma once

#include <optional>
#include <vector>

#include "core/document/drawing/pose_curve.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// A view at one moment, as large a part of the window as no panel covers.
struct CameraKey {
  double time_s = 0;
  View view;
  KeyKind kind = KeyKind::smooth;  ///< smooth, linear, or stepped: a cut to the next key
  friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// A camera that moves along the timeline. Keys ascend in time, no two at the same time.
struct CameraTrack {
  std::vector<CameraKey> keys;
  friend bool operator==(const CameraTrack&, const CameraTrack&) = default;
};

/// So many are kept.
inline constexpr std::size_t k_most_camera_keys = 10000;

[[nodiscard]] constexpr bool is_camera_kind(KeyKind kind) {
  return kind == KeyKind::smooth || kind == KeyKind::linear || kind == KeyKind::stepped;
}

/// A camera and the shape of the picture that it was set up for.
struct FramedCamera {
  geometry::CameraPose camera;
  double aspect = 1;  ///< width by height
  friend bool operator==(const FramedCamera&, const FramedCamera&) = default;
};

/// The camera at a moment, held before the first and after the last key. Between keys what it looks at, its direction
/// (the shorter way round), its distance and its angle go on smoothly, and never beyond the keys. Nothing: no keys.
[[nodiscard]] std::optional<FramedCamera> camera_at(const CameraTrack& track, double time_s);

/// A part of a picture, px, from its left and upper to its right and lower corner.
struct PartOfPicture {
  geometry::PxPoint from, to;
};

/// The view of a part of a picture alone, as it is looked at from straight before its middle.
[[nodiscard]] View view_of_part(const View& whole, const PartOfPicture& part);
/// The camera of a whole picture whose part shows all that a framed camera shows, in its middle and as large as there
/// is room for. view_of_part the other way round, where the part has the shape of the frame.
[[nodiscard]] geometry::CameraPose camera_of_whole(const FramedCamera& framed, geometry::Viewport whole,
                                                   const PartOfPicture& part);

}  // namespace penpose::document
