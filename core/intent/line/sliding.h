#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/space.h"
#include "core/intent/line/mode_algebra.h"
#include "core/intent/problem.h"

namespace penpose::intent {

/// Independent looks that a curve is worth, whatever the number of its points: the hand's error changes slowly along a
/// stroke.
inline constexpr double k_looks = 7.0;

/// Which part of a reference belongs to which part of a drawn line, as shares 0..1 of their lengths. What lies outside
/// asks for nothing.
struct Alignment {
  bool reversed = false;  ///< the line runs against the reference
  bool closed = false;    ///< both are loops: no ends, but a share by which the start is turned
  double turned = 0;      ///< loops: the share of the line at which the reference starts
  double reference_from = 0, reference_to = 1;
  double line_from = 0, line_to = 1;
  double charge = 0;  ///< what believing in this alignment costs, in the energy's unit
  /// How far the whole line may lie beside where it was meant, across the way from its one end to its other: px, root
  /// mean square. 0: not at all.
  double offset_px = 0;
  double ends = 0;   ///< how much more a line's ends say than its middle
  double rough = 1;  ///< what the stroke's doubt is multiplied by
  /// How far the reference's first and last point slide along the line, as a multiple of what ends do.
  std::array<double, 2> ends_slide{1.0, 1.0};
};

/// Where the points of a reference go on a line, and how sure that is.
struct Matching {
  std::vector<PxPoint> goal;     ///< one a reference point
  std::vector<PxPoint> tangent;  ///< of the line there, length one
  std::vector<double> weight;    ///< share of the reference's length that the point stands for; 0: nothing is asked
  std::vector<double> slid;      ///< px that the goal has slid along the line
  std::vector<double> along;     ///< px from the line's start to the goal
  std::vector<Modes> modes;      ///< px by which the point slides for one unit of each mode
  /// Px by which one unit of the last mode moves the point across the line; empty: no mode moves it so.
  std::vector<double> across;
};

/// A line as drawn, ready for being matched.
class SlidingLine {
 public:
  /// Precondition: at least two points, of positive length.
  explicit SlidingLine(std::span<const PxPoint> line);

  [[nodiscard]] double length() const { return lengths_.back(); }
  [[nodiscard]] std::span<const PxPoint> points() const { return line_; }
  /// The place so many px from the start.
  [[nodiscard]] PxPoint at(double along_px) const { return point(along_px); }

  /// Order-preserving matching with free ends. The line's speed is not a wish, nor is what a stroke leaves out or
  /// overshoots a little at its ends: points of the reference slide along the line from the place of equal arc length
  /// by smooth modes (two for the ends, four in between), each of which costs the square of its size. `seen` are the
  /// reference's points on the picture as they are posed now; `slide` true: the modes are fitted to them (regularised
  /// least squares, three rounds of it as the line bends), false: equal arc length. `doubt`: px.
  [[nodiscard]] Matching match(std::span<const PxPoint> seen, const Alignment& alignment, bool slide,
                               double doubt) const;

 private:
  struct Place {
    PxPoint at;
    PxPoint tangent;
  };
  /// Straight on beyond the ends; loops go round.
  [[nodiscard]] Place place(double along, const Alignment& alignment) const;
  [[nodiscard]] PxPoint point(double along) const;

  std::vector<PxPoint> line_;
  std::vector<double> lengths_;
};

/// Which alignments of a line with a reference are worth trying, the likeliest first. Which way round it runs is told
/// by both its ends and its direction together; where they do not tell, both ways are named. Lines much shorter or
/// longer than the reference may be a part of it, or overshoot it. `near_px`: ends within it meet (loops). A line
/// that overshoots at one end alone is the less likely the more it does. The last one takes the line for one that tells
/// a shape and lies beside where it was meant.
[[nodiscard]] std::vector<Alignment> alignments(std::span<const PxPoint> seen, std::span<const PxPoint> line,
                                                double near_px);

}  // namespace penpose::intent
