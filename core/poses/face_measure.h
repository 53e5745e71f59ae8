#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/surface/face_frame.h"
#include "core/poses/kept_pose.h"

namespace penpose::poses {

using geometry::ModelPoint;

/// A feature curve as poses are measured on it. Features run to the face's left, or up.
struct MeasuredFeature {
  std::string name;  ///< without "_outer": lists of known heads call the border of a lip by its lip
  FacePart part = FacePart::all;
  /// Model units that its moves are counted in, along x, y and z of the face: of lids the width of the eye and how far
  /// it is open, so that a blink closes any eye; of lips the width of the mouth; else, and where an eye is closed at
  /// rest, the size of the face.
  ModelVector unit{1};
};

/// How poses move the features of one face: places evenly along brows, lids, lips and jaw.
class FaceMeasure {
 public:
  /// Nothing where a model has none of these features. The features have to be those of the model.
  static std::optional<FaceMeasure> of(const document::Model& model, std::span<const portrait::FeatureCurve> features);

  [[nodiscard]] std::span<const MeasuredFeature> features() const { return features_; }
  /// The number of the feature of a name; none: the face does not have it.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;
  /// Model units: half of the distance between the eyes and half of that from there to the mouth, summed.
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] const portrait::FaceFrame& frame() const { return frame_; }

  /// k_places of each feature, in the frame, model units.
  [[nodiscard]] const std::vector<ModelPoint>& rest() const { return rest_; }
  [[nodiscard]] std::vector<ModelPoint> places(const rig::Pose& pose) const;
  /// Whether a parameter moves places of a part about as far as any, and does not turn the head; of all parts: any.
  [[nodiscard]] bool moves(std::size_t parameter, FacePart part) const;
  /// Whether it moves all features alike, as the neck does.
  [[nodiscard]] bool turns_head(std::size_t parameter) const { return turns_head_[parameter]; }
  /// A pose with what turns the head at rest, measured.
  [[nodiscard]] std::vector<FeatureMoves> moves_of(const rig::Pose& pose) const;

  /// The points of a feature's own curve, in its direction, with their shares of its length, in the frame at rest.
  struct Points {
    std::vector<posing::CurvePoint> points;
    std::vector<double> shares;
    std::vector<ModelPoint> rest;
  };
  [[nodiscard]] const Points& points(std::size_t feature) const { return points_[feature]; }

 private:
  FaceMeasure() = default;
  void find_points(std::span<const portrait::FeatureCurve> features);
  void place_features();
  void measure_units();
  void measure_controls();

  std::shared_ptr<const rig::CharacterRig> rig_;
  std::vector<MeasuredFeature> features_;
  std::vector<Points> points_;
  std::shared_ptr<rig::BoundVertices> bound_;  ///< three vertices a point, of all features
  std::vector<ModelPoint> rest_;
  portrait::FaceFrame frame_;
  double size_ = 1;
  std::vector<bool> turns_head_;
  std::vector<std::array<bool, 4>> moves_;  ///< by parameter and part
};

/// From a place of a face's frame to the model's, or a way.
[[nodiscard]] geometry::ModelPoint in_model(const portrait::FaceFrame& frame, const geometry::ModelPoint& p);

}  // namespace penpose::poses
