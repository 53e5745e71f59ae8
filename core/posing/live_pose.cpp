#include "core/posing/live_pose.h"

#include <algorithm>
#include <cmath>

#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/posing/curve_system.h"
#include "core/posing/finish.h"
#include "core/posing/pose_objective.h"
#include "core/posing/relevance.h"
#include "core/posing/staged_simplex.h"

namespace penpose::posing {

struct LivePoser::State {
  State(const rig::Rig& r, LiveSetup s, const PoseProblem& problem)
      : rig(r), setup(std::move(s)), system(rig, problem) {}

  const rig::Rig& rig;
  LiveSetup setup;
  CurveSystem system;
  Relevance relevance;
  Variables variables;
  bool linear = false;
  LinearModel model;
  Residuals points_at_zero;             ///< positions of all curve points at u = 0, laid out as residuals
  std::vector<ModelPoint> at_start;     ///< reference points before the stroke: they give the distances for lifting
  std::vector<geometry::PxPoint> seen;  ///< the same on the image plane
  std::vector<double> along;            ///< length in px from the reference's start to each point
  std::vector<double> u;
  rig::Pose pose;
  std::vector<double> lengths;
  StageWorkspace stages;
  FinishWorkspace finish;
  Residuals residuals;

  void aim(std::size_t point, const ModelPoint& target) {
    system.set_target(point, target);
    for (std::size_t axis = 0; linear && axis < 3; ++axis) {
      const std::size_t i = residual_index(point, axis);
      model.at_zero[i] = points_at_zero[i] - target[static_cast<int>(axis)];
    }
  }
  void weigh(std::size_t point, double weight) {
    system.set_weight(point, weight);
    if (linear) model.weights[point] = weight;
  }

  /// Matches the drawn part with the reference's beginning (or its end, where the drawing runs the other way). Returns
  /// how many reference points have a target.
  std::size_t match(std::span<const geometry::PxPoint> target) {
    lengths = curve::cumulative_length(target);
    const double drawn = lengths.back();
    const double whole = along.back();
    const std::size_t n = along.size();
    const bool backwards =
        geometry::distance(target.front(), seen.back()) < geometry::distance(target.front(), seen.front());
    const double stretch = std::max(1.0, drawn / whole);
    std::size_t matched = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = backwards ? n - 1 - k : k;
      const double from_start = (backwards ? whole - along[i] : along[i]) * stretch;
      const bool reached = from_start <= drawn;
      weigh(i, reached ? 1.0 : 0.0);
      if (!reached) continue;
      ++matched;
      const auto place = curve::place_at(lengths, std::min(1.0, from_start / drawn));
      const geometry::PxPoint px =
          target[place.segment] * (1.0 - place.fraction) + target[place.segment + 1] * place.fraction;
      aim(i, curve::lift(px, at_start[i], setup.camera));
    }
    return matched;
  }

  void solve(LiveStep& step) {
    StageOptions options;
    options.first_step = 0.06;
    options.max_sweeps = 1;
    options.gain_tolerance = 0.02;
    options.max_evaluations = setup.options.max_evaluations;
    std::unique_ptr<PoseObjective> objective =
        linear ? make_linear_objective(model)
               : make_general_objective(system, variables, setup.start, model.near_weight);
    step.evaluations += run_stages(*objective, relevance.effects, options, u, stages).evaluations;
    if (linear) {
      FinishOptions finishing;
      finishing.max_iterations = setup.options.max_finish_iterations;
      finishing.gain_tolerance = 1e-3;
      step.evaluations += finish_linear(model, finishing, u, finish).evaluations;
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      const rig::Parameter& parameter = rig.parameters()[variables.parameter[i]];
      pose[variables.parameter[i]] = std::clamp(variables.value(i, u[i]), parameter.minimum, parameter.maximum);
    }
    residuals.resize(system.residual_count());
    system.residuals(pose, residuals);
    step.energy = system.energy(residuals);
  }
};

