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

/// A line along shut lips is both borders of the mouth's opening.
struct Seam {
  std::size_t line = 0;
  std::size_t other = 0;  ///< the border that the line is not labelled as
};

/// Assigns a feature to each line of a drawing.
struct Way {
  std::vector<LineRead> lines;
  std::optional<Seam> seam = {};
  double cost = 0;  ///< how unlikely it is by itself
};

intent::IntentProblem problem_of(std::span<const FeatureCurve> curves, const Drawing& drawing, const Way& way,
                                 const geometry::Camera& camera, double hand_px, const rig::Pose& start,
                                 std::span<const std::size_t> free) {
  intent::IntentProblem problem;
  problem.start = start;
  problem.free.assign(free.begin(), free.end());
  for (const Stroke& stroke : strokes_of(drawing.lines, drawing.given)) {
    const LineRead& line = way.lines[stroke.lines.front()];
    const auto curve = stroke.lower ? line.lower : line.curve;
    if (!curve || *curve >= curves.size()) continue;
    intent::DrawnCurve drawn{curves[*curve].points, camera, stroke.points, 0, {}};
    drawn.doubt_px = intent::stroke_doubt_px(stroke.points, hand_px);
    if (way.seam && way.seam->line == stroke.lines.front()) {
      // Two targets of one line count as much as one.
      drawn.doubt_px *= std::sqrt(2.0);
      problem.drawn.push_back(drawn);
      drawn.reference = curves[way.seam->other].points;
    }
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

bool is_given(const Drawing& drawing, std::size_t line) {
  return line < drawing.given.size() && drawing.given[line].has_value();
}

/// Adds the ways in which each of two lips is moved to its other border.
void add_other_borders(const ModelFace& face, std::vector<Way>& ways) {
  const Way first = ways.front();
  std::vector<std::size_t> lips;
  for (std::size_t i = 0; i < first.lines.size(); ++i) {
    if (first.lines[i].curve && face.other_border(*first.lines[i].curve)) lips.push_back(i);
  }
  if (lips.size() != 2) return;
  for (const std::size_t i : lips) {
    ways.push_back(first);
    ways.back().lines[i].curve = face.other_border(*first.lines[i].curve);
  }
}

/// Adds what the only line of a mouth may be: shut lips, or a border of its opening alone.
void add_lone_mouth(const ModelFace& face, const Drawing& drawing, std::vector<Way>& ways) {
  const Way first = ways.front();
  const auto is_mouth = [&](const LineRead& line) { return line.curve && face.is_lip(*line.curve); };
  const auto mouth = std::find_if(first.lines.begin(), first.lines.end(), is_mouth);
  if (mouth == first.lines.end() || std::any_of(mouth + 1, first.lines.end(), is_mouth)) return;
  const auto line = static_cast<std::size_t>(mouth - first.lines.begin());
  if (is_given(drawing, line) || mouth->lower) return;
  const auto upper = face.curve_of(FacePart::mouth, false, false), lower = face.curve_of(FacePart::mouth, false, true);
  if (!upper || !lower) return;
  for (const auto& border : {upper, lower}) {
    if (mouth->curve == border) continue;
    ways.push_back(first);
    ways.back().lines[line].curve = border;
  }
  for (Way& way : ways) {
    const auto& border = way.lines[line].curve;
    if (border == upper || border == lower) way.cost = k_lone_border;
  }
  ways.push_back({first.lines, Seam{line, *lower}, 0});
  ways.back().lines[line].curve = upper;
}

/// Adds the brow that a lone upper lid may be, or the lid that a lone brow may be.
void add_lone_brow(const ModelFace& face, const Drawing& drawing, std::vector<Way>& ways) {
  const Way first = ways.front();
  if (first.lines.size() != 1 || is_given(drawing, 0) || first.lines[0].lower) return;
  for (const bool right : {false, true}) {
    const auto brow = face.curve_of(FacePart::brow, right, false), lid = face.curve_of(FacePart::eye, right, false);
    const auto& read = first.lines[0].curve;
    if (!brow || !lid || (read != brow && read != lid)) continue;
    ways.push_back(first);
    ways.back().lines[0].curve = read == brow ? lid : brow;
  }
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
  if (face) {
    take_by_place(*face, drawing, read);
    take_lone_lids(*face, read);
  }
  std::vector<Way> ways{{{read.begin(), read.end()}}};
  if (face) {
    add_other_borders(*face, ways);
    add_lone_mouth(*face, drawing, ways);
    add_lone_brow(*face, drawing, ways);
  }
  intent::SolveWorkspace work;
  rig::Pose pose = start;
  double least = 0;
  bool first = true;
  for (const Way& way : ways) {
    const auto problem = problem_of(curves, drawing, way, camera, hand_px, start, free);
    if (problem.drawn.empty()) continue;
    auto solution = intent::solve(rig, whole, problem, {}, work);
    if (!solution) return solution.error();
    const double energy = solution->doubt_energy + way.cost;
    if (!first && energy >= least) continue;
    first = false;
    least = energy;
    pose = std::move(solution->pose);
    std::copy(way.lines.begin(), way.lines.end(), read.begin());
  }
  return pose;
}

}  // namespace penpose::portrait
