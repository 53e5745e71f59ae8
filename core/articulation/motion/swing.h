#pragma once

#include <span>
#include <vector>

#include "core/articulation/sketch.h"

namespace penpose::articulation {

/// Scratch memory of a swing.
struct SwingWorkspace {
  std::vector<double> angles, sines, cosines;
};

/// The motion of a curve by turning: every segment turns by its own rotation and scales, evenly with the amount, and
/// the curve is put together of them. The rotations start from the one that turns the whole curve best, and each is the
/// least turn beyond that of its neighbour, so that they differ along the curve by what the curve bends and not by
/// twist. Points that move less are held more to their straight way: a curve whose one end stays swings about it, one
/// that moves as a whole is carried by its middle. Nothing depends on the direction in which the curve was drawn.
class Swing {
 public:
  /// Precondition: equally many points, at least two, all finite.
  Swing(std::span<const ModelPoint> reference, std::span<const ModelPoint> target);

  /// The rotation of each segment at amount 1: axis times angle, continuous along the curve.
  [[nodiscard]] std::span<const ModelVector> turns() const { return turns_; }
  /// All points of the curve at an amount: the reference at 0, the target at 1.
  void points(double amount, SwingWorkspace& work, std::span<ModelPoint> out) const;

 private:
  struct Segment {
    ModelVector fixed{0};  ///< the reference's, along the axis
    ModelVector level{0};  ///< across it
    ModelVector ahead{0};  ///< a quarter turn on
    double angle = 0;
    double growth = 0;       ///< of its length at amount 1
    ModelVector appears{0};  ///< of a segment without length: what it becomes
  };
  void find_turns(std::span<const ModelPoint> reference, std::span<const ModelPoint> target);

  std::vector<ModelVector> turns_;
  std::vector<Segment> segments_;
  std::vector<double> holds_;  ///< how much each point is held to its straight way; sum 1
  ModelPoint held_{0};         ///< mean of the reference's points by that
  ModelVector held_move_{0};   ///< and of their ways
};

}  // namespace penpose::articulation
