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

/// How a vertex is bound to a curve: it moves as the closest place on the curve does.
struct ClosestBinding {
  std::uint32_t segment = 0;  ///< of the reference, closest on the image plane
  double fraction = 0;        ///< 0..1 of that segment
  double weight = 1;          ///< articulation weight
  ModelPoint rest{0};         ///< world position at rest
  glm::dmat3 to_rest{1};      ///< from a world displacement to one of the rest vertex
};

/// How a vertex is bound to a curve: it moves as a blend of the whole curve instead of as the closest place on it.
struct BlendedBinding {
  std::uint32_t segment = 0;  ///< it turns about this place on the curve
  double fraction = 0;
  double weight = 1;
  ModelVector move{0};  ///< mode translate: its displacement at amount 1; over a ball its tilt, axis times angle
  ModelVector turn{0};  ///< mode rotate, and over a ball: its own turn at amount 1, axis times angle
  ModelVector more{0};  ///< added to that at amount 1 ...
  ModelVector less{0};  ///< ... and below 0 in its stead; in proportion to the amount
  ModelPoint rest{0};
  glm::dmat3 to_rest{1};
};

/// Displacements of the vertices at one amount, where they differ from those of the motion.
struct BetweenDisplacements {
  double amount = 0.5;             ///< neither 0 nor 1
  std::vector<ModelVector> moves;  ///< one a vertex, in the space of the rest vertices
};

/// Scratch memory of evaluations; one for each thread.
struct CurveSkinWorkspace {
  MotionWorkspace motion;
  std::vector<double> angles, sines, cosines;
};

/// Vertices bound to a moving curve: the deformation of one deformer (method, section 3, "Vertex deformation"),
/// prepared to be evaluated many times.
///
/// With r the reference at a vertex's segment k and fraction u, t the interpolated curve there: `translate` moves it by
/// w (t - r), which is linear in the amount; `rotate` by w (t + Phi (v - r) - v), Phi = (turns before k) (u times the
/// turn of k). A surface then holds the blended vertex at its level: blending first and constraining second, so that
/// vertices with a weight between 0 and 1 keep their distance too and do not cut through the ball on the chord.
class CurveSkin {
 public:
  CurveSkin() = default;
  /// Precondition: segments exist, and `carried` tells whether any binding's to_rest is not the identity.
  CurveSkin(std::shared_ptr<const CurveMotion> motion, KeptSurface surface, std::span<const ClosestBinding> bindings,
            bool carried);

  /// Vertices that move by `move`, or each by its own turn: by w (t - r) + turned (v - r) - (v - r). Precondition: a
  /// motion of mode rotate has a swing.
  CurveSkin(std::shared_ptr<const CurveMotion> motion, KeptSurface surface, std::span<const BlendedBinding> bindings,
            bool carried);

  /// Makes the vertices pass through other displacements. Their differences from the motion are interpolated linearly
  /// between neighbouring amounts (knots.h). Precondition: ascending amounts, none added before.
  void add_betweens(std::vector<BetweenDisplacements> betweens);

  [[nodiscard]] std::size_t size() const { return rests_.size(); }
  /// The same motion for some of the vertices, in the order of `places`.
  [[nodiscard]] CurveSkin subset(std::span<const std::uint32_t> places) const;
  [[nodiscard]] const CurveMotion& motion() const { return *motion_; }

  /// True when displacements are the amount times `columns()`: mode translate without a surface.
  [[nodiscard]] bool linear() const { return !turning() && !surface_.exists() && mores_.empty() && betweens_.empty(); }
  /// Displacements at amount 1. Precondition: linear().
  [[nodiscard]] std::span<const ModelVector> columns() const { return columns_; }

  /// Displacement of every vertex, in the space of the rest vertices; exactly zero at amount 0. Allocates only the
  /// first time.
  void displacements(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const;

 private:
  /// v - r in the frame of its segment, split by the axis of the segment's turn: along it, in the plane at angle 0, and
  /// a quarter turn ahead.
  struct Offset {
    ModelVector along{0};
    ModelVector level{0};
    ModelVector ahead{0};
  };

  [[nodiscard]] bool turning() const { return motion_ && motion_->mode() == Mode::rotate; }
  void turned(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const;
  void swung(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const;
  void slid(double amount, std::span<ModelVector> out) const;
  void moved(double amount, CurveSkinWorkspace& work, std::span<ModelVector> out) const;
  void hold(std::span<ModelVector> out) const;
  void add_more(double amount, std::span<ModelVector> out) const;
  void reserve(std::size_t count, bool carried);
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
  std::vector<ModelPoint> bases_;     ///< of a swing: the part of the rest position that does not turn
  std::vector<ModelVector> mores_;    ///< added to all that at amount 1; empty where nothing is
  std::vector<ModelVector> lesses_;   ///< the same below 0; as many
  std::vector<ModelVector> slides_;   ///< of a slide: turns; their tilts are in columns_
  std::vector<std::uint8_t> wanted_;  ///< segments with vertices, up to the last such
  std::vector<glm::dmat3> to_rest_;   ///< empty when no joint moves the vertices
  struct BetweenKnot {
    Knot knot;
    std::vector<ModelVector> differences;
  };
  std::vector<BetweenKnot> betweens_;
};

}  // namespace penpose::articulation
