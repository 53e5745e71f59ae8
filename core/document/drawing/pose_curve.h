#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/curve/stroke.h"
#include "core/geometry/camera.h"
#include "core/mesh/mesh_point.h"

namespace penpose::document {

/// Identifies a drawn curve for the lifetime of its document; null at zero. Numbers are never reused.
struct CurveId {
  std::uint32_t value = 0;
  explicit operator bool() const { return value != 0; }
  friend bool operator==(const CurveId&, const CurveId&) = default;
};

/// The view in which something was drawn.
struct View {
  geometry::CameraPose camera;
  geometry::Viewport viewport;
  friend bool operator==(const View&, const View&) = default;
};

/// Number of points kept of a drawn target's line, to display it; the fit uses `points` of the target.
inline constexpr std::size_t k_line_points = 64;
/// Number of points of a reference or constraint curve.
inline constexpr std::size_t k_pose_curve_points = 32;

/// The target of a reference curve: a drawn line, or known points without a line (PlaceTarget).
struct DrawnTarget {
  View view;
  std::vector<curve::PxPoint> line;          ///< evenly spaced; empty: `points` are known
  std::vector<double> pressure;              ///< 0..1, one a point of `line`
  std::vector<geometry::ModelPoint> points;  ///< lifted, one a point of the reference
  std::vector<double> weights;               ///< from the pressure along the line, mean 1, one a point of the reference
  friend bool operator==(const DrawnTarget&, const DrawnTarget&) = default;
};

enum class PoseCurveRole : std::uint8_t {
  reference,   ///< brought to its target, once it has one
  constraint,  ///< stays where it was when it was set
};

/// A curve of the posing tool, glued to the surface (method, section 2).
struct PoseCurve {
  CurveId id;
  PoseCurveRole role = PoseCurveRole::reference;
  std::vector<mesh::MeshPoint> points;     ///< a single one is a pin
  std::optional<DrawnTarget> target;       ///< of a reference
  std::vector<geometry::ModelPoint> kept;  ///< of a constraint: one a point
  /// For a reference that snapped to a sheet next to the pen: from each point to the pen; else empty.
  std::vector<geometry::ModelVector> aside;
  double time_s = 0;  ///< of the timeline: when it, or its target, was drawn (apply.h)
  friend bool operator==(const PoseCurve&, const PoseCurve&) = default;
};

}  // namespace penpose::document
