#include "core/document/drawing/pose_problem.h"

#include <algorithm>

#include "core/document/commands/apply.h"
#include "core/document/drawing/moment.h"

namespace penpose::document {
namespace {

/// A pen on a tablet strays less than a usual hand, by this.
constexpr double k_pen = 0.9;

std::vector<std::size_t> free_parameters(const Document& document) {
  std::vector<std::size_t> free;
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!std::binary_search(document.locked.begin(), document.locked.end(), parameters[i].name)) free.push_back(i);
  }
  return free;
}

bool is_known(const PoseCurve& curve) { return curve.target && curve.target->line.empty(); }

/// How many of the oldest targets are left out, so that `most` stay; those that are known are not counted.
std::ptrdiff_t left_out(const Document& document, std::size_t most) {
  const auto paired = std::count_if(document.curves.begin(), document.curves.end(),
                                    [](const auto& curve) { return curve->target && !is_known(*curve); });
  return std::max<std::ptrdiff_t>(0, paired - static_cast<std::ptrdiff_t>(most));
}

}  // namespace

std::vector<posing::CurvePoint> curve_points(const Document& document, const std::vector<mesh::MeshPoint>& points) {
  std::vector<posing::CurvePoint> out;
  for (const mesh::MeshPoint& point : points) {
    out.push_back(posing::at_mesh_point(point, document.model->mesh->triangles()));
  }
  return out;
}

posing::PoseProblem pose_problem(const Document& document) {
  posing::PoseProblem problem;
  problem.start = document.pose;
  problem.free = free_parameters(document);
  auto skip = left_out(document, k_most_pairs);
  for (const auto& curve : document.curves) {
    if (curve->target && !is_known(*curve) && skip-- > 0) continue;
    if (curve->role == PoseCurveRole::constraint) {
      problem.constraints.push_back({curve_points(document, curve->points), curve->kept});
    } else if (curve->target) {
      problem.pairs.push_back({curve_points(document, curve->points), curve->target->points,
                               document.pressure_weighting ? curve->target->weights : std::vector<double>()});
    }
  }
  return problem;
}

double hand_px(const Document& document, geometry::Viewport viewport) {
  return k_pen * document.hand * intent::doubt_px(viewport);
}

