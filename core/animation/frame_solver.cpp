#include "core/animation/frame_solver.h"

#include <algorithm>
#include <cmath>

#include "core/animation/uncertainty.h"
#include "core/curve/pairing.h"
#include "core/posing/curve_system.h"
#include "core/posing/finish.h"
#include "core/posing/pose_objective.h"
#include "core/posing/relevance.h"
#include "core/posing/staged_simplex.h"

namespace penpose::animation {
namespace {

/// How much more a frame of no trust is held near the one before, in the unit of FrameOptions::near_last.
constexpr double k_distrust = 0.2;

/// Evaluations of the simplex, a frame, that a rig may cost that is not linear.
constexpr std::size_t k_evaluations_a_variable = 100;

/// A distance of the track, px, as a distance in the model, where its points are at rest; the mean of all points.
double in_model(double px, const Transfer& transfer, std::span<const geometry::ModelPoint> at_rest,
                const geometry::Camera& camera) {
  double sum = 0;
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    sum += px * std::abs(transfer.scale[i]) * camera.units_per_px(camera.depth(at_rest[i]));
  }
  return sum / static_cast<double>(std::max<std::size_t>(at_rest.size(), 1));
}

/// Pairs of variables whose movements away from rest, as seen, undo each other. `told`: seen_information.
std::vector<posing::Opposed> opposed_pairs(std::span<const double> told, std::span<const double> rest_u) {
  constexpr double k_cosine = -0.8;
  constexpr double k_share = 0.5;
  const std::size_t n = rest_u.size();
  std::vector<posing::Opposed> pairs;
  std::vector<std::size_t> count(n, 0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const bool to_one_side = (rest_u[a] > 0.5) == (rest_u[b] > 0.5);
      const double both = told[a * n + a] * told[b * n + b];
      if (!to_one_side || !(both > 0) || !(told[a * n + b] <= k_cosine * std::sqrt(both))) continue;
      pairs.push_back({a, b, k_share});
      ++count[a];
      ++count[b];
    }
  }
  for (posing::Opposed& pair : pairs) pair.share /= static_cast<double>(std::max(count[pair.a], count[pair.b]));
  return pairs;
}

}  // namespace

struct FrameSolver::State {
  State(const rig::Rig& r, Transfer t, const geometry::Camera& c, const posing::PoseProblem& problem)
      : rig(r), transfer(std::move(t)), camera(c), system(rig, problem) {}

  const rig::Rig& rig;
  Transfer transfer;
  geometry::Camera camera;
  posing::CurveSystem system;
  FrameOptions options;
  posing::Relevance relevance;
  bool linear = false;
  posing::LinearModel model;                 ///< where the rig is not linear, its variables and the pull alone
  posing::Residuals points_at_zero;          ///< positions of the curve points at u = 0, laid out as residuals
  std::vector<geometry::ModelVector> sight;  ///< from the eye to each point at rest, length one
  double extent = 0;                         ///< diagonal of the box around the points at rest
  double pull_unit = 0;                      ///< energy of moving every point by a tenth of the curves' extent
  std::vector<double> rest_u;
  std::vector<double> u;
  rig::Pose pose;
  std::vector<geometry::PxPoint> targets;
  std::vector<geometry::ModelPoint> now;
  posing::StageWorkspace stages;
  posing::FinishWorkspace finish;

  void aim(std::size_t point, const geometry::ModelPoint& target, double weight) {
    system.set_target(point, target);
    system.set_weight(point, weight);
    if (!linear) return;
    model.weights[point] = weight;
    geometry::ModelVector apart;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int a = static_cast<int>(axis);
      apart[a] = points_at_zero[posing::residual_index(point, axis)] - target[a];
    }
    apart = seen_part(apart, point);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      model.at_zero[posing::residual_index(point, axis)] = apart[static_cast<int>(axis)];
    }
  }

  /// A movement without what goes along the line of sight.
  [[nodiscard]] geometry::ModelVector seen_part(const geometry::ModelVector& v, std::size_t point) const {
    const geometry::ModelVector& d = sight[point];
    return v - d * (v.x * d.x + v.y * d.y + v.z * d.z);
  }

  /// A video says nothing of depth, so that movements along the line of sight cost nothing: the model's columns are
  /// freed of them.
  void look_along_sight() {
    for (posing::Column& column : model.columns) {
      posing::Residuals values = column.values();
      for (std::size_t point = 0; point < sight.size(); ++point) {
        geometry::ModelVector v;
        for (std::size_t axis = 0; axis < 3; ++axis)
          v[static_cast<int>(axis)] = values[posing::residual_index(point, axis)];
        v = seen_part(v, point);
        for (std::size_t axis = 0; axis < 3; ++axis)
          values[posing::residual_index(point, axis)] = v[static_cast<int>(axis)];
      }
      column = posing::Column(std::move(values));
    }
  }

  /// Lets points that meet others go beyond their targets by what those fell short of. False: there are none.
  bool take_over(double confidence) {
    bool any = false;
    system.positions(pose, now);
    const auto short_of = [&](std::size_t point) {
      const auto px = camera.project(now[point]);
      return px ? targets[point] - *px : geometry::PxPoint{};
    };
    for (std::size_t i = 0; i < transfer.meetings.size(); ++i) {
      const Meeting& m = transfer.meetings[i];
      if (!(m.takes_over > 0)) continue;
      const geometry::PxPoint rest = short_of(m.across[0]) * (1.0 - m.between) + short_of(m.across[1]) * m.between;
      aim(i, curve::lift(targets[i] - rest * m.takes_over, now[i], camera), transfer.weights[i] * confidence);
      any = true;
    }
    return any;
  }

  void solve(double confidence) {
    // Two pulls to two places are one pull to the place between them. A frame of no trust tells no more of rest than
    // of anything else.
    const double near_rest = options.near_rest * confidence;
    const double near_last = options.near_last + k_distrust * (1.0 - confidence) * (1.0 - confidence);
    const double both = near_last + near_rest;
    model.near_weight = pull_unit * both;
    model.variables.opposed_weight = both > 0 ? near_rest / both : 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      model.variables.start[i] = both > 0 ? (near_last * u[i] + near_rest * rest_u[i]) / both : u[i];
    }
    posing::StageOptions search;
    search.first_step = 0.06;
    search.max_sweeps = 1;
    search.gain_tolerance = 0.02;
    search.max_evaluations = options.max_evaluations;
    // Without finishing the simplex has to come to the last of its stages by itself.
    if (!linear) search.max_evaluations = std::max(search.max_evaluations, k_evaluations_a_variable * u.size());
    const auto objective = linear ? posing::make_linear_objective(model)
                                  : posing::make_general_objective(system, model.variables, pose, model.near_weight);
    posing::run_stages(*objective, relevance.effects, search, u, stages);
    if (linear) {
      posing::FinishOptions finishing;
      finishing.max_iterations = options.max_finish_iterations;
      finishing.gain_tolerance = 1e-4;
      posing::finish_linear(model, finishing, u, finish);
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      const std::size_t p = model.variables.parameter[i];
      const rig::Parameter& range = rig.parameters()[p];
      pose[p] = std::clamp(model.variables.value(i, u[i]), range.minimum, range.maximum);
    }
  }
};

