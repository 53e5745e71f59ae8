#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/document/document.h"
#include "core/document/features/feature_curves.h"
#include "core/geometry/camera.h"
#include "core/intent/model/whole_model.h"
#include "core/io/picture_lines/picture_lines.h"
#include "core/portrait/read_drawing.h"

namespace penpose::cli {

/// What a line of a drawing was taken for.
struct LineTaken {
  bool contour = false;     ///< a contour line, by its name or since all are
  bool explained = false;   ///< such a line: beside a contour of the pose
  portrait::LineRead read;  ///< of any other line
};

/// The pose that a drawing asks for.
struct PosedSheet {
  rig::Pose pose;                ///< all parameters of the rig
  std::vector<LineTaken> lines;  ///< one a line
  std::vector<portrait::LineRead> neutral;
};

/// Whether a line of a drawing is a contour, by its name (io::k_contour_name).
[[nodiscard]] bool is_contour(const io::PictureLine& line);

/// How drawings are read.
struct SheetReading {
  const document::Document& document;
  const intent::WholeModel& whole;
  std::span<const portrait::FeatureCurve> curves;  ///< empty where all lines are contours
  std::vector<portrait::DrawnLine> neutral;        ///< empty: none
  double yaw_degrees = 0;                          ///< from which drawings see the model
  bool contours = false;                           ///< all lines are contours
};

/// Reads one drawing: the features of a face first, then contours, which move what these leave free; or contours alone.
/// Errors: those of portrait::pose_from_drawing and portrait::pose_from_contours.
[[nodiscard]] base::Result<PosedSheet> posed_sheet(const SheetReading& reading, const io::PictureLines& drawn);

}  // namespace penpose::cli
