#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/document/model.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/surface/face_frame.h"

namespace penpose::document {

/// The directions of a model: left, up, and where its face looks; from the model's origin.
[[nodiscard]] portrait::FaceFrame front_of(const Model& model);

/// Places of one half of a face that words speak of.
enum class Mark : std::uint8_t {
  brow_inner,
  brow_middle,
  brow_outer,
  lid_upper,
  lid_lower,
  cheek,         ///< below the eye
  cheek_hollow,  ///< beside the corner of the mouth
  nose_wing,
  corner,  ///< of the mouth
  lip_upper,
  lip_upper_middle,
  lip_upper_border,
  lip_lower,
  lip_lower_middle,
  lip_lower_border,
  chin,
  lid_upper_inner,  ///< towards the nose
  lid_upper_outer,
  lid_lower_inner,
  lid_lower_outer,
  ball,    ///< the front of the eye's ball, against its middle
  tongue,  ///< or teeth: of what lies behind the lips that which moves farthest, against the chin
};
inline constexpr std::size_t k_marks = 22;

/// Ways of the marks of one half, as shares of the distance between the eyes: x out of the middle, y up, z forward.
struct HalfMoves {
  std::array<geometry::ModelVector, k_marks> way{};
  [[nodiscard]] const geometry::ModelVector& operator[](Mark mark) const { return way[static_cast<std::size_t>(mark)]; }
};

/// What a pose does to a face.
struct FaceMoves {
  std::array<HalfMoves, 2> half;  ///< the face's left one, its right one
};

/// The marks of one face, ready for being measured. Found once for a model.
class FaceMarks {
 public:
  /// Nothing where features say neither where eyes nor where lips are.
  static std::optional<FaceMarks> of(const Model& model, std::span<const portrait::FeatureCurve> features);

  [[nodiscard]] FaceMoves moves(const rig::Pose& pose);
  /// Whether a parameter moves any mark.
  [[nodiscard]] bool moves(std::size_t parameter) const { return bound_->moves(parameter); }
  [[nodiscard]] bool has(Mark mark) const { return !points_[static_cast<std::size_t>(mark)][0].empty(); }
  [[nodiscard]] const portrait::FaceFrame& frame() const { return frame_; }
  /// The distance between the eyes, model units.
  [[nodiscard]] double unit() const { return unit_; }
  /// How far the eyes are open at rest, in units.
  [[nodiscard]] double open() const { return open_; }
  [[nodiscard]] geometry::ModelPoint eye(std::size_t side) const { return eyes_[side]; }

 private:
  using Weights = std::vector<std::pair<std::uint32_t, double>>;  ///< numbers of bound vertices, shares
  using Places = std::vector<geometry::ModelPoint>;
  class Maker;

  [[nodiscard]] geometry::ModelVector way_of(const Weights& weights, const Places& moved) const;

  std::shared_ptr<const rig::CharacterRig> rig_;
  portrait::FaceFrame frame_;
  double unit_ = 1, open_ = 0.2;
  std::array<geometry::ModelPoint, 2> eyes_{};
  std::array<std::array<Weights, 2>, k_marks> points_;
  std::array<Weights, 2> ball_middle_;
  std::vector<Weights> inside_;  ///< pieces behind the lips
  std::unique_ptr<rig::BoundVertices> bound_;
  Places rest_;
};

}  // namespace penpose::document
