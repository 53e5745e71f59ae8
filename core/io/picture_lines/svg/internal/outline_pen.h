#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/space.h"
#include "core/io/picture_lines/svg/internal/affine.h"

namespace penpose::io {

/// A run of points that a shape was drawn with; of a closed one the last is the first again.
struct Contour {
  std::vector<geometry::PxPoint> points;
  bool closed = false;
};

/// Draws shapes in their own units and keeps them as polylines in px of the drawing.
class OutlinePen {
 public:
  using Point = geometry::PxPoint;

  /// `to_px`: from the shape's units to px; `tolerance`: how far (px) a polyline may be from its curve; `most`: how
  /// many points there may be.
  OutlinePen(const Affine& to_px, double tolerance, std::size_t most)
      : to_px_(to_px), tolerance_(tolerance), most_(most) {}

  /// Begins a contour. One that was never drawn on is forgotten.
  void move_to(Point p);
  void line_to(Point p);
  /// A cubic Bézier curve.
  void curve_to(Point first, Point second, Point p);
  /// A quadratic one.
  void curve_to(Point middle, Point p);
  /// An arc of an ellipse (SVG 1.1, appendix F.6): radii, the turn of its x axis (degrees), which of the four.
  void arc_to(Point radii, double turn, bool large, bool sweep, Point p);
  /// Goes back to where the contour began; what is drawn next begins another one there.
  void close();

  /// Where the pen is, in the shape's units.
  [[nodiscard]] Point at() const { return at_; }
  /// Whether a coordinate lies beyond a million px or is no number.
  [[nodiscard]] bool too_far() const { return too_far_; }
  /// Whether there were more points than may be.
  [[nodiscard]] bool full() const { return full_; }
  /// The contours with at least two points that differ.
  [[nodiscard]] std::vector<Contour> take();

 private:
  void add(Point px);
  void begin_where_needed();

  Affine to_px_;
  double tolerance_;
  std::size_t most_;
  std::size_t points_ = 0;
  std::vector<Contour> contours_;
  Point at_;
  Point start_;
  bool drawing_ = false;
  bool too_far_ = false;
  bool full_ = false;
};

}  // namespace penpose::io
