#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/articulation/motion/curve_motion.h"
#include "core/articulation/motion/knots.h"
#include "core/articulation/region/kept_surface.h"

namespace penpose::articulation {

/// A vertex that a moving curve carries along.
struct Rider {
  std::uint32_t segment = 0;  ///< of the reference, closest on the image plane
  double fraction = 0;        ///< 0..1 of that segment
  double weight = 1;          ///< articulation weight
  ModelPoint rest{0};         ///< world position at rest
  glm::dmat3 to_rest{1};      ///< from a world displacement to one of the rest vertex
};

/// A vertex that is carried by the whole of a curve instead of by the place on it that is closest.
struct Passenger {
  std::uint32_t segment = 0;  ///< the place that it turns about
  double fraction = 0;
  double weight = 1;
  ModelVector move{0};  ///< mode translate: its displacement at amount 1; over a ball its tilt, axis times angle
  ModelVector turn{0};  ///< mode rotate, and over a ball: its own turn at amount 1, axis times angle
  ModelVector more{0};  ///< what it moves beside that at amount 1, and going below 0 ...
  ModelVector less{0};  ///< ... instead of that, by as much as the amount
  ModelPoint rest{0};
  glm::dmat3 to_rest{1};
};

/// Where vertices are at another amount than 1 than their motion has them.
struct CarriageBetween {
  double amount = 0.5;             ///< neither 0 nor 1
  std::vector<ModelVector> moves;  ///< one a rider: its displacement there, in the space of the rest vertices
};

/// Scratch memory of evaluations; one for each thread.
struct CarriageWorkspace {
  MotionWorkspace motion;
  std::vector<double> angles, sines, cosines;
};

/// Vertices carried by the motion of a curve: the deformation of one deformer (method, section 3, "Vertex
/// deformation"), prepared for being evaluated many times.
///
/// With r the reference at a vertex's segment k and fraction u, t the interpolated curve there: `translate` moves it by
/// w (t - r), which is linear in the amount; `rotate` by w (t + Phi (v - r) - v), Phi = (turns before k) (u times the
/// turn of k). A surface then holds the blended vertex at its level: blending first and constraining second, so that
/// vertices with a weight between 0 and 1 keep their distance too and do not cut through the ball on the chord.
class Carriage {
 public:
  Carriage() = default;
  /// Precondition: segments exist, and `carried` tells whether any rider's to_rest is not the identity.
  Carriage(std::shared_ptr<const CurveMotion> motion, KeptSurface surface, std::span<const Rider> riders, bool carried);

  /// Vertices that move by `move`, or each by its own turn: by w (t - r) + turned (v - r) - (v - r). Precondition: a
  /// motion of mode rotate has a swing.
  Carriage(std::shared_ptr<const CurveMotion> motion, KeptSurface surface, std::span<const Passenger> passengers,
           bool carried);

  /// Leads the riders through other displacements on their way: what these differ by from the motion comes in and goes
  /// straight between the neighbouring amounts (knots.h). Precondition: ascending amounts, none added before.
  void add_betweens(std::vector<CarriageBetween> betweens);

  [[nodiscard]] std::size_t size() const { return rests_.size(); }
  /// The same motion for some of the riders, in the order asked for.
  [[nodiscard]] Carriage subset(std::span<const std::uint32_t> riders) const;
  [[nodiscard]] const CurveMotion& motion() const { return *motion_; }

  /// True when displacements are the amount times `columns()`: mode translate without a surface.
  [[nodiscard]] bool linear() const { return !turning() && !surface_.exists() && mores_.empty() && betweens_.empty(); }
  /// Displacements at amount 1. Precondition: linear().
  [[nodiscard]] std::span<const ModelVector> columns() const { return columns_; }

  /// Displacement of every rider, in the space of the rest vertices; exactly zero at amount 0. Allocates only the first
  /// time.
  void displacements(double amount, CarriageWorkspace& work, std::span<ModelVector> out) const;

 private:
  /// v - r in the frame of its segment, split by the axis of the segment's turn: along it, in the plane at angle 0, and
  /// a quarter turn ahead.
  struct Offset {
    ModelVector along{0};
    ModelVector level{0};
    ModelVector ahead{0};
  };

  [[nodiscard]] bool turning() const { return motion_ && motion_->mode() == Mode::rotate; }
  void turned(double amount, CarriageWorkspace& work, std::span<ModelVector> out) const;
  void swung(double amount, CarriageWorkspace& work, std::span<ModelVector> out) const;
  void slid(double amount, std::span<ModelVector> out) const;
  void moved(double amount, CarriageWorkspace& work, std::span<ModelVector> out) const;
  void add_more(double amount, std::span<ModelVector> out) const;
  void reserve(std::size_t riders, bool carried);
  void mark_segments();

  std::shared_ptr<const CurveMotion> motion_;
  KeptSurface surface_;
  std::vector<ModelPoint> rests_;
  std::vector<double> levels_;           ///< with a surface
  std::vector<ModelVector> columns_;     ///< of mode translate, weights included
  std::vector<std::uint32_t> segments_;  ///< of mode rotate, as the next four
  std::vector<double> fractions_;
  std::vector<double> weights_;
  std::vector<double> turns_;  ///< u times the angle of the segment
  std::vector<Offset> offsets_;
  std::vector<ModelPoint> bases_;     ///< of a swing: what is left of where it is at rest
  std::vector<ModelVector> mores_;    ///< beside all that, at amount 1; empty where nothing is
  std::vector<ModelVector> lesses_;   ///< the same below 0; as many
  std::vector<ModelVector> slides_;   ///< of a slide: turns, whose tilts stand in columns_
  std::vector<std::uint8_t> wanted_;  ///< segments that carry anything, up to the last one that does
  std::vector<glm::dmat3> to_rest_;   ///< empty when nothing carries the vertices
  struct Between {
    Knot knot;
    std::vector<ModelVector> differences;
  };
  std::vector<Between> betweens_;
};

}  // namespace penpose::articulation
