#include "core/portrait/pose_from_drawing.h"

#include <algorithm>
#include <utility>

#include "core/portrait/sketch/habits.h"
#include "core/portrait/sketch/model_face.h"
#include "core/portrait/sketch/pose_from_sketch.h"
#include "core/portrait/sketch/pose_over_face.h"

namespace penpose::portrait {

rig::Pose pose_of(const rig::Rig& rig, const FaceView& face, const rig::Pose& start, std::span<const double> shares) {
  rig::Pose pose = start;
  for (std::size_t j = 0; j < shares.size(); ++j) {
    const std::size_t p = face.controls()[j].parameter;
    const rig::Parameter& parameter = rig.parameters()[p];
    const double value = start[p] + shares[j] * (parameter.maximum - parameter.minimum);
    pose[p] = std::clamp(value, parameter.minimum, parameter.maximum);
  }
  return pose;
}

namespace {

/// Returns whether two curves are of the same feature and side: an eye, a brow, the lips.
bool of_one_feature(const FeatureCurve& a, const FeatureCurve& b) {
  constexpr std::size_t k_telling = 4;  // letters: brow, eyel, lip_, nose
  const bool lips = a.name.starts_with("lip_");
  return a.name.substr(0, k_telling) == b.name.substr(0, k_telling) && (lips || a.name.back() == b.name.back());
}

/// Returns whether most lines that a reading knows are the same feature in a sketch.
bool agree(std::span<const FeatureCurve> curves, const std::vector<LineRead>& read,
           const std::vector<LineRead>& sketched) {
  constexpr double k_most = 0.75;
  double known = 0, same = 0;
  for (std::size_t i = 0; i < read.size() && i < sketched.size(); ++i) {
    if (!read[i].curve) continue;
    known += 1;
    if (sketched[i].curve && of_one_feature(curves[*read[i].curve], curves[*sketched[i].curve])) same += 1;
  }
  return same >= k_most * known;
}

/// Returns whether a pose shows something else than what a person sees in the drawing.
bool shows_else(const rig::Rig& rig, std::span<const FeatureCurve> curves, const SketchedPose& sketched,
                const rig::Pose& pose, const rig::Pose& start, const geometry::Camera& camera) {
  const auto rest = ModelFace::see(rig, curves, start, camera);
  const auto posed = ModelFace::see(rig, curves, pose, camera);
  if (!rest || !posed) return false;
  // A face of this model's own proportions needs no other size.
  if (sketched.layout.scale != 1.0) return false;
  // A drawing of a face at rest is no expression of this one.
  const bool moved = !expression_of(posed->measures(), RestingFace{rest->measures(), 1.0}).rests();
  if (moved && sketched.rests) return true;
  return contradicts(measure(sketched.layout), posed->measures(), rest->measures());
}

/// Returns whether the drawing of the face at rest shows this very model; true without such a drawing.
bool of_this_model(const FaceView& face, const Drawing& drawing) {
  if (drawing.neutral.empty() || drawing.in_view) return true;
  const auto rest = read_drawing(face, {drawing.neutral, {}, false, drawing.given_neutral, {}});
  return !rest || rest->of_this_face;
}

}  // namespace

base::Result<DrawnPose> pose_from_drawing(const rig::Rig& rig, const intent::WholeModel& whole,
                                          std::span<const FeatureCurve> curves, const Drawing& drawing,
                                          const geometry::Camera& camera, const rig::Pose& start,
                                          std::span<const std::size_t> free) {
  const auto face = FaceView::make(rig, whole, curves, start, free, camera);
  if (!face) return face.error();
  for (const auto& [lines, sheet] :
       {std::pair{&drawing.lines, "drawing"}, std::pair{&drawing.neutral, "neutral drawing"}}) {
    if (lines == &drawing.neutral && lines->empty()) continue;
    if (auto status = check_lines(*lines, sheet); !status) return status.error();
  }
  DrawnPose out;
  const bool few = drawing.lines.size() <= k_most_lines && drawing.neutral.size() <= k_most_lines;
  if (few && of_this_model(*face, drawing)) {
    auto read = read_drawing(*face, drawing);
    if (!read) return read.error();
    out.read = std::move(*read);
    out.pose = pose_of(rig, *face, start, out.read.shares);
    const Placement& on_face = out.read.placement;
    out.sheet = {on_face.along / face->scale(), on_face.across / face->scale(),
                 face->middle() + on_face.shift * (1.0 / face->scale())};
    // A whole face is drawn in proportions of its own, a few lines where they are meant.
    if (drawing.in_view && drawing.neutral.empty() && drawing.lines.size() < k_whole_face) {
      auto over = pose_over_face(rig, whole, curves, drawing, out.read, camera, start, free);
      if (!over) return over.error();
      out.pose = std::move(*over);
      return out;
    }
    if (drawing.in_view || (drawing.traced && out.read.of_this_face)) return out;
  }
  auto sketched = pose_from_sketch(rig, whole, curves, drawing, camera, start, free);
  if (!sketched) return sketched.error();
  if (out.pose.empty()) {
    out.pose = start;
    out.read.of_this_face = false;
    out.read.lines.resize(drawing.lines.size());
    out.read.neutral.resize(drawing.neutral.size());
    out.read.shares.assign(face->controls().size(), 0.0);
    out.read.proportions.assign(face->proportion_count(), 0.0);
  }
  const bool of_model = few && out.read.of_this_face;
  if (!*sketched) return out;
  const bool clear = agree(curves, out.read.lines, (*sketched)->lines);
  if (of_model && !(clear && shows_else(rig, curves, **sketched, out.pose, start, camera))) return out;
  out.pose = std::move((*sketched)->pose);
  out.read.lines = std::move((*sketched)->lines);
  out.sheet = (*sketched)->sheet;
  return out;
}

geometry::Camera camera_of_drawing(const rig::Rig& rig, std::span<const FeatureCurve> curves, const rig::Pose& start,
                                   double yaw_degrees) {
  constexpr double k_far = 1.0;  // degrees of view: nothing is nearer than the rest
  std::vector<geometry::ModelPoint> places(rig.vertex_count());
  rig.evaluate(start, places);
  geometry::Box box;
  for (const FeatureCurve& curve : curves) {
    for (const posing::CurvePoint& point : curve.points) {
      for (std::size_t k = 0; k < point.vertex.size(); ++k) {
        if (point.weight[k] != 0.0 && point.vertex[k] < places.size()) box.add(places[point.vertex[k]]);
      }
    }
  }
  return geometry::frame_box(box, {1000, 1000}, yaw_degrees, 0, k_far);
}

}  // namespace penpose::portrait
