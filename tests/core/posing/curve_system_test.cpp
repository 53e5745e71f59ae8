#include "core/posing/curve_system.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

/// Passes everything on and notes what it was asked for.
class Spy final : public rig::Rig {
 public:
  explicit Spy(const rig::Rig& rig) : rig_(rig) {}
  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return rig_.parameters(); }
  [[nodiscard]] std::size_t vertex_count() const override { return rig_.vertex_count(); }
  void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const override {
    whole = true;
    rig_.evaluate(pose, positions);
  }
  [[nodiscard]] std::unique_ptr<rig::BoundVertices> bind(std::span<const std::uint32_t> vertices) const override {
    bound.assign(vertices.begin(), vertices.end());
    return rig_.bind(vertices);
  }
  mutable std::vector<std::uint32_t> bound;
  mutable bool whole = false;

 private:
  const rig::Rig& rig_;
};

/// A weighted pair of a vertex and two points inside triangles, and a constraint.
PoseProblem mixed_problem(const tests::Sheet& sheet) {
  PoseProblem problem;
  CurvePair pair;
  pair.reference = {at_vertex(33), {{33, 34, 65}, {0.25, 0.25, 0.5}}, {{400, 401, 33}, {0, 0.5, 0.5}}};
  pair.target = {{0, 0, 1}, {0.5, 0.5, 0.5}, {1, 1, 1}};
  pair.weights = {2, 0.5, 0};
  problem.pairs.push_back(pair);
  const auto kept = sheet.row(20, 4, 9);
  problem.constraints.push_back({kept, sheet.at(kept, rig::rest_pose(*sheet.rig))});
  problem.start = rig::rest_pose(*sheet.rig);
  problem.free = {0, 1, 2};
  return problem;
}

TEST(CurveSystem, ItsEnergyIsTheWeightedSumOfDistances) {
  const tests::Sheet sheet(10);
  const PoseProblem problem = mixed_problem(sheet);
  CurveSystem system(*sheet.rig, problem);
  EXPECT_EQ(system.point_count(), 9U);
  EXPECT_EQ(system.weights().size() % k_block_points, 0U);
  tests::Random random(1);
  for (int run = 0; run < 10; ++run) {
    const auto pose = tests::random_pose(*sheet.rig, random);
    Residuals residuals(system.residual_count());
    system.residuals(pose, residuals);
    const auto r = sheet.at(problem.pairs[0].reference, pose);
    const auto k = sheet.at(problem.constraints[0].points, pose);
    double expected = 2 * geometry::distance(r[0], problem.pairs[0].target[0]) +
                      0.5 * geometry::distance(r[1], problem.pairs[0].target[1]);
    double longest = std::max(geometry::distance(r[0], problem.pairs[0].target[0]),
                              geometry::distance(r[1], problem.pairs[0].target[1]));
    for (std::size_t i = 0; i < k.size(); ++i) {
      const double d = geometry::distance(k[i], problem.constraints[0].positions[i]);
      expected += d;
      longest = std::max(longest, d);
    }
    EXPECT_NEAR(system.energy(residuals), expected, 1e-12);
    EXPECT_NEAR(system.longest(residuals), longest, 1e-12) << "a point without weight does not count";
    std::vector<ModelPoint> positions(9);
    system.positions(pose, positions);
    EXPECT_NEAR(geometry::distance(positions[2], r[2]), 0, 1e-12);
    EXPECT_NEAR(geometry::distance(positions[8], k[5]), 0, 1e-12);
  }
}

TEST(CurveSystem, TouchesOnlyTheVerticesUnderTheCurves) {
  const tests::Sheet sheet(10);
  const Spy spy(*sheet.rig);
  const PoseProblem problem = mixed_problem(sheet);
  CurveSystem system(spy, problem);
  Residuals residuals(system.residual_count());
  system.residuals(problem.start, residuals);
  std::vector<std::uint32_t> expected{33, 34, 65, 400, 401};
  for (std::uint32_t c = 4; c <= 9; ++c) expected.push_back(20 * 31 + c);
  EXPECT_EQ(spy.bound, expected) << "each once";
  EXPECT_FALSE(spy.whole);
}

TEST(CurveSystem, FollowsATargetThatIsStillBeingDrawn) {
  const tests::Sheet sheet(10);
  const PoseProblem problem = mixed_problem(sheet);
  CurveSystem system(*sheet.rig, problem);
  Residuals residuals(system.residual_count());
  const auto energy = [&] {
    system.residuals(problem.start, residuals);
    return system.energy(residuals);
  };
  const double before = energy();
  const auto at = sheet.at(problem.pairs[0].reference, problem.start);
  system.set_target(0, at[0]);
  EXPECT_NEAR(energy(), before - 2 * geometry::distance(at[0], problem.pairs[0].target[0]), 1e-12);
  system.set_weight(1, 0);
  EXPECT_NEAR(energy(), 0, 1e-12);
}

TEST(CurveSystem, ColumnsAreHowTheResidualsChange) {
  const tests::Sheet sheet(10, 3, 2);
  const PoseProblem problem = mixed_problem(sheet);
  CurveSystem system(*sheet.rig, problem);
  tests::Random random(2);
  const auto pose = tests::random_pose(*sheet.rig, random);
  const std::vector<std::size_t> free{0, 4, 9};
  const auto columns = system.columns(pose, free);
  ASSERT_TRUE(columns);
  ASSERT_EQ(columns->size(), 3U);
  Residuals low(system.residual_count());
  Residuals high(system.residual_count());
  for (std::size_t j = 0; j < free.size(); ++j) {
    auto moved = pose;
    moved[free[j]] = 0;
    system.residuals(moved, low);
    moved[free[j]] = 1;
    system.residuals(moved, high);
    for (std::size_t i = 0; i < low.size(); ++i) EXPECT_NEAR((*columns)[j].values()[i], high[i] - low[i], 1e-12);
  }
  EXPECT_FALSE(system.columns(pose, std::vector<std::size_t>{0, 10})) << "a joint turns";
}

TEST(CurveSystem, KnowsWhatMovesItsPoints) {
  const tests::Sheet sheet(10);
  const PoseProblem problem = mixed_problem(sheet);
  CurveSystem system(*sheet.rig, problem);
  const auto& shapes = dynamic_cast<const rig::BlendShapes&>(*sheet.rig->layers()[0]);
  std::size_t moving = 0;
  for (std::size_t p = 0; p < 10; ++p) {
    bool expected = false;
    const auto look = [&](const std::vector<CurvePoint>& points) {
      for (const CurvePoint& point : points) {
        for (const std::uint32_t v : point.vertex) {
          for (const auto& entry : shapes.entries_of(v)) expected |= entry.shape == p;
        }
      }
    };
    look(problem.pairs[0].reference);
    look(problem.constraints[0].points);
    EXPECT_EQ(system.moves(p), expected) << p;
    moving += expected ? 1 : 0;
  }
  EXPECT_GT(moving, 0U);
  EXPECT_LT(moving, 10U);
}

}  // namespace
}  // namespace penpose::posing
