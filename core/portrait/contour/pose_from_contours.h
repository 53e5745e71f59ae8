#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/intent/model/whole_model.h"
#include "core/mesh/triangle_mesh.h"
#include "core/portrait/placement.h"
#include "core/posing/problem.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// Lines of a sheet that are contours.
struct ContourDrawing {
  std::vector<std::vector<PxPoint>> lines;  ///< px of the sheet
  double width = 0, height = 0;             ///< of the sheet, px
  /// Where the sheet lies in the only view, if that is known.
  std::optional<Placement> placement;
  /// Points that other lines put where they are.
  std::vector<posing::CurvePoint> kept;
};

/// The pose whose contours lines are.
struct ContourPose {
  rig::Pose pose;               ///< all parameters of the rig
  std::vector<bool> explained;  ///< one a line: whether most of it lies beside a contour of this pose; none where most
                                ///< of all does not
  std::size_t view = 0;         ///< of those given, the likeliest one
  double energy = 0;            ///< what was minimised
};

/// Poses a rig so that lines are its contours as one of these views shows it, moving few controls and joints. The sheet
/// is laid on the picture as `penpose render` would have drawn it there, or, where that fits better, by the box of all
/// its lines. `start`: where nothing has moved; `free`: parameters that may move, ascending.
/// Errors (place: the line): no lines, too many, lines without length, numbers that are not finite; a model without a
/// contour in these views.
[[nodiscard]] base::Result<ContourPose> pose_from_contours(const rig::Rig& rig, const mesh::TriangleMesh& mesh,
                                                           const intent::WholeModel& whole,
                                                           const ContourDrawing& drawing,
                                                           std::span<const geometry::Camera> views,
                                                           const rig::Pose& start, std::span<const std::size_t> free);

}  // namespace penpose::portrait
