#include "ui/cli/case_problem.h"

#include <algorithm>
#include <numeric>

#include "core/curve/pairing.h"

namespace penpose::cli {
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

}  // namespace

geometry::Camera case_camera(const document::Model& model, const model_io::PoseCase& pose_case) {
  return geometry::frame_box(document::rest_world_box(model), {1000, 1000}, pose_case.view_yaw_degrees);
}

base::Result<posing::PoseProblem> problem_of_case(const document::Model& model, const model_io::PoseCase& pose_case,
                                                  FreeSet free, model_io::TargetForm form) {
  posing::PoseProblem problem;
  problem.start = rig::rest_pose(*model.rig);
  std::vector<geometry::ModelPoint> rest(model.mesh->vertex_count());
  model.rig->evaluate(problem.start, rest);
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
    if (form == model_io::TargetForm::drawn) {
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

  if (free == FreeSet::all || pose_case.free.empty()) {
    problem.free.resize(problem.start.size());
    std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
  } else {
    for (const std::string& name : pose_case.free) {
      const auto found = rig::find_parameter(model.rig->parameters(), name);
      if (!found) return base::Error{"the model has no parameter \"" + name + "\"", "", "choose another name"};
      problem.free.push_back(*found);
    }
    std::sort(problem.free.begin(), problem.free.end());
    problem.free.erase(std::unique(problem.free.begin(), problem.free.end()), problem.free.end());
  }
  // What is searched at once stands in tables of all controls against all.
  constexpr std::size_t k_most_controls = 2000;
  if (problem.free.size() > k_most_controls) {
    return base::Error{std::to_string(problem.free.size()) + " controls are free, and no more than 2000 are searched",
                       "case " + pose_case.name, "name those that may move under \"free\" and use --free case"};
  }
  return problem;
}

}  // namespace penpose::cli
