#pragma once

#include <string>
#include <vector>

#include "core/animation/points/eigen_points.h"
#include "core/animation/track.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// Pictures in which somebody has drawn the curves: a track of curves (read_curve_track) whose frames name a picture:
/// {"frames": [{"image": "face_01.png", "curves": {NAME: [[x, y], ...]}}, ...], "features": [[NAME, ...], ...]}.
struct LabelFile {
  animation::PointTrack track;                       ///< one frame a picture
  std::vector<std::string> images;                   ///< one a frame, as the file names them
  std::vector<animation::LabelledFeature> features;  ///< points found from one patch; by default a curve each
};

/// Errors (place: JSON pointer): those of read_curve_track, a frame without a picture or in which a curve cannot be
/// used, a feature that names no curve.
[[nodiscard]] base::Result<LabelFile> read_label_file(base::Bytes bytes);

/// The track as read_curve_track takes it; frames without a face are null.
[[nodiscard]] std::string write_curve_track(const animation::PointTrack& track, double fps);

}  // namespace penpose::io