FrameSolver::FrameSolver(std::unique_ptr<State> state) : state_(std::move(state)) {}
FrameSolver::~FrameSolver() = default;
FrameSolver::FrameSolver(FrameSolver&&) noexcept = default;
FrameSolver& FrameSolver::operator=(FrameSolver&&) noexcept = default;

base::Result<FrameSolver> FrameSolver::make(const rig::Rig& rig, Transfer transfer, std::vector<std::size_t> free,
                                            rig::Pose rest, const geometry::Camera& camera,
                                            const FrameOptions& options) {
  posing::PoseProblem problem;
  const std::size_t n = transfer.points.size();
  // Targets follow with the frames; until then every point is aimed at the model's origin.
  problem.pairs.push_back({transfer.points, std::vector<geometry::ModelPoint>(n, geometry::ModelPoint(0)), {}});
  problem.free = std::move(free);
  problem.start = std::move(rest);
  if (auto status = posing::check_problem(rig, problem); !status) return status.error();
  auto state = std::make_unique<State>(rig, std::move(transfer), camera, problem);
  State& s = *state;
  s.options = options;
  s.pose = problem.start;
  s.now.resize(n);
  s.targets.resize(n);
  s.system.positions(s.pose, s.now);
  s.system.set_softness(in_model(options.tremor_px, s.transfer, s.now, camera));
  geometry::Box box;
  for (const auto& p : s.now) box.add(p);
  s.relevance = posing::relevant_parameters(s.system, s.pose, problem.free, options.relevance * box.diagonal());
  // What is searched at once stands in tables of all controls against all.
  constexpr std::size_t k_most_controls = 2000;
  if (s.relevance.parameters.size() > k_most_controls) {
    return base::Error{"the curves may move " + std::to_string(s.relevance.parameters.size()) +
                           " controls, and no more than 2000 are searched at once",
                       "", "use a model with fewer controls"};
  }
  posing::Variables variables = posing::make_variables(rig, s.relevance.parameters, s.pose);
  s.u = s.rest_u = variables.opposed_from = variables.start;
  variables.opposed =
      opposed_pairs(seen_information(rig, s.pose, variables.parameter, s.transfer, camera, 1.0), s.rest_u);
  double weight = 0;
  for (const double w : s.transfer.weights) weight += w;
  s.extent = box.diagonal();
  s.pull_unit = 0.1 * s.extent * weight;
  s.linear = s.relevance.columns.has_value();
  if (s.linear) {
    s.model = posing::make_linear_model(s.system, s.pose, std::move(variables), std::move(*s.relevance.columns), 0);
    s.points_at_zero = s.model.at_zero;
    for (const auto& p : s.now) s.sight.push_back(geometry::normalized(p - camera.eye()));
    s.look_along_sight();
  } else {
    s.model.variables = std::move(variables);
  }
  return FrameSolver(std::move(state));
}

const rig::Pose& FrameSolver::follow(std::span<const PxPoint> offsets, double doubt, double confidence) {
  State& s = *state_;
  if (s.u.empty()) return s.pose;
  target_places(s.transfer, offsets, doubt, s.targets);
  s.system.positions(s.pose, s.now);
  for (std::size_t i = 0; i < s.targets.size(); ++i) {
    s.aim(i, curve::lift(s.targets[i], s.now[i], s.camera), s.transfer.weights[i] * confidence);
  }
  const std::vector<double> before = s.u;
  s.solve(confidence);
  if (s.take_over(confidence)) {
    s.u = before;
    s.solve(confidence);
  }
  return s.pose;
}

const rig::Pose& FrameSolver::pose() const { return state_->pose; }
std::span<const std::size_t> FrameSolver::parameters() const { return state_->relevance.parameters; }

}  // namespace penpose::animation
