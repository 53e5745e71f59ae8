// The curves of the real face in shared/meshes, each with the true optimum of its energy, against the whole solver.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "core/io/project/case_file.h"
#include "core/posing/solve.h"
#include "tests/support/models/posing_problems.h"
#include "tests/support/shared_data.h"

namespace penpose::posing {
namespace {

struct Cases {
  document::Model model;
  std::vector<io::PoseCase> cases;
};

Cases load() {
  const auto folder = tests::shared_dir() / "meshes";
  return {io::read_model(tests::read_file(folder / "ict_face.glb"), "ict_face.glb").value(),
          io::read_cases(tests::read_file(folder / "ict_face_sketch_cases.json")).value().cases};
}

PoseProblem problem_of(const Cases& all, const io::PoseCase& one, bool of_case) {
  PoseProblem problem;
  problem.start = rig::rest_pose(*all.model.rig);
  const auto rest = tests::all_positions(*all.model.rig, problem.start);
  for (const auto& reference : one.references) {
    CurvePair pair;
    for (const std::uint32_t v : reference.vertices) pair.reference.push_back(at_vertex(v));
    pair.target = reference.target;
    problem.pairs.push_back(pair);
  }
  for (const auto& constraint : one.constraints) {
    Constraint kept;
    for (const std::uint32_t v : constraint.vertices) {
      kept.points.push_back(at_vertex(v));
      kept.positions.push_back(rest[v]);
    }
    problem.constraints.push_back(kept);
  }
  for (std::size_t p = 0; p < problem.start.size(); ++p) {
    const auto& name = all.model.rig->parameters()[p].name;
    if (!of_case || std::find(one.free.begin(), one.free.end(), name) != one.free.end()) problem.free.push_back(p);
  }
  return problem;
}

/// sum |b_i + sum_j x_j a_ij| over x in 0..1, written out densely from whole evaluations of the rig.
class Convex {
 public:
  Convex(const rig::Rig& rig, const PoseProblem& problem) {
    const auto rest = tests::all_positions(rig, problem.start);
    std::vector<std::uint32_t> vertices;
    const auto add = [&](const std::vector<CurvePoint>& points, const std::vector<ModelPoint>& targets) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        vertices.push_back(points[i].vertex[0]);
        base_.push_back(rest[points[i].vertex[0]] - targets[i]);
      }
    };
    for (const auto& pair : problem.pairs) add(pair.reference, pair.target);
    for (const auto& constraint : problem.constraints) add(constraint.points, constraint.positions);
    for (const std::size_t p : problem.free) {
      auto pose = problem.start;
      pose[p] = 1;
      const auto moved = tests::all_positions(rig, pose);
      std::vector<ModelPoint> column;
      for (const std::uint32_t v : vertices) column.push_back(moved[v] - rest[v]);
      columns_.push_back(column);
    }
  }

  [[nodiscard]] double energy(const std::vector<double>& x) const {
    double sum = 0;
    for (const ModelPoint& r : residuals(x)) sum += geometry::length(r);
    return sum;
  }

  struct Minimum {
    double energy = 0;
    double bound = 0;  ///< no x has less energy than this
  };

