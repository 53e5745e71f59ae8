#include "core/animation/solve/frame_solver.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/statistics.h"
#include "core/animation/solve/sparse_fit.h"
#include "core/animation/solve/uncertainty.h"
#include "core/curve/pairing.h"
#include "core/posing/curve_system.h"
#include "core/posing/pose_objective.h"
#include "core/posing/relevance.h"
#include "core/posing/staged_simplex.h"

namespace penpose::animation {
namespace {
/// How much less the mouth's points say of where it is in a frame whose head is all in doubt; how far open it is, they
/// say as well as ever.
constexpr double k_lips_in_doubt = 0.9;

/// How much more a frame of no trust is held near the one before, in the unit of FrameOptions::near_last.
constexpr double k_distrust = 0.2;

/// What leaving rest by the whole range costs, in units of FrameOptions::near_rest.
constexpr double k_leave = 2.5;

/// Weight of what lies between two points that touch, beside the sum of theirs.
constexpr double k_contact = 1.5;

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

/// How much of the whole model each control moves for what it moves of the curves' points, as a multiple of the median:
/// what barely touches the curves is a poor reading of them. Linear rigs.
/// `columns`: two numbers a point, one run of `length` a control.
std::vector<double> costs_of_leaving(const rig::Rig& rig, const rig::Pose& rest,
                                     std::span<const std::size_t> parameters, std::span<const double> columns,
                                     std::size_t length) {
  std::vector<geometry::ModelPoint> still(rig.vertex_count());
  std::vector<geometry::ModelPoint> moved(rig.vertex_count());
  rig.evaluate(rest, still);
  rig::Pose pose = rest;
  std::vector<double> ratios;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const rig::Parameter& range = rig.parameters()[parameters[k]];
    const double middle = 0.5 * (range.minimum + range.maximum);
    pose[parameters[k]] = rest[parameters[k]] < middle ? range.maximum : range.minimum;
    rig.evaluate(pose, moved);
    const double share = std::abs(pose[parameters[k]] - rest[parameters[k]]) / (range.maximum - range.minimum);
    pose[parameters[k]] = rest[parameters[k]];
    double whole = 0;
    for (std::size_t v = 0; v < still.size(); ++v) whole += geometry::distance(still[v], moved[v]);
    double seen = 0;
    for (std::size_t i = k * length; i < (k + 1) * length; i += 2) {
      seen += std::sqrt(columns[i] * columns[i] + columns[i + 1] * columns[i + 1]);
    }
    ratios.push_back(seen > 0 && share > 0 ? whole / share / seen : 0.0);
  }
  const double usual = quantile(ratios, 0.5);
  constexpr double k_least = 0.5;
  constexpr double k_most = 20;
  for (double& ratio : ratios) ratio = usual > 0 ? std::clamp(ratio / usual, k_least, k_most) : 1.0;
  return ratios;
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
  rig::Pose at_rest;
  std::vector<geometry::PxPoint> targets;
  std::vector<geometry::ModelPoint> now;
  posing::StageWorkspace stages;
  SparseFit fit;  ///< where the rig is linear
  SparseWorkspace sparse;
  std::vector<Twins> twins;
  geometry::ModelVector right{1, 0, 0};  ///< axes of the picture
  geometry::ModelVector up{0, 1, 0};
  std::vector<OpposedParameters> opposed;
  std::vector<bool> of_lips;  ///< points of curves that lie about those that touch

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

  /// Lets points that meet others go beyond their targets by what those fell short of. False: there are none.
  bool take_over(double confidence) {
    bool any = false;
    system.positions(pose, now);
    const auto short_of = [&](std::size_t point) {
      const auto px = camera.project(now[point]);
      return px ? targets[point] - *px : geometry::PxPoint{};
    };
    for (std::size_t i = 0; i < transfer.contact_shares.size(); ++i) {
      const ContactShare& m = transfer.contact_shares[i];
      if (!(m.takes_over > 0)) continue;
      const geometry::PxPoint rest = short_of(m.across[0]) * (1.0 - m.between) + short_of(m.across[1]) * m.between;
      aim(i, curve::lift(targets[i] - rest * m.takes_over, now[i], camera), transfer.weights[i] * confidence);
      any = true;
    }
    return any;
  }

  /// A vector as the picture shows it: without what goes along the line of sight.
  void put_seen(const geometry::ModelVector& v, std::size_t point, double* out) const {
    const geometry::ModelVector seen = seen_part(v, point);
    out[0] = seen.x * right.x + seen.y * right.y + seen.z * right.z;
    out[1] = seen.x * up.x + seen.y * up.y + seen.z * up.z;
  }