namespace {

/// Returns, for each parameter, what the artist's choices add to the cost of moving it. A choice lowers the cost of the
/// controls that it took and raises the cost of those that it did not take, in equal parts.
std::vector<double> taught_by_choices(const Document& document) {
  const auto parameters = document.model->rig->parameters();
  std::vector<double> taught(parameters.size(), 0.0);
  const auto add = [&](const std::vector<std::string>& names, double by) {
    for (const std::string& name : names) {
      if (const auto number = rig::find_parameter(parameters, name)) taught[*number] += by;
    }
  };
  for (const TakenReading& one : *document.taken) {
    const double share = one.by / static_cast<double>(one.taken.size() + one.instead_of.size());
    add(one.taken, -share);
    add(one.instead_of, share);
  }
  return taught;
}

/// What does not depend on the curves: where it starts, what is free and what is locked.
intent::IntentProblem problem_without_curves(const Document& document) {
  intent::IntentProblem problem;
  problem.start = document.pose;
  problem.free = free_parameters(document);
  for (std::size_t i = 0, k = 0; i < problem.start.size(); ++i) {
    const bool free = k < problem.free.size() && problem.free[k] == i;
    k += free ? 1U : 0U;
    if (!free) problem.locked.push_back(i);
  }
  if (document.taken) problem.taught = taught_by_choices(document);
  return problem;
}

/// A target as what its line asks for, unless its view cannot be or does not see the reference. `doubt`: becomes the
/// hand's there, model units.
std::optional<intent::DrawnCurve> drawn_curve(const Document& document, const PoseCurve& curve, double& doubt) {
  const auto camera = geometry::Camera::make(curve.target->view.camera, curve.target->view.viewport);
  if (!camera) return std::nullopt;
  const auto positions = positions_of(document, curve.points);
  const bool seen =
      std::all_of(positions.begin(), positions.end(), [&](const auto& p) { return camera->project(p).has_value(); });
  if (!seen) return std::nullopt;
  const double hand = hand_px(document, camera->viewport());
  intent::DrawnCurve drawn{curve_points(document, curve.points),
                           *camera,
                           curve.target->line,
                           intent::stroke_doubt_px(curve.target->line, hand),
                           {}};
  drawn.aside = curve.aside;
  if (document.pressure_weighting) drawn.weights = curve.target->weights;
  doubt = hand * camera->units_per_px(camera->depth(positions.front()));
  return drawn;
}

void add_kept(const Document& document, double doubt, intent::IntentProblem& problem) {
  for (const auto& curve : document.curves) {
    if (curve->role == PoseCurveRole::constraint)
      problem.kept.push_back({curve_points(document, curve->points), curve->kept, doubt});
  }
}

/// The doubt of the latest view, for what has no picture of its own.
double usual_doubt(const Document& document) { return 1e-3 * rest_world_box(*document.model).diagonal(); }

/// Targets of which it is known where each point goes. Beside no drawn line, `doubt` becomes that of a hand that would
/// have drawn them.
void add_known(const Document& document, double& doubt, intent::IntentProblem& problem) {
  if (std::none_of(document.curves.begin(), document.curves.end(), [](const auto& one) { return is_known(*one); }))
    return;
  Document at_rest = document;
  at_rest.pose = rig::rest_pose(*document.model->rig);
  geometry::Box box;
  for (const auto& curve : document.curves) {
    if (!is_known(*curve)) continue;
    for (const auto& p : positions_of(at_rest, curve->points)) box.add(p);
  }
  // Nobody draws one short line on a picture of nothing else.
  const double hand = k_hand_share * std::max(box.diagonal(), 0.15 * rest_box_of_shapes(*document.model).diagonal());
  if (problem.drawn.empty()) doubt = hand;
  for (const auto& curve : document.curves) {
    if (is_known(*curve))
      problem.known.push_back(
          {curve_points(document, curve->points), curve->target->points, hand * (k_known_share / k_hand_share)});
  }
}

}  // namespace

intent::IntentProblem intent_problem(const Document& document) {
  intent::IntentProblem problem = problem_without_curves(document);
  auto skip = left_out(document, k_most_meant);
  double doubt = usual_doubt(document);
  for (const auto& curve : document.curves) {
    if (!curve->target || is_known(*curve) || skip-- > 0) continue;
    if (auto drawn = drawn_curve(document, *curve, doubt)) problem.drawn.push_back(std::move(*drawn));
  }
  add_known(document, doubt, problem);
  add_kept(document, doubt, problem);
  return problem;
}

intent::IntentProblem moment_problem(const Document& document, const Moment& moment) {
  Document base = document;
  base.pose = moment.base;
  intent::IntentProblem problem = problem_without_curves(base);
  problem.posed = document.pose;
  const std::vector<CurveId> anew = drawn_anew(moment);
  double doubt = usual_doubt(document);
  const std::size_t oldest = moment.lines.size() - std::min(moment.lines.size(), k_most_meant);
  for (std::size_t l = oldest; l < moment.lines.size(); ++l) {
    const Moment::Line& line = moment.lines[l];
    if (std::find(anew.begin(), anew.end(), line.curve) != anew.end()) continue;
    auto drawn = drawn_curve(base, *find_curve(document, line.curve), doubt);
    if (!drawn) continue;
    drawn->before = l + 1 < moment.lines.size();
    if (!line.held.empty()) drawn->target = line.held;
    if (!line.covered.empty()) {
      if (drawn->weights.empty()) drawn->weights.assign(line.covered.size(), 1.0);
      for (std::size_t i = 0; i < line.covered.size(); ++i) {
        if (line.covered[i]) drawn->weights[i] = 0.0;
      }
    }
    problem.drawn.push_back(std::move(*drawn));
  }
  add_known(document, doubt, problem);
  add_kept(document, doubt, problem);
  return problem;
}

}  // namespace penpose::document
