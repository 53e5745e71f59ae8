#include "tests/judges/drawing/judged_face.h"

#include "core/document/features/drawing_start.h"
#include "tests/judges/cases/picture.h"

namespace penpose::judges::drawn {

std::shared_ptr<const JudgedFace> face_of(const Rig& rig) {
  thread_local std::shared_ptr<const JudgedFace> last;
  // The last face holds its rig, so that no other one can have its address.
  if (last && last->model().rig == rig.model.rig) return last;
  auto face = std::make_shared<JudgedFace>();
  face->document = document::make_document(rig.model);
  face->whole = intent::measure_whole_model(*rig.model.rig);
  for (const FaceLine& line : rig.lines) {
    portrait::FeatureCurve mark{line.name, {}};
    for (const std::uint32_t v : line.vertices) mark.points.push_back(posing::at_vertex(v));
    face->marks.push_back(std::move(mark));
  }
  face->rest = posed(face->model(), rig::rest_pose(face->rig()));
  last = std::move(face);
  return last;
}

bool has_face(const Rig& rig) {
  const auto has = [&](const char* lip) {
    return rig.line(lip) != nullptr || rig.line(std::string(lip) + "_outer") != nullptr;
  };
  return has("lip_upper") && has("lip_lower");
}

base::Result<portrait::DrawnPose> read(const JudgedFace& face, std::span<const portrait::FeatureCurve> curves,
                                       const portrait::Drawing& drawing, double yaw_degrees) {
  const auto start = document::drawing_start(face.document, face.whole, curves);
  const auto camera = portrait::camera_of_drawing(face.rig(), curves, start.pose, yaw_degrees);
  return portrait::pose_from_drawing(face.rig(), face.whole, curves, drawing, camera, start.pose, start.free);
}

}  // namespace penpose::judges::drawn
