#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/drawing/pose_curve.h"
#include "core/rig/character_rig.h"

namespace penpose::document {

/// A line of a face that was drawn as it should be.
struct FaceLine {
  CurveId id;                        ///< of the numbers of all curves
  std::vector<curve::PxPoint> line;  ///< px of the drawing's view; evenly spaced, k_line_points
  std::optional<std::string> said;  ///< the feature that the artist says it is, empty: nothing known; none: it is found
  std::string feature;              ///< what it was taken for; empty: nothing known
  friend bool operator==(const FaceLine&, const FaceLine&) = default;
};

/// Lines that are read together, each a target whose reference is found: the face as somebody draws it, in one view.
struct FaceDrawing {
  View view;
  std::vector<FaceLine> lines;           ///< in the order of drawing
  geometry::ModelPoint middle{0, 0, 0};  ///< of the face: about where the lines lie in space
  double time_s = 0;                     ///< Document::time_s
  /// The rig, the pose before the first line and the one that was read; null and empty: not known.
  std::shared_ptr<const rig::CharacterRig> rig;
  rig::Pose base, posed;
};

/// So many lines are read together.
inline constexpr std::size_t k_most_face_lines = 60;

/// Whether lines of both views belong to one drawing: a face is seen from about the same side.
[[nodiscard]] bool same_side(const View& a, const View& b);

/// Where a line that was drawn in a view lies in space: on the plane through `middle` that faces the eye. Nothing: a
/// view that cannot be, or one that looks away from there.
[[nodiscard]] std::optional<std::vector<geometry::ModelPoint>> points_of(const View& view,
                                                                         const std::vector<curve::PxPoint>& line,
                                                                         const geometry::ModelPoint& middle);

/// A line as it would have been drawn in another view of the same side, so that it lies over the same places of what is
/// about `middle`. Nothing: a view that cannot be or is of another side, or one that looks away from there.
[[nodiscard]] std::optional<std::vector<curve::PxPoint>> line_in(const View& to, const View& from,
                                                                 const std::vector<curve::PxPoint>& line,
                                                                 const geometry::ModelPoint& middle);
/// The same of a line of a drawing.
[[nodiscard]] inline std::optional<std::vector<curve::PxPoint>> line_in(const View& to, const FaceDrawing& drawing,
                                                                        const FaceLine& line) {
  return line_in(to, drawing.view, line.line, drawing.middle);
}

}  // namespace penpose::document
