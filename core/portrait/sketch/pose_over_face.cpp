#include "core/portrait/sketch/pose_over_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/polyline.h"
#include "core/intent/solve.h"
#include "core/portrait/reading/strokes.h"
#include "core/portrait/sketch/habits.h"
#include "core/portrait/sketch/model_face.h"

namespace penpose::portrait {
namespace {

intent::IntentProblem problem_of(std::span<const FeatureCurve> curves, const Drawing& drawing,
                                 std::span<const LineRead> read, const geometry::Camera& camera, double hand_px,
                                 const rig::Pose& start, std::span<const std::size_t> free) {
  intent::IntentProblem problem;
  problem.start = start;
  problem.free.assign(free.begin(), free.end());
  for (const Stroke& stroke : strokes_of(drawing.lines, drawing.given)) {
    const LineRead& line = read[stroke.lines.front()];
    const auto curve = stroke.lower ? line.lower : line.curve;
    if (!curve || *curve >= curves.size()) continue;
    intent::DrawnCurve drawn{curves[*curve].points, camera, stroke.points, 0, {}};
    drawn.doubt_px = intent::stroke_doubt_px(stroke.points, hand_px);
    problem.drawn.push_back(std::move(drawn));
  }
  return problem;
}

/// Takes a lid that was drawn alone for the upper lid.
void take_lone_lids(const ModelFace& face, std::span<LineRead> read) {
  for (const bool right : {false, true}) {
    const auto upper = face.curve_of(FacePart::eye, right, false);
    const auto lower = face.curve_of(FacePart::eye, right, true);
    if (!upper || !lower) continue;
    const auto is = [](std::optional<std::size_t> curve) {
      return [curve](const LineRead& line) { return line.curve == curve || line.lower == curve; };
    };
    if (std::any_of(read.begin(), read.end(), is(upper))) continue;
    for (LineRead& line : read) {
      if (line.curve == lower) line.curve = upper;
    }
  }
}

/// Labels lines that no feature's form explains by where they lie.
void take_by_place(const ModelFace& face, const Drawing& drawing, std::span<LineRead> read) {
  const FaceLayout layout = lay_out(drawing.lines, face.layout().middle, face.layout().along);
  for (std::size_t i = 0; i < read.size(); ++i) {
    const bool given = i < drawing.given.size() && drawing.given[i].has_value();
    if (read[i].curve || given) continue;
    const FaceMark& mark = layout.marks[layout.mark_of_line[i]];
    const bool lower = mark.part == FacePart::mouth && face.below_mouth(mark.middle());
    read[i].curve = face.curve_of(mark.part, mark.right, lower);
  }
}

/// Returns the labels to compare: as they are, and with each of two lips moved to its other border.
std::vector<std::vector<LineRead>> borders_of(const ModelFace& face, std::span<const LineRead> read) {
  std::vector<std::vector<LineRead>> out{{read.begin(), read.end()}};
  const auto lip = [&](const LineRead& line) { return line.curve && face.other_border(*line.curve).has_value(); };
  const auto first = std::find_if(read.begin(), read.end(), lip);
  if (std::count_if(read.begin(), read.end(), lip) != 2) return out;
  const auto second = std::find_if(first + 1, read.end(), lip);
  for (const auto& changed : {first, second}) {
    out.push_back(out.front());
    LineRead& line = out.back()[static_cast<std::size_t>(changed - read.begin())];
    line.curve = face.other_border(*line.curve);
  }
  return out;
}

}  // namespace

base::Result<rig::Pose> pose_over_face(const rig::Rig& rig, const intent::WholeModel& whole,
                                       std::span<const FeatureCurve> curves, const Drawing& drawing,
                                       DrawingRead& reading, const geometry::Camera& camera, const rig::Pose& start,
                                       std::span<const std::size_t> free) {
  // Of many lines together it is known whether they are those of the face at rest.
  const auto nothing = [](double share) { return share == 0; };
  const bool rests = std::all_of(reading.shares.begin(), reading.shares.end(), nothing);
  if (rests && drawing.lines.size() >= k_whole_face) return start;
  const std::span<LineRead> read = reading.lines;
  const auto face = ModelFace::see(rig, curves, start, camera);
  const double unit = face ? std::sqrt(geometry::dot(face->layout().along, face->layout().along)) : 0;
  const double hand_px = unit > 0 ? k_hand_over_face * unit : intent::doubt_px(camera.viewport());
  std::vector<std::vector<LineRead>> ways{{read.begin(), read.end()}};
  if (face) {
    take_by_place(*face, drawing, read);
    take_lone_lids(*face, read);
    ways = borders_of(*face, read);
  }
  intent::SolveWorkspace work;
  rig::Pose pose = start;
  double least = 0;
  bool first = true;
  for (const std::vector<LineRead>& way : ways) {
    const auto problem = problem_of(curves, drawing, way, camera, hand_px, start, free);
    if (problem.drawn.empty()) continue;
    auto solution = intent::solve(rig, whole, problem, {}, work);
    if (!solution) return solution.error();
    if (!first && solution->doubt_energy >= least) continue;
    first = false;
    least = solution->doubt_energy;
    pose = std::move(solution->pose);
    std::copy(way.begin(), way.end(), read.begin());
  }
  return pose;
}

}  // namespace penpose::portrait
