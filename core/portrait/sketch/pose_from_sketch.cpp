#include "core/portrait/sketch/pose_from_sketch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/intent/solve.h"
#include "core/portrait/sketch/habits.h"
#include "core/portrait/sketch/model_face.h"

namespace penpose::portrait {
namespace {

std::vector<LineRead> lines_of(const FaceLayout& layout, const ModelFace& face) {
  std::vector<LineRead> out;
  for (const std::size_t number : layout.mark_of_line) {
    const FaceMark& mark = layout.marks[number];
    LineRead line;
    line.curve = face.curve_of(mark.part, mark.right, false);
    if (line.curve && mark.closed && mark.part != FacePart::brow)
      line.lower = face.curve_of(mark.part, mark.right, true);
    out.push_back(line);
  }
  return out;
}

/// Splits an expression into gestures: brows, eyes, the form of the mouth, its opening. Each leaves the rest of the
/// face at rest.
std::vector<Expression> parts_of(const Expression& whole) {
  Expression rest = whole;
  for (auto& brow : rest.brows) {
    if (brow) brow = Expression::Brow{};
  }
  for (auto& eye : rest.closed) {
    if (eye) eye = 0.0;
  }
  if (rest.mouth) rest.mouth = Expression::Mouth{};
  std::vector<Expression> parts(3, rest);
  parts[0].brows = whole.brows;
  parts[1].closed = whole.closed;
  parts[2].mouth = whole.mouth;
  if (whole.mouth && whole.mouth->sneered > 0) {
    parts.push_back(rest);
    parts[2].mouth->sneered = 0;
    parts.back().mouth->sneered = whole.mouth->sneered;
  }
  return parts;
}

/// Splits a mouth that takes a form and opens into the two.
std::vector<Expression> form_and_opening(const Expression& whole) {
  std::vector<Expression> parts(2, whole);
  parts[0].mouth->opened = 0;
  parts[1].mouth = Expression::Mouth{};
  parts[1].mouth->opened = whole.mouth->opened;
  return parts;
}

/// Returns by how much the mouth of a pose differs from what was drawn, in widths of the mouth.
double mouth_off(const ModelFace& rest, const std::optional<ModelFace>& posed, const Expression::Mouth& drawn) {
  constexpr double k_no_doubt = 1e-3;
  if (!posed) return 1e300;
  const Expression shown = expression_of(posed->measures(), RestingFace{rest.measures(), k_no_doubt});
  if (!shown.mouth) return 1e300;
  return std::abs(shown.mouth->corners[0] - drawn.corners[0]) + std::abs(shown.mouth->corners[1] - drawn.corners[1]) +
         std::abs(shown.mouth->widened - drawn.widened) + std::abs(shown.mouth->opened - drawn.opened);
}

/// Returns the similarity that lays the eyes of a drawing on those of the model.
Placement laid_on(const FaceLayout& model, const FaceLayout& drawn) {
  const double squared = geometry::dot(drawn.along, drawn.along);
  Placement sheet;
  sheet.along = geometry::dot(model.along, drawn.along) / squared;
  sheet.across = (drawn.along.x * model.along.y - drawn.along.y * model.along.x) / squared;
  sheet.shift = model.middle - sheet(drawn.middle);
  return sheet;
}

}  // namespace

base::Result<std::optional<SketchedPose>> pose_from_sketch(const rig::Rig& rig, const intent::WholeModel& whole,
                                                           std::span<const FeatureCurve> curves, const Drawing& drawing,
                                                           const geometry::Camera& camera, const rig::Pose& start,
                                                           std::span<const std::size_t> free) {
  const auto face = ModelFace::see(rig, curves, start, camera);
  if (!face) return std::optional<SketchedPose>{};
  auto layout = find_face(drawing.lines);
  if (!layout || layout->cost > k_most_cost) return std::optional<SketchedPose>{};
  std::optional<RestingFace> rest;
  if (!drawing.neutral.empty()) {
    if (const auto neutral = find_face(drawing.neutral)) rest = RestingFace{measure(*neutral), k_same_hand};
  } else if (drawing.in_view) {
    rest = RestingFace{face->measures(), k_over_face};
  }
  const Expression expression = expression_of(measure(*layout), rest);
  SketchedPose out{start, lines_of(*layout, *face), {}, laid_on(face->layout(), *layout), expression.rests()};
  const auto parameters = rig.parameters();
  intent::SolveWorkspace work;
  intent::SolveOptions options;
  options.weights = &inference::learned_weights();
  const auto add = [&](const Expression& part, rig::Pose& pose) -> base::Status {
    if (part.rests()) return base::Done{};
    intent::IntentProblem problem;
    problem.drawn = face->lines_of(part);
    problem.free.assign(free.begin(), free.end());
    problem.start = start;
    const auto solution = intent::solve(rig, whole, problem, options, work);
    if (!solution) return solution.error();
    for (const std::size_t p : solution->moved)
      pose[p] = std::clamp(pose[p] + solution->pose[p] - start[p], parameters[p].minimum, parameters[p].maximum);
    return base::Done{};
  };
  for (const Expression& part : parts_of(expression)) {
    if (!part.mouth || !(part.mouth->opened > 0)) {
      if (auto status = add(part, out.pose); !status) return status.error();
      continue;
    }
    // A rig has one control for both or one for each: the better pose shows which.
    std::array<rig::Pose, 2> poses{start, start};
    if (auto status = add(part, poses[0]); !status) return status.error();
    for (const Expression& one : form_and_opening(part)) {
      if (auto status = add(one, poses[1]); !status) return status.error();
    }
    std::array<double, 2> off{};
    for (std::size_t i = 0; i < 2; ++i)
      off[i] = mouth_off(*face, ModelFace::see(rig, curves, poses[i], camera), *part.mouth);
    const rig::Pose& better = poses[off[1] < off[0] ? 1 : 0];
    for (std::size_t p = 0; p < better.size(); ++p)
      out.pose[p] = std::clamp(out.pose[p] + better[p] - start[p], parameters[p].minimum, parameters[p].maximum);
  }
  out.layout = std::move(*layout);
  return std::optional<SketchedPose>(std::move(out));
}

}  // namespace penpose::portrait