  /// A mouth is where its lips are: all points that are no farther from the middle of the contacts than they are wide.
  void find_lips() {
    of_lips.assign(sight.size(), false);
    if (transfer.contacts.empty()) return;
    geometry::PxPoint centre;
    double reach = 0;
    for (const auto& pair : transfer.contacts) {
      centre = centre + transfer.places[pair[0]] * (1.0 / static_cast<double>(transfer.contacts.size()));
    }
    for (std::size_t i = 0; i < sight.size(); ++i) {
      const bool own = std::any_of(transfer.contacts.begin(), transfer.contacts.end(), [&](const auto& pair) {
        return transfer.curve[pair[0]] == transfer.curve[i] || transfer.curve[pair[1]] == transfer.curve[i];
      });
      if (own) reach = std::max(reach, geometry::distance(transfer.places[i], centre));
    }
    for (std::size_t i = 0; i < sight.size(); ++i) {
      of_lips[i] = geometry::distance(transfer.places[i], centre) < 1.5 * reach;
    }
  }

  /// What lies between points of lips that touch, behind the points themselves: how far lips are apart is seen better
  /// than where both of them are, which a nod moves too.
  void add_contacts(double* numbers) const {
    double* out = numbers + 2 * sight.size();
    for (const auto& pair : transfer.contacts) {
      for (int axis = 0; axis < 2; ++axis) *out++ = numbers[2 * pair[1] + axis] - numbers[2 * pair[0] + axis];
    }
  }

  void make_fit() {
    find_lips();
    const std::size_t n = sight.size();
    const std::size_t all = n + transfer.contacts.size();
    fit.points = all;
    fit.weights.resize(all);
    fit.at_zero.resize(2 * all);
    fit.columns.resize(2 * all * u.size());
    for (std::size_t k = 0; k < u.size(); ++k) {
      const posing::Residuals values = model.columns[k].values();
      for (std::size_t point = 0; point < n; ++point) {
        geometry::ModelVector v;
        for (std::size_t axis = 0; axis < 3; ++axis)
          v[static_cast<int>(axis)] = values[posing::residual_index(point, axis)];
        put_seen(v, point, &fit.columns[2 * (k * all + point)]);
      }
      add_contacts(&fit.columns[2 * k * all]);
    }
    for (const double cost : costs_of_leaving(rig, at_rest, model.variables.parameter, fit.columns, 2 * all)) {
      fit.cost.push_back(k_leave * pull_unit * options.near_rest * cost);
    }
    fit.rest = rest_u;
    fit.even = pull_unit * options.near_rest;
    fit.rounds = options.max_finish_iterations;
    twins = find_twins(fit);
    fit.softness = std::max(model.softness, 1e-9 * extent);
  }

  void fit_linear(double confidence, double doubt, double near_last) {
    for (std::size_t point = 0; point < sight.size(); ++point) {
      geometry::ModelVector v;
      for (std::size_t axis = 0; axis < 3; ++axis)
        v[static_cast<int>(axis)] = model.at_zero[posing::residual_index(point, axis)];
      put_seen(v, point, &fit.at_zero[2 * point]);
      fit.weights[point] = model.weights[point] * (of_lips[point] ? 1 - k_lips_in_doubt * doubt : 1);
    }
    add_contacts(fit.at_zero.data());
    for (std::size_t c = 0; c < transfer.contacts.size(); ++c) {
      const auto& pair = transfer.contacts[c];
      fit.weights[sight.size() + c] = k_contact * (model.weights[pair[0]] + model.weights[pair[1]]);
    }
    fit.last = u;
    fit.hold = pull_unit * near_last;
    const std::vector<double> costs = fit.cost;
    for (double& cost : fit.cost) cost *= confidence;
    fit_sparsely(fit, u, sparse);
    share_evenly(twins, u);
    fit.cost = costs;
  }

  void solve(double confidence, double doubt) {
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
    if (linear) {
      fit_linear(confidence, doubt, near_last);
    } else {
      posing::StageOptions search;
      search.first_step = 0.06;
      search.max_sweeps = 1;
      search.gain_tolerance = 0.02;
      // The simplex has to come to the last of its stages by itself.
      constexpr std::size_t k_a_variable = 100;  // a frame, of a rig that is not linear
      search.max_evaluations = std::max(options.max_evaluations, k_a_variable * u.size());
      const auto objective = posing::make_general_objective(system, model.variables, pose, model.near_weight);
      posing::run_stages(*objective, relevance.effects, search, u, stages);
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      const std::size_t p = model.variables.parameter[i];
      const rig::Parameter& range = rig.parameters()[p];
      pose[p] = std::clamp(model.variables.value(i, u[i]), range.minimum, range.maximum);
    }
    take_apart(rig, at_rest, opposed, pose);
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = (pose[model.variables.parameter[i]] - model.variables.minimum[i]) / model.variables.range[i];
    }
  }
};

