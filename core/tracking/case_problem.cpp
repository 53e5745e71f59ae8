#include "core/tracking/case_problem.h"

#include <algorithm>
#include <numeric>

#include "core/curve/pairing.h"

namespace penpose::tracking {
namespace {

base::Result<std::vector<geometry::ModelPoint>> drawn_target(std::span<const geometry::ModelPoint> reference,
                                                             std::span<const geometry::ModelPoint> target,
                                                             const geometry::Camera& camera) {
  std::vector<geometry::PxPoint> line;
  for (const auto& p : target) {
    const auto px = camera.project(p);
    if (!px) return base::Error{"the target lies behind the camera", "", "choose another view_yaw_degrees"};
    line.push_back(*px);
  }
  auto paired = curve::pair_target(reference, line, camera);
  if (!paired) return paired.error();
  return std::move(paired->points);
}

/// The parameters of these names, ascending, each once.
base::Result<std::vector<std::size_t>> parameters_named(const document::Model& model,
                                                        const std::vector<std::string>& names) {
  std::vector<std::size_t> found;
  for (const std::string& name : names) {
    const auto one = rig::find_parameter(model.rig->parameters(), name);
    if (!one) return base::Error{"the model has no parameter \"" + name + "\"", "", "choose another name"};
    found.push_back(*one);
  }
  std::stable_sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Ascending, each once; without what is locked.
base::Result<std::vector<std::size_t>> free_of_case(const document::Model& model, const io::PoseCase& pose_case,
                                                    FreeSet set) {
  std::vector<std::size_t> free;
  if (set == FreeSet::all || pose_case.free.empty()) {
    free.resize(model.rig->parameters().size());
    std::iota(free.begin(), free.end(), std::size_t{0});
  } else {
    auto named = parameters_named(model, pose_case.free);
    if (!named) return named.error();
    free = std::move(named).value();
  }
  const auto locked = parameters_named(model, pose_case.locked);
  if (!locked) return locked.error();
  std::erase_if(free, [&](std::size_t i) { return std::binary_search(locked->begin(), locked->end(), i); });
  // What is searched at once stands in tables of all controls against all.
  constexpr std::size_t k_most_controls = 2000;
  if (free.size() > k_most_controls) {
    return base::Error{std::to_string(free.size()) + " controls are free, and no more than 2000 are searched",
                       "case " + pose_case.name, "name those that may move under \"free\" and use --free case"};
  }
  return free;
}

std::vector<geometry::ModelPoint> positions_at(const document::Model& model, const rig::Pose& pose) {
  std::vector<geometry::ModelPoint> positions(model.mesh->vertex_count());
  model.rig->evaluate(pose, positions);
  return positions;
}

/// Where a case begins: what may move is at rest, all else as the model stands, such as a shape of the body that its
/// file has at some weight.
rig::Pose start_of_case(const document::Model& model, std::span<const std::size_t> free) {
  const rig::Pose rest = rig::rest_pose(*model.rig);
  rig::Pose start = model.pose;
  for (const std::size_t i : free) start[i] = rest[i];
  return start;
}

/// Where a target that is known goes is exact but for what files round; as a share of what is drawn.
constexpr double k_exact = 5e-4;
/// A hand strays by this share of what its view shows (2.1 of 700 px).
constexpr double k_hand = 3.0e-3;

}  // namespace

geometry::Camera case_camera(const document::Model& model, const io::PoseCase& pose_case) {
  return geometry::frame_box(document::rest_world_box(model), {1000, 1000}, pose_case.view_yaw_degrees);
}

base::Result<posing::PoseProblem> problem_of_case(const document::Model& model, const io::PoseCase& pose_case,
                                                  FreeSet free, io::TargetForm form) {
  posing::PoseProblem problem;
  auto freed = free_of_case(model, pose_case, free);
  if (!freed) return freed.error();
  problem.free = std::move(freed).value();
  problem.start = start_of_case(model, problem.free);
  const std::vector<geometry::ModelPoint> rest = positions_at(model, problem.start);
  const geometry::Camera camera = case_camera(model, pose_case);

  for (std::size_t r = 0; r < pose_case.references.size(); ++r) {
    const auto& reference = pose_case.references[r];
    posing::CurvePair pair;
    std::vector<geometry::ModelPoint> positions;
    for (const std::uint32_t v : reference.vertices) {
      pair.reference.push_back(posing::at_vertex(v));
      positions.push_back(rest[v]);
    }
    pair.target = reference.target;
    if (form == io::TargetForm::drawn) {
      auto target = drawn_target(positions, reference.target, camera);
      if (!target) {
        base::Error error = target.error();
        error.place = "case " + pose_case.name + ", reference " + std::to_string(r);
        return error;
      }
      pair.target = std::move(target).value();
    }
    problem.pairs.push_back(std::move(pair));
  }
  for (const auto& constraint : pose_case.constraints) {
    posing::Constraint kept;
    for (const std::uint32_t v : constraint.vertices) {
      kept.points.push_back(posing::at_vertex(v));
      kept.positions.push_back(rest[v]);
    }
    problem.constraints.push_back(std::move(kept));
  }
  return problem;
}

double hand_doubt(const document::Model& model, const io::CaseFile& file) {
  const auto rest = positions_at(model, rig::rest_pose(*model.rig));
  geometry::Box box;
  for (const io::PoseCase& pose_case : file.cases) {
    for (const auto& reference : pose_case.references) {
      for (const std::uint32_t v : reference.vertices) box.add(rest[v]);
    }
  }
  // Nobody draws one short line on a picture of nothing else.
  const double least = 0.15 * document::rest_box_of_shapes(model).diagonal();
  return k_hand * std::max(box.empty() ? 0.0 : box.diagonal(), least);
}

base::Result<intent::IntentProblem> intent_of_case(const document::Model& model, const io::PoseCase& pose_case,
                                                   FreeSet free, io::TargetForm form, double doubt) {
  intent::IntentProblem problem;
  auto freed = free_of_case(model, pose_case, free);
  if (!freed) return freed.error();
  problem.free = std::move(freed).value();
  problem.start = start_of_case(model, problem.free);
  auto locked = parameters_named(model, pose_case.locked);
  if (!locked) return locked.error();
  problem.locked = std::move(locked).value();
  const auto rest = positions_at(model, problem.start);
  const geometry::Box box = document::rest_world_box(model);
  const auto points = [](const std::vector<std::uint32_t>& vertices) {
    std::vector<posing::CurvePoint> out;
    for (const std::uint32_t v : vertices) out.push_back(posing::at_vertex(v));
    return out;
  };
  // Every point of a drawn line is held against its whole reference, again and again while the pose is searched.
  constexpr std::size_t k_most_matches = 4'000'000;
  std::size_t matches = 0;
  for (const auto& reference : pose_case.references) {
    matches += form == io::TargetForm::drawn ? reference.vertices.size() * reference.target.size() : 0;
    if (matches > k_most_matches) {
      return base::Error{"the lines are too fine: over 4,000,000 vertices times points of their targets",
                         "case " + pose_case.name, "list fewer vertices and points along the curves"};
    }
    if (form == io::TargetForm::points) {
      problem.known.push_back({points(reference.vertices), reference.target, doubt * (k_exact / k_hand)});
      continue;
    }
    const io::CaseView view = reference.view.value_or(io::CaseView{pose_case.view_yaw_degrees, 0});
    const auto camera = geometry::frame_box(box, {1000, 1000}, view.yaw_degrees, view.pitch_degrees, 1.0);
    intent::DrawnCurve curve{points(reference.vertices), camera, {}, 1.0, {}};
    for (const auto& p : reference.target)
      curve.target.push_back(camera.project(p).value_or(geometry::PxPoint{1e9, 0}));
    const double hand_px = doubt / camera.units_per_px(camera.depth(rest[reference.vertices.front()]));
    curve.doubt_px = intent::stroke_doubt_px(curve.target, hand_px);
    problem.drawn.push_back(std::move(curve));
  }
  for (const auto& constraint : pose_case.constraints) {
    intent::KnownCurve kept{points(constraint.vertices), {}, doubt};
    for (const std::uint32_t v : constraint.vertices) kept.target.push_back(rest[v]);
    problem.kept.push_back(std::move(kept));
  }
  return problem;
}

}  // namespace penpose::tracking