namespace {

PoseProblem problem_of(const LiveSetup& setup) {
  PoseProblem problem;
  // Targets and weights follow with the pen; until then each point is its own target at the model's origin.
  problem.pairs.push_back({setup.reference, std::vector<ModelPoint>(setup.reference.size(), ModelPoint{0}), {}});
  problem.constraints = setup.constraints;
  problem.free = setup.free;
  problem.start = setup.start;
  return problem;
}

}  // namespace

LivePoser::LivePoser(std::unique_ptr<State> state) : state_(std::move(state)) {}
LivePoser::~LivePoser() = default;
LivePoser::LivePoser(LivePoser&&) noexcept = default;
LivePoser& LivePoser::operator=(LivePoser&&) noexcept = default;

base::Result<LivePoser> LivePoser::start(const rig::Rig& rig, LiveSetup setup) {
  const PoseProblem problem = problem_of(setup);
  if (auto status = check_problem(rig, problem); !status) return status.error();
  auto state = std::make_unique<State>(rig, std::move(setup), problem);
  State& s = *state;
  const std::size_t n = s.setup.reference.size();
  s.pose = s.setup.start;

  std::vector<ModelPoint> positions(s.system.point_count());
  s.system.positions(s.pose, positions);
  s.at_start.assign(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(n));
  geometry::Box box;
  for (const ModelPoint& p : s.at_start) {
    const auto px = s.setup.camera.project(p);
    if (!px)
      return base::Error{"the reference curve lies behind the camera", "", "turn the view so that it is visible"};
    s.seen.push_back(*px);
    box.add(p);
  }
  s.along = curve::cumulative_length<geometry::PxPoint>(s.seen);
  if (n < 2 || !(s.along.back() > 0.0)) {
    return base::Error{"the reference curve has no length in this view", "",
                       "turn the view so that the curve is visible"};
  }

  s.relevance = relevant_parameters(s.system, s.pose, s.setup.free, s.setup.options.relevance * box.diagonal());
  s.variables = make_variables(rig, s.relevance.parameters, s.pose);
  s.u = s.variables.start;
  s.linear = s.relevance.columns.has_value();
  // The scale of the energy is not known before the target is; a pull that moves each point by a tenth of the curve is
  // typical.
  s.model.near_weight = s.setup.options.near_weight * 0.1 * box.diagonal() * static_cast<double>(n) /
                        std::max(1.0, static_cast<double>(s.u.size()));
  if (s.linear) {
    s.model = make_linear_model(s.system, s.pose, s.variables, std::move(*s.relevance.columns), s.model.near_weight);
    s.points_at_zero =
        s.model.at_zero;  // targets of the reference are zero here; those of the constraints stay subtracted
  }
  for (std::size_t i = 0; i < n; ++i) s.weigh(i, 0.0);
  return LivePoser(std::move(state));
}

LiveStep LivePoser::follow(std::span<const geometry::PxPoint> target) {
  LiveStep step;
  State& s = *state_;
  if (target.size() < 2 || s.variables.count() == 0) return step;
  const double drawn = curve::arc_length(target);
  if (!(drawn > 0.0) || !std::isfinite(drawn)) return step;
  step.matched = s.match(target);
  s.solve(step);
  return step;
}

LiveStep LivePoser::follow_points(std::span<const geometry::ModelPoint> targets, std::span<const double> weights) {
  LiveStep step;
  State& s = *state_;
  const bool fits = targets.size() == s.along.size() && (weights.empty() || weights.size() == targets.size());
  if (!fits || s.variables.count() == 0) return step;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    s.weigh(i, weights.empty() ? 1.0 : weights[i]);
    s.aim(i, targets[i]);
  }
  step.matched = targets.size();
  s.solve(step);
  return step;
}

const rig::Pose& LivePoser::pose() const { return state_->pose; }
std::size_t LivePoser::variables() const { return state_->variables.count(); }

}  // namespace penpose::posing
