#include "core/posing/solve.h"

#include <algorithm>

#include "core/posing/clean_up.h"
#include "core/posing/curve_system.h"
#include "core/posing/finish.h"
#include "core/posing/pose_objective.h"
#include "core/posing/relevance.h"
#include "core/posing/solution_state.h"
#include "core/posing/staged_simplex.h"

namespace penpose::posing {

struct SolveWorkspace::Buffers {
  StageWorkspace stages;
  FinishWorkspace finish;
  Residuals residuals;
};

SolveWorkspace::SolveWorkspace() : buffers_(base::make_hidden<Buffers>()) {}

namespace {

/// The extent of the curves and their targets, against which a movement is small.
double size_of(CurveSystem& system, const PoseProblem& problem) {
  std::vector<ModelPoint> points(system.point_count());
  system.positions(problem.start, points);
  geometry::Box box;
  for (const ModelPoint& p : points) box.add(p);
  for (const CurvePair& pair : problem.pairs) {
    for (const ModelPoint& p : pair.target) box.add(p);
  }
  return box.diagonal();
}

}  // namespace

base::Result<Solution> solve(const rig::Rig& rig, const PoseProblem& problem, const SolveOptions& options,
                             SolveWorkspace& work) {
  if (auto status = check_problem(rig, problem); !status) return status.error();
  auto& buffers = work.buffers();
  CurveSystem system(rig, problem);
  Residuals& residuals = buffers.residuals;
  residuals.resize(system.residual_count());
  system.residuals(problem.start, residuals);

  Solution solution;
  solution.pose = problem.start;
  solution.energy_start = solution.energy = system.energy(residuals);
  solution.max_distance = system.longest(residuals);

  const Relevance relevance =
      relevant_parameters(system, problem.start, problem.free, options.relevance * size_of(system, problem));
  Variables variables = make_variables(rig, relevance.parameters, problem.start);
  solution.variables = variables.count();
  if (variables.count() == 0) return solution;

  const double near_weight =
      options.paper ? 0.0 : options.near_weight * solution.energy_start / static_cast<double>(variables.count());
  solution.linear = relevance.columns.has_value();
  LinearModel linear;
  std::unique_ptr<PoseObjective> objective;
  if (relevance.columns) {
    linear = make_linear_model(system, problem.start, variables, std::move(*relevance.columns), near_weight);
    objective = make_linear_objective(linear);
  } else {
    objective = make_general_objective(system, variables, problem.start, near_weight);
  }

  std::vector<double> u = variables.start;
  if (options.paper) {
    std::vector<std::size_t> all(u.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    objective->select(all, u);
    Residuals image(objective->image_size());
    objective->make_image(u, image);
    SimplexOptions simplex;
    simplex.adaptive = false;
    simplex.travel_tolerance = 0.05;
    simplex.max_evaluations = options.max_evaluations;
    solution.evaluations += run_simplex(*objective, simplex, u, image, buffers.stages.simplex).evaluations;
  } else {
    StageOptions stages;
    stages.max_evaluations = options.max_evaluations;
    if (solution.linear && options.finish) {
      stages.gain_tolerance = 0.05;  // the finishing takes it from there
      stages.max_sweeps = 1;
    }
    solution.evaluations += run_stages(*objective, relevance.effects, stages, u, buffers.stages).evaluations;
    if (solution.linear && options.finish) {
      solution.evaluations += finish_linear(linear, FinishOptions{}, u, buffers.finish).evaluations;
    }
  }

  const auto limit = [&](double found) {
    return found + options.clean_up * std::max(0.0, solution.energy_start - found);
  };
  std::size_t put_back = 0;
  if (solution.linear) {
    LinearSolution state(linear, u);
    put_back = clean_up(state, limit(state.energy()));
    solution.evaluations += state.evaluations();
  } else {
    GeneralSolution state(system, variables, problem.start, u);
    put_back = clean_up(state, limit(state.energy()));
    solution.evaluations += state.evaluations();
  }

  rig::Pose pose = problem.start;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t p = variables.parameter[i];
    pose[p] = u[i] == variables.start[i]
                  ? problem.start[p]
                  : std::clamp(variables.value(i, u[i]), rig.parameters()[p].minimum, rig.parameters()[p].maximum);
  }
  system.residuals(pose, residuals);
  const double energy = system.energy(residuals);
  if (energy > solution.energy_start) return solution;
  solution.put_back = put_back;
  solution.pose = std::move(pose);
  solution.energy = energy;
  solution.max_distance = system.longest(residuals);
  return solution;
}

}  // namespace penpose::posing
