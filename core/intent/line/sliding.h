#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/space.h"
#include "core/inference/weights.h"
#include "core/intent/line/mode_algebra.h"
#include "core/intent/problem.h"

namespace penpose::intent {

/// How many independent measurements a curve counts as, whatever the number of its points: the hand's error changes
/// slowly along a stroke.
inline constexpr double k_looks = 7.0;

/// Which part of a reference is matched with which part of a drawn line, as shares 0..1 of their lengths. Points
/// outside of that part have no target.
struct Alignment {
  bool reversed = false;  ///< the line runs against the reference
  bool closed = false;    ///< both are loops: no ends, but a share by which the start is turned
  double turned = 0;      ///< loops: the share of the line at which the reference starts
  double reference_from = 0, reference_to = 1;
  double line_from = 0, line_to = 1;
  inference::Terms terms{};  ///< what is unlikely about it
  double charge = 0;         ///< its cost: the terms by their weights
  /// How far the whole line may be off from where it was meant, perpendicular to the chord between its ends: px, root
  /// mean square. 0: not at all.
  double offset_px = 0;
  double ends = 0;  ///< how much more a line's ends count than its middle
  /// Strokes begin and end within this share of the line's length of where they were meant to, root mean square.
  double slide = 0.04;
  double rough = 1;  ///< factor of the stroke's doubt
  /// How far the reference's first and last point slide along the line, as a multiple of what ends do.
  std::array<double, 2> ends_slide{1.0, 1.0};
};

/// The targets of a reference's points on a line, and how certain they are.
struct Matching {
  std::vector<PxPoint> target;   ///< one a reference point
  std::vector<PxPoint> tangent;  ///< of the line there, length one
  std::vector<double> weight;    ///< share of the reference's length that the point represents; 0: it has no target
  std::vector<double> slid;      ///< px that the target has slid along the line
  std::vector<double> along;     ///< px from the line's start to the target
  std::vector<Modes> modes;      ///< px by which the point slides for one unit of each mode
  /// Px by which one unit of the last mode moves the point across the line; empty: no mode moves it so.
  std::vector<double> across;
};

/// A drawn line, prepared for matching.
class SlidingLine {
 public:
  /// Precondition: at least two points, of positive length.
  explicit SlidingLine(std::span<const PxPoint> line);

  [[nodiscard]] double length() const { return lengths_.back(); }
  [[nodiscard]] std::span<const PxPoint> points() const { return line_; }
  /// The place at a distance in px from the start.
  [[nodiscard]] PxPoint at(double along_px) const { return point(along_px); }

  /// Order-preserving matching with free ends. Neither the speed of the pen nor a small gap or overshoot at the ends is
  /// meant: points of the reference slide along the line from the place of equal arc length by smooth modes (two for
  /// the ends, four in between), each of which costs the square of its size. `seen` are the
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

/// Which alignments of a line with a reference are worth trying, the likeliest first. Its direction follows from both
/// ends and the direction all along; where these are ambiguous, both directions are listed. Lines much shorter or
/// longer than the reference may be a part of it, or overshoot it. `near_px`: ends closer than this meet (loops). A
/// line that overshoots at one end only is less likely the farther it does. The last alignment assumes that the line
/// gives the shape and is off from where it was meant.
[[nodiscard]] std::vector<Alignment> alignments(std::span<const PxPoint> seen, std::span<const PxPoint> line,
                                                double near_px,
                                                const inference::Weights& weights = inference::learned_weights());

}  // namespace penpose::intent
