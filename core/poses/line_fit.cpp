#include "core/poses/line_fit.h"

#include <algorithm>

#include "core/intent/solve.h"

namespace penpose::poses {
namespace {

/// The eye is so many sizes of the face away from it: nearly without perspective, as drawings of faces are.
constexpr double k_eye_away = 12;
constexpr double k_fov_degrees = 24;

base::Result<geometry::Camera> camera_from(const FaceMeasure& face, const ModelVector& from) {
  geometry::Box box;
  for (const ModelPoint& p : face.rest()) box.add(p);
  geometry::CameraPose pose;
  pose.look_at = in_model(face.frame(), box.center());
  pose.eye = pose.look_at + in_model(face.frame(), from) * (k_eye_away * face.size());
  pose.vertical_fov_degrees = k_fov_degrees;
  return geometry::Camera::make(pose, {1000, 1000});
}

/// How far the line asks a place of its feature to go.
ModelVector move_at(const KeptLine& line, double share) {
  std::size_t k = 0;
  while (k + 2 < line.at.size() && line.at[k + 1] < share) ++k;
  const double length = line.at[k + 1] - line.at[k];
  const double t = length > 0 ? std::clamp((share - line.at[k]) / length, 0.0, 1.0) : 0.0;
  return line.moves[k] * (1 - t) + line.moves[k + 1] * t;
}

std::optional<intent::DrawnCurve> drawn_curve(const FaceMeasure& face, std::size_t feature, const KeptLine& line) {
  const auto camera = camera_from(face, line.from);
  if (!camera) return std::nullopt;
  const auto& points = face.points(feature);
  intent::DrawnCurve drawn{.reference = {}, .camera = *camera, .target = {}, .weights = {}};
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const double share = points.shares[i];
    if (share < line.at.front() - 1e-9 || share > line.at.back() + 1e-9) continue;
    const ModelPoint to = points.rest[i] + move_at(line, share) * face.features()[feature].unit;
    const auto px = camera->project(in_model(face.frame(), to));
    if (!px) return std::nullopt;
    drawn.reference.push_back(points.points[i]);
    drawn.target.push_back(*px);
  }
  if (drawn.reference.size() < 2) return std::nullopt;
  drawn.doubt_px = intent::doubt_px(camera->viewport());
  return drawn;
}

}  // namespace

base::Result<rig::Pose> fit_lines(const FaceMeasure& face, const rig::Rig& rig, const std::vector<KeptLine>& lines,
                                  FacePart part) {
  intent::IntentProblem problem;
  for (const KeptLine& line : lines) {
    const auto feature = face.find(line.feature);
    if (!feature || (part != FacePart::all && face.features()[*feature].part != part)) continue;
    if (auto drawn = drawn_curve(face, *feature, line)) problem.drawn.push_back(std::move(*drawn));
  }
  if (problem.drawn.empty())
    return base::Error{"none of the lines that it was drawn with lies on a feature that both faces have", "", ""};
  for (std::size_t i = 0; i < rig.parameters().size(); ++i) {
    if (face.moves(i, part)) problem.free.push_back(i);
  }
  problem.start = rig::rest_pose(rig);
  intent::SolveWorkspace work;
  auto solved = intent::solve(rig, intent::measure_whole_model(rig), problem, {}, work);
  if (!solved) return solved.error();
  return std::move(solved->pose);
}

}  // namespace penpose::poses
