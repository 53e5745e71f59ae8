#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/articulation/motion/swing.h"
#include "core/articulation/sketch.h"

namespace penpose::articulation {

/// Where one segment of the interpolated curve is at an amount. A place at fraction u of it is start + turn * (u *
/// step).
struct SegmentFrame {
  glm::dmat3 turn{1};   ///< product of the turns of all segments before it
  ModelPoint start{0};  ///< its first point
  ModelVector step{0};  ///< to its last point, before `turn`
};

/// Scratch memory of an interpolation; keep it between evaluations.
struct MotionWorkspace {
  std::vector<double> angles, sines, cosines;
  std::vector<SegmentFrame> frames;
  SwingWorkspace swing;
  std::vector<ModelPoint> points;
};

class Slide;

/// How a curve turns: each segment relative to those before it, as in the paper, or as a whole (swing.h).
enum class Turning : std::uint8_t { chained, swung };

/// The motion of a curve from a reference to a target of as many points (method, section 3, "Curve interpolation").
///
/// `rotate`: segment j turns by its own part of the way, relative to the segments before it, and scales; with R_j =
/// Psi_1 ... Psi_j (each Psi_j about an axis in the frame that the turns before it made) the target's segment is s_j
/// R_j e_j, and at amount a every Psi_j turns by a times its angle and every segment is scaled by 1 + a (s_j - 1). The
/// first point moves straight. `translate`: every point moves straight.
class CurveMotion {
 public:
  CurveMotion() = default;
  /// Precondition: equally many points, at least two, all finite; mode is not automatic.
  CurveMotion(std::vector<ModelPoint> reference, std::vector<ModelPoint> target, Mode mode,
              Turning turning = Turning::chained);

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] std::span<const ModelPoint> reference() const { return reference_; }
  [[nodiscard]] std::span<const ModelPoint> target() const { return target_; }
  [[nodiscard]] std::size_t segment_count() const { return reference_.size() - 1; }
  /// The swing of mode rotate when it turns as a whole, else null.
  [[nodiscard]] const Swing* swing() const { return swing_.get(); }
  /// How mode translate slides over a ball (slide.h), where it does; the curve's own points still move straight.
  [[nodiscard]] const Slide* slide() const { return slide_.get(); }
  void set_slide(std::shared_ptr<const Slide> slide) { slide_ = std::move(slide); }
  /// Axis (unit) and angle of a segment's turn, in the frame that the turns before it made.
  [[nodiscard]] const ModelVector& axis(std::size_t segment) const { return segments_[segment].axis; }
  [[nodiscard]] double angle(std::size_t segment) const { return segments_[segment].angle; }

  /// The frames of segments at an amount, for mode rotate, left in work.frames. Only those with a nonzero flag are
  /// computed; segments beyond the flags are skipped. Allocates only the first time.
  void frames(double amount, std::span<const std::uint8_t> wanted, MotionWorkspace& work) const;
  /// All points of the interpolated curve at an amount.
  [[nodiscard]] std::vector<ModelPoint> points(double amount) const;

 private:
  struct Segment {
    ModelVector along{0};   ///< of the reference
    ModelVector across{0};  ///< axis x along
    ModelVector axis{0, 0, 1};
    double angle = 0;        ///< radians, 0..pi
    double growth = 0;       ///< s_j - 1
    bool empty = false;      ///< the reference's segment has no length to turn ...
    ModelVector appears{0};  ///< ... and grows to this, in its own frame
  };

  std::vector<ModelPoint> reference_;
  std::vector<ModelPoint> target_;
  Mode mode_ = Mode::translate;
  std::vector<Segment> segments_;
  std::shared_ptr<const Swing> swing_;
  std::shared_ptr<const Slide> slide_;
};

}  // namespace penpose::articulation
