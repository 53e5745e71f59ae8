#include "core/posing/solve.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/support/models/test_rigs.h"

namespace penpose::posing {
namespace {

struct Face {
  std::shared_ptr<const mesh::TriangleMesh> mesh = tests::grid_mesh(30, 30);
  std::shared_ptr<const rig::BlendShapes> shapes;
  std::shared_ptr<const rig::CharacterRig> rig;

  explicit Face(std::size_t count, std::uint64_t seed = 3) {
    shapes = tests::random_shapes(*mesh, count, seed);
    rig = rig::CharacterRig::make(mesh, {shapes}, nullptr).value();
  }
};

std::vector<CurvePoint> row_curve(std::uint32_t row, std::uint32_t from = 0, std::uint32_t to = 30) {
  std::vector<CurvePoint> points;
  for (std::uint32_t c = from; c <= to; ++c) points.push_back(at_vertex(row * 31 + c));
  return points;
}

std::vector<ModelPoint> positions_at(const rig::Rig& rig, const std::vector<CurvePoint>& points,
                                     const rig::Pose& pose) {
  std::vector<ModelPoint> all(rig.vertex_count());
  rig.evaluate(pose, all);
  std::vector<ModelPoint> at;
  for (const CurvePoint& p : points)
    at.push_back(all[p.vertex[0]] * p.weight[0] + all[p.vertex[1]] * p.weight[1] + all[p.vertex[2]] * p.weight[2]);
  return at;
}

/// Curves across the whole sheet, targets where they are at `answer`.
PoseProblem known_answer(const Face& face, const rig::Pose& answer) {
  PoseProblem problem;
  for (const std::uint32_t row : {3U, 9U, 15U, 21U, 27U}) {
    auto reference = row_curve(row);
    auto target = positions_at(*face.rig, reference, answer);
    problem.pairs.push_back({std::move(reference), std::move(target), {}});
  }
  problem.start = rig::rest_pose(*face.rig);
  problem.free.resize(problem.start.size());
  std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
  return problem;
}

Solution solved(const rig::Rig& rig, const PoseProblem& problem, const SolveOptions& options = {}) {
  SolveWorkspace work;
  return solve(rig, problem, options, work).value();
}

double energy_by_hand(const rig::Rig& rig, const PoseProblem& problem, const rig::Pose& pose) {
  double sum = 0;
  const auto add = [&](const auto& points, const auto& targets, const std::vector<double>& weights) {
    const auto at = positions_at(rig, points, pose);
    for (std::size_t i = 0; i < at.size(); ++i)
      sum += (weights.empty() ? 1.0 : weights[i]) * geometry::distance(at[i], targets[i]);
  };
  for (const auto& pair : problem.pairs) add(pair.reference, pair.target, pair.weights);
  for (const auto& constraint : problem.constraints) add(constraint.points, constraint.positions, {});
  return sum;
}

/// At rest but for these.
rig::Pose answer_of(std::size_t count, const std::vector<std::pair<std::size_t, double>>& values) {
  rig::Pose answer(count, 0.0);
  for (const auto& [number, value] : values) answer[number] = value;
  return answer;
}

TEST(Solve, FindsAKnownPoseOfAFewParameters) {
  const Face face(8);
  const rig::Pose answer{0.7, 0, 0.2, 0, 0.9, 0, 0, 0.4};
  const auto problem = known_answer(face, answer);
  const Solution solution = solved(*face.rig, problem);
  EXPECT_LT(solution.energy, 1e-3 * solution.energy_start);
  for (std::size_t i = 0; i < answer.size(); ++i) EXPECT_NEAR(solution.pose[i], answer[i], 0.01) << i;
  EXPECT_TRUE(solution.linear);
}

TEST(Solve, FindsAKnownPoseOfManyParametersInStages) {
  const Face face(60);
  const auto problem = known_answer(face, answer_of(60, {{4, 0.8}, {17, 0.5}, {33, 1.0}}));
  const Solution solution = solved(*face.rig, problem);
  EXPECT_LT(solution.energy, 2e-3 * solution.energy_start);
}

TEST(Solve, TheSimplexAloneComesNear) {
  const Face face(30);
  const auto problem = known_answer(face, answer_of(30, {{3, 0.8}, {11, 0.6}}));
  SolveOptions options;
  options.finish = false;
  const Solution solution = solved(*face.rig, problem, options);
  EXPECT_LT(solution.energy, 0.05 * solution.energy_start);
}

TEST(Solve, ReportsTheEnergyOfThePaper) {
  const Face face(10);
  auto problem = known_answer(face, rig::Pose(10, 0.3));
  problem.pairs[1].weights.assign(31, 0.5);
  problem.pairs[1].weights[7] = 4;
  problem.constraints.push_back({row_curve(12, 5, 9), positions_at(*face.rig, row_curve(12, 5, 9), problem.start)});
  for (ModelPoint& t : problem.pairs[0].target) t.y += 0.05;
  const Solution solution = solved(*face.rig, problem);
  EXPECT_NEAR(solution.energy_start, energy_by_hand(*face.rig, problem, problem.start), 1e-12);
  EXPECT_NEAR(solution.energy, energy_by_hand(*face.rig, problem, solution.pose), 1e-12);
  EXPECT_LT(solution.energy, solution.energy_start);
}

TEST(Solve, NeverLeavesTheRangesNorMovesWhatIsNotFree) {
  const Face face(12);
  rig::Pose answer(12, 0.0);
  answer[2] = 1.0;
  auto problem = known_answer(face, answer);
  // A target beyond reach pushes every parameter against its ends.
  for (auto& pair : problem.pairs) {
    for (ModelPoint& t : pair.target) t.z += 5;
  }
  problem.free = {1, 2, 5, 8};
  problem.start[4] = 0.25;
  for (const bool paper : {false, true}) {
    SolveOptions options;
    options.paper = paper;
    const Solution solution = solved(*face.rig, problem, options);
    EXPECT_LT(solution.energy, solution.energy_start);
    for (std::size_t i = 0; i < solution.pose.size(); ++i) {
      EXPECT_GE(solution.pose[i], 0.0);
      EXPECT_LE(solution.pose[i], 1.0);
      const bool is_free = std::find(problem.free.begin(), problem.free.end(), i) != problem.free.end();
      if (!is_free) {
        EXPECT_EQ(solution.pose[i], problem.start[i]);
      }
    }
  }
}

TEST(Solve, LeavesParametersAloneThatMoveNoCurve) {
  const Face face(40);
  rig::Pose answer(40, 0.0);
  PoseProblem problem = known_answer(face, answer);
  problem.pairs.clear();
  auto reference = row_curve(2, 2, 8);
  auto target = positions_at(*face.rig, reference, problem.start);
  for (ModelPoint& t : target) t.z += 0.02;
  problem.pairs.push_back({reference, target, {}});
  const Solution solution = solved(*face.rig, problem);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    bool moves = false;
    for (const CurvePoint& p : reference) {
      for (const auto& entry : face.shapes->entries_of(p.vertex[0])) moves |= entry.shape == i;
    }
    touching += moves ? 1 : 0;
    if (!moves) {
      EXPECT_EQ(solution.pose[i], 0.0);
    }
  }
  EXPECT_LE(solution.variables, touching);
  EXPECT_GT(solution.variables, 0U);
}

TEST(Solve, AConstraintHoldsItsCurve) {
  const Face face(50, 9);
  rig::Pose answer(50, 0.0);
  PoseProblem problem = known_answer(face, answer);
  problem.pairs.resize(1);
  for (ModelPoint& t : problem.pairs[0].target) t.z += 0.08;
  const auto kept = row_curve(9);
  const auto at_rest = positions_at(*face.rig, kept, problem.start);
  const auto moved_by = [&](const Solution& s) {
    const auto at = positions_at(*face.rig, kept, s.pose);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += geometry::distance(at[i], at_rest[i]);
    return sum;
  };
  const double loose = moved_by(solved(*face.rig, problem));
  problem.constraints.push_back({kept, at_rest});
  const double held = moved_by(solved(*face.rig, problem));
  EXPECT_LT(held, 0.5 * loose);
}

TEST(Solve, OfManyFittingPosesItTakesTheOneNearTheStart) {
  // Two shapes that move the curve alike: any split fits, the nearest pose shares the work.
  const auto mesh = tests::grid_mesh(10, 2);
  std::vector<rig::BlendShape> shapes(2);
  for (std::size_t s = 0; s < 2; ++s) {
    shapes[s].parameter.name = s == 0 ? "a" : "b";
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      shapes[s].vertices.push_back(v);
      shapes[s].deltas.emplace_back(0, 0, 1);
    }
  }
  const auto rig =
      rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()}, nullptr).value();
  PoseProblem problem;
  CurvePair pair;
  for (std::uint32_t v = 0; v < 11; ++v) {
    pair.reference.push_back(at_vertex(v));
    pair.target.push_back(mesh->positions()[v] + geometry::ModelVector{0, 0, 0.6});
  }
  problem.pairs = {pair};
  problem.free = {0, 1};
  problem.start = {0, 0};
  SolveOptions options;
  options.clean_up = 0;
  const Solution solution = solved(*rig, problem, options);
  EXPECT_NEAR(solution.pose[0] + solution.pose[1], 0.6, 1e-3);
  EXPECT_NEAR(solution.pose[0], 0.3, 0.01);
}

TEST(Solve, TheSameProblemGivesTheSameBits) {
  const Face face(45);
  const auto problem = known_answer(face, answer_of(45, {{7, 0.4}, {30, 0.9}}));
  SolveWorkspace used;
  const auto first = solve(*face.rig, problem, {}, used).value();
  const auto again = solve(*face.rig, problem, {}, used).value();
  const auto fresh = solved(*face.rig, problem);
  EXPECT_EQ(first.pose, again.pose);
  EXPECT_EQ(first.pose, fresh.pose);
  EXPECT_EQ(first.evaluations, fresh.evaluations);
}

TEST(Solve, AStartThatFitsStays) {
  const Face face(20);
  const auto problem = known_answer(face, rig::Pose(20, 0.0));
  const Solution solution = solved(*face.rig, problem);
  EXPECT_EQ(solution.pose, problem.start);
  EXPECT_EQ(solution.energy, 0.0);
}

}  // namespace
}  // namespace penpose::posing
