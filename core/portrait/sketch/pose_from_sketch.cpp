#include "core/portrait/sketch/pose_from_sketch.h"

#include <algorithm>

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
  // A mouth that smiles or narrows and opens does two things.
  const bool smiles = whole.mouth && (whole.mouth->corners[0] > 0 || whole.mouth->corners[1] > 0);
  const bool narrows = whole.mouth && whole.mouth->widened < 0;
  if ((smiles || narrows) && whole.mouth->opened > 0) {
    parts.push_back(rest);
    parts[2].mouth->opened = 0;
    parts.back().mouth->opened = whole.mouth->opened;
  }
  return parts;
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
  for (const Expression& part : parts_of(expression)) {
    if (part.rests()) continue;
    intent::IntentProblem problem;
    problem.drawn = face->lines_of(part);
    problem.free.assign(free.begin(), free.end());
    problem.start = start;
    const auto solution = intent::solve(rig, whole, problem, options, work);
    if (!solution) return solution.error();
    for (const std::size_t p : solution->moved)
      out.pose[p] =
          std::clamp(out.pose[p] + solution->pose[p] - start[p], parameters[p].minimum, parameters[p].maximum);
  }
  out.layout = std::move(*layout);
  return std::optional<SketchedPose>(std::move(out));
}

}  // namespace penpose::portrait