  /// Smoothed reweighted least squares with a shrinking smoothing, thousands of projected coordinate steps each.
  [[nodiscard]] Minimum minimum() const {
    std::vector<double> x(columns_.size(), 0.0);
    Minimum found{energy(x), 0};
    const double scale = found.energy / static_cast<double>(base_.size());
    for (double smooth = 0.1; smooth > 1e-9; smooth *= 0.8) {
      for (int again = 0; again < 4; ++again) {
        auto r = residuals(x);
        std::vector<double> share;
        for (const ModelPoint& p : r)
          share.push_back(1 / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z + smooth * smooth * scale * scale));
        for (int sweep = 0; sweep < 30; ++sweep) {
          for (std::size_t j = 0; j < x.size(); ++j) {
            double slope = 0;
            double curvature = 0;
            for (std::size_t i = 0; i < r.size(); ++i) {
              const ModelPoint& a = columns_[j][i];
              slope += share[i] * (a.x * r[i].x + a.y * r[i].y + a.z * r[i].z);
              curvature += share[i] * (a.x * a.x + a.y * a.y + a.z * a.z);
            }
            if (!(curvature > 0)) continue;
            const double to = std::clamp(x[j] - slope / curvature, 0.0, 1.0);
            for (std::size_t i = 0; i < r.size(); ++i) r[i] += columns_[j][i] * (to - x[j]);
            x[j] = to;
          }
        }
        found.energy = std::min(found.energy, energy(x));
      }
      found.bound = std::max(found.bound, lower_bound(x, smooth * scale));
    }
    return found;
  }

 private:
  /// For any p_i with |p_i| <= 1, sum |r_i(x)| >= sum p_i b_i + sum over j of min(0, sum p_i a_ij). Here p_i =
  /// r_i / sqrt(|r_i|^2 + smooth^2), which makes the last sums vanish at the minimum of the smoothed problem.
  [[nodiscard]] double lower_bound(const std::vector<double>& x, double smooth) const {
    const auto r = residuals(x);
    double bound = 0;
    std::vector<double> slope(x.size(), 0.0);
    for (std::size_t i = 0; i < r.size(); ++i) {
      const ModelPoint p = r[i] / std::sqrt(r[i].x * r[i].x + r[i].y * r[i].y + r[i].z * r[i].z + smooth * smooth);
      bound += p.x * base_[i].x + p.y * base_[i].y + p.z * base_[i].z;
      for (std::size_t j = 0; j < x.size(); ++j) {
        const ModelPoint& a = columns_[j][i];
        slope[j] += p.x * a.x + p.y * a.y + p.z * a.z;
      }
    }
    for (const double s : slope) bound += std::min(0.0, s);
    return bound;
  }

  [[nodiscard]] std::vector<ModelPoint> residuals(const std::vector<double>& x) const {
    auto r = base_;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (x[j] == 0.0) continue;
      for (std::size_t i = 0; i < r.size(); ++i) r[i] += columns_[j][i] * x[j];
    }
    return r;
  }

  std::vector<ModelPoint> base_;
  std::vector<std::vector<ModelPoint>> columns_;
};

TEST(SharedSketchCases, WithAllParametersFreeEveryCaseComesNearItsOptimum) {
  if (!tests::has_shared()) GTEST_SKIP();
  const Cases all = load();
  ASSERT_EQ(all.cases.size(), 12U);
  std::vector<double> gaps;
  SolveWorkspace work;
  for (const auto& one : all.cases) {
    const Solution solution = solve(*all.model.rig, problem_of(all, one, false), {}, work).value();
    EXPECT_NEAR(solution.energy_start, one.rest_energy.value(), 1e-3);
    const double optimum = one.optimum_energy.value();
    EXPECT_GE(solution.energy, optimum - 1e-4) << one.name << ": nothing is better than the optimum";
    gaps.push_back((solution.energy - optimum) / (one.rest_energy.value() - optimum));
    EXPECT_LE(gaps.back(), 0.01) << one.name;
  }
  std::sort(gaps.begin(), gaps.end());
  EXPECT_LE(gaps[gaps.size() / 2], 0.003);
}

TEST(SharedSketchCases, WithTheParametersOfTheCaseEveryCaseReachesItsOwnOptimum) {
  if (!tests::has_shared()) GTEST_SKIP();
  const Cases all = load();
  SolveWorkspace work;
  for (const auto& one : all.cases) {
    const PoseProblem problem = problem_of(all, one, true);
    const Solution solution = solve(*all.model.rig, problem, {}, work).value();
    const Convex convex(*all.model.rig, problem);
    const auto [optimum, bound] = convex.minimum();
    const double rest = solution.energy_start;
    // The reference is an optimum: a bound from below is as high.
    EXPECT_GE(bound, optimum - 2e-4 * (rest - optimum)) << one.name;
    EXPECT_LE((solution.energy - optimum) / (rest - optimum), 0.001) << one.name;
  }
}

TEST(SharedSketchCases, ThePapersPresetImprovesEveryCase) {
  if (!tests::has_shared()) GTEST_SKIP();
  const Cases all = load();
  SolveWorkspace work;
  SolveOptions options;
  options.paper = true;
  for (const auto& one : all.cases) {
    const Solution solution = solve(*all.model.rig, problem_of(all, one, true), options, work).value();
    EXPECT_LT(solution.energy, solution.energy_start) << one.name;
  }
}

}  // namespace
}  // namespace penpose::posing
