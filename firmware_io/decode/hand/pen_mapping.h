#pragma once

#include <optional>

#include "core/base/result.h"
#include "firmware_io/decode/hand/pressure_curve.h"
#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::decode {

/// A part of the tablet, in fractions of its full area with the origin at its own upper left corner.
struct TabletArea {
  double left = 0, top = 0, right = 1, bottom = 1;
};

struct PenMappingOptions {
  double width_px = 0;  ///< of the picture that the tablet maps to; both above 0
  double height_px = 0;
  bool keep_aspect = false;  ///< use only the central part of the area that has the picture's shape
  int quarter_turns = 0;     ///< how far the tablet itself is turned clockwise on the desk
  bool left_handed = false;  ///< turned by half a turn, keys on the right; adds to `quarter_turns`
  std::optional<TabletArea> area = std::nullopt;  ///< the user's part of the tablet, before any turn
  PressureCurve pressure = {};
};

/// A sample in an application's units. Position and pressure are exact functions of the raw sample; nothing is
/// smoothed.
struct MappedSample {
  double x_px = 0;  ///< 0..width, clamped to the area
  double y_px = 0;
  double pressure = 0;        ///< 0..1 after the curve
  double tilt_x_degrees = 0;  ///< leaning right in the picture is positive
  double tilt_y_degrees = 0;  ///< leaning towards the user is positive
  Tool tool = Tool::none;
  bool in_range = false;
  bool tip = false;
  std::uint32_t buttons = 0;
};

/// From a device's units to a picture, pressure 0..1 and degrees.
class PenMapping {
 public:
  /// Errors: no picture, no position axes, an empty area or one outside of the tablet.
  [[nodiscard]] static base::Result<PenMapping> make(const PenAxes& axes, PenMappingOptions options);

  [[nodiscard]] MappedSample map(const PenSample& sample) const;

 private:
  PenMapping() = default;

  /// The part of an axis that is used, in device units.
  struct Span {
    double start = 0;
    double end = 1;
    [[nodiscard]] double fraction(double value) const;
  };

  Span x_;
  Span y_;
  Axis pressure_axis_;
  double units_per_degree_x_ = 1;
  double units_per_degree_y_ = 1;
  PenMappingOptions options_;
  int turns_ = 0;  ///< 0..3
};

}  // namespace penpose::decode