FrameSolver::FrameSolver(base::Hidden<State> state) : state_(std::move(state)) {}

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
  auto state = base::make_hidden<State>(rig, std::move(transfer), camera, problem);
  State& s = *state;
  s.options = options;
  s.pose = s.at_rest = problem.start;
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
  {
    const auto told = seen_information(rig, s.pose, variables.parameter, s.transfer, camera, 1.0);
    const std::size_t m = variables.parameter.size();
    for (const posing::Opposed& pair : variables.opposed) {
      s.opposed.push_back({variables.parameter[pair.a], variables.parameter[pair.b],
                           std::sqrt(told[pair.b * m + pair.b] / told[pair.a * m + pair.a])});
    }
  }
  double weight = 0;
  for (const double w : s.transfer.weights) weight += w;
  s.extent = box.diagonal();
  s.pull_unit = 0.1 * s.extent * weight;
  s.linear = s.relevance.columns.has_value();
  if (s.linear) {
    s.model = posing::make_linear_model(s.system, s.pose, std::move(variables), std::move(*s.relevance.columns), 0);
    s.points_at_zero = s.model.at_zero;
    for (const auto& p : s.now) s.sight.push_back(geometry::normalized(p - camera.eye()));
    s.right = camera.right();
    s.up = camera.up();
    s.make_fit();
  } else {
    s.model.variables = std::move(variables);
  }
  return FrameSolver(std::move(state));
}

void take_apart(const rig::Rig& rig, std::span<const double> rest, std::span<const OpposedParameters> opposed,
                std::span<double> pose) {
  const auto range = [&](std::size_t p) { return rig.parameters()[p].maximum - rig.parameters()[p].minimum; };
  for (const OpposedParameters& pair : opposed) {
    const double a = (pose[pair.a] - rest[pair.a]) / range(pair.a);
    const double b = (pose[pair.b] - rest[pair.b]) / range(pair.b);
    if (!(a * b > 0)) continue;
    const double left = std::abs(a) - pair.ratio * std::abs(b);
    const double sign = a > 0 ? 1 : -1;
    pose[pair.a] = left > 0 ? rest[pair.a] + sign * left * range(pair.a) : rest[pair.a];
    pose[pair.b] = left > 0 ? rest[pair.b] : rest[pair.b] - sign * left / pair.ratio * range(pair.b);
  }
}

const rig::Pose& FrameSolver::follow(std::span<const PxPoint> offsets, double doubt, double confidence,
                                     std::span<const Evidence> evidence) {
  State& s = *state_;
  s.fit.told.assign(evidence.empty() ? 0 : s.u.size(), 0.0);
  s.fit.wish.assign(s.fit.told.size(), 0.0);
  for (const Evidence& one : evidence) {
    const auto& all = s.model.variables.parameter;
    const auto at = std::find(all.begin(), all.end(), one.parameter);
    if (at == all.end()) continue;
    const auto k = static_cast<std::size_t>(at - all.begin());
    s.fit.told[k] = s.pull_unit * one.weight;
    s.fit.wish[k] = (one.value - s.model.variables.minimum[k]) / s.model.variables.range[k];
  }
  if (s.u.empty()) return s.pose;
  target_places(s.transfer, offsets, doubt, s.targets);
  s.system.positions(s.pose, s.now);
  for (std::size_t i = 0; i < s.targets.size(); ++i) {
    s.aim(i, curve::lift(s.targets[i], s.now[i], s.camera), s.transfer.weights[i] * confidence);
  }
  const std::vector<double> before = s.u;
  s.solve(confidence, doubt);
  if (s.take_over(confidence)) {
    s.u = before;
    s.solve(confidence, doubt);
  }
  return s.pose;
}

const rig::Pose& FrameSolver::pose() const { return state_->pose; }
std::span<const OpposedParameters> FrameSolver::opposed() const { return state_->opposed; }
std::span<const std::size_t> FrameSolver::parameters() const { return state_->relevance.parameters; }

}  // namespace penpose::animation
