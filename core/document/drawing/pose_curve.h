#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/curve/stroke.h"
#include "core/geometry/camera.h"
#include "core/mesh/mesh_point.h"

namespace penpose::document {

/// Names a drawn curve for as long as its document lives; null at zero. Numbers are never used twice.
struct CurveId {
  std::uint32_t value = 0;
  explicit operator bool() const { return value != 0; }
  friend bool operator==(const CurveId&, const CurveId&) = default;
};

/// Where somebody looked from while drawing.
struct View {
  geometry::CameraPose camera;
  geometry::Viewport viewport;
  friend bool operator==(const View&, const View&) = default;
};

/// Points of a drawn target that are kept for drawing it again; the fit uses `points` of the target.
inline constexpr std::size_t k_line_points = 64;
/// Points of a reference or constraint curve.
inline constexpr std::size_t k_pose_curve_points = 32;

/// Where a reference curve should go, as it was drawn; or as it is known, without a line (PlaceTarget).
struct DrawnTarget {
  View view;
  std::vector<curve::PxPoint> line;          ///< evenly spaced; empty: `points` are known
  std::vector<double> pressure;              ///< 0..1, one a point of `line`
  std::vector<geometry::ModelPoint> points;  ///< lifted, one a point of the reference
  std::vector<double> weights;               ///< of the pressure along the line, mean 1, one a point of the reference
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
  /// Of a reference that sticks to a sheet beside the pen: from each point to where the pen was; else empty.
  std::vector<geometry::ModelVector> aside;
  friend bool operator==(const PoseCurve&, const PoseCurve&) = default;
};

}  // namespace penpose::document
