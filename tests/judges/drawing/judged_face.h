#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/document/document.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/pose_from_drawing.h"
#include "tests/judges/rigs/rig.h"

namespace penpose::judges::drawn {

/// The face of a rig at rest and the lines on it by which poses of it are judged.
struct JudgedFace {
  document::Document document;
  intent::WholeModel whole;
  std::vector<portrait::FeatureCurve> marks;
  std::vector<geometry::ModelPoint> rest;  ///< of all vertices

  [[nodiscard]] const document::Model& model() const { return *document.model; }
  [[nodiscard]] const rig::CharacterRig& rig() const { return *model().rig; }
  [[nodiscard]] double front_yaw_degrees() const { return model().front_yaw_degrees; }
};

/// The last one is kept on each thread, for measures that look at the same rig one after the other. Precondition: the
/// rig has lines, and the model has their vertices.
[[nodiscard]] std::shared_ptr<const JudgedFace> face_of(const Rig& rig);
/// Whether the face has what drawings of faces are judged by: lips.
[[nodiscard]] bool has_face(const Rig& rig);

/// The pose that the program takes a drawing for, with these feature curves, seen from this side. Errors: those of
/// portrait::pose_from_drawing.
[[nodiscard]] base::Result<portrait::DrawnPose> read(const JudgedFace& face,
                                                     std::span<const portrait::FeatureCurve> curves,
                                                     const portrait::Drawing& drawing, double yaw_degrees);

}  // namespace penpose::judges::drawn
