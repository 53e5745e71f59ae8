#include "core/posing/relevance.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

/// Shapes that lift single vertices of row 0 of a sheet by known amounts, and a joint far from them.
struct Lifts {
  std::shared_ptr<const mesh::TriangleMesh> mesh = tests::grid_mesh(30, 30);
  std::shared_ptr<const rig::CharacterRig> rig;
  PoseProblem problem;

  explicit Lifts(std::size_t joints = 0) {
    std::vector<rig::BlendShape> shapes;
    const auto lift = [&](std::string name, std::vector<std::uint32_t> vertices, float by, double maximum) {
      rig::BlendShape& shape = shapes.emplace_back();
      shape.parameter = {std::move(name), 0, 0, maximum};
      shape.deltas.assign(vertices.size(), {0, 0, by});
      shape.vertices = std::move(vertices);
    };
    lift("large", {2, 3}, 0.5F, 1);
    lift("small", {4}, 0.001F, 1);
    lift("small but wide", {4}, 0.001F, 100);
    lift("elsewhere", {500}, 9, 1);
    rig = rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()},
                                  joints == 0 ? nullptr : tests::chain_skeleton(*mesh, joints, 0.5))
              .value();
    problem.pairs.push_back({tests::Sheet::row(0, 0, 9), std::vector<ModelPoint>(10, ModelPoint{0}), {}});
    problem.start = rig::rest_pose(*rig);
    problem.free.resize(problem.start.size());
    std::iota(problem.free.begin(), problem.free.end(), std::size_t{0});
  }
  [[nodiscard]] Relevance relevance(double threshold, const std::vector<std::size_t>& free) const {
    CurveSystem system(*rig, problem);
    return relevant_parameters(system, problem.start, free, threshold);
  }
};

TEST(Relevance, DropsWhatMovesNoPointByMoreThanTheThreshold) {
  const Lifts lifts;
  const auto all = lifts.problem.free;
  EXPECT_EQ(lifts.relevance(0, all).parameters, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(lifts.relevance(0.01, all).parameters, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(lifts.relevance(0.2, all).parameters, (std::vector<std::size_t>{0}));
  EXPECT_TRUE(lifts.relevance(0.6, all).parameters.empty());
  EXPECT_EQ(lifts.relevance(0, {1, 3}).parameters, (std::vector<std::size_t>{1})) << "only of those that are free";
}

TEST(Relevance, TheEffectIsTheWayOfAllPointsOverTheRange) {
  const Lifts lifts;
  const auto found = lifts.relevance(0, lifts.problem.free);
  EXPECT_NEAR(found.effects[0], 2 * 0.5, 1e-7);
  EXPECT_NEAR(found.effects[1], 0.001, 1e-7);
  EXPECT_NEAR(found.effects[2], 0.1, 1e-7);
  ASSERT_TRUE(found.columns);
  EXPECT_EQ(found.columns->size(), 3U);
  EXPECT_NEAR((*found.columns)[0].values()[residual_index(3, 2)], 0.5, 1e-7);
}

TEST(Relevance, AConstraintCountsAsMuchAsAReference) {
  Lifts lifts;
  lifts.problem.constraints.push_back({{at_vertex(500)}, {ModelPoint{0}}});
  EXPECT_EQ(lifts.relevance(0.2, lifts.problem.free).parameters, (std::vector<std::size_t>{0, 3}));
}

TEST(Relevance, TriesParametersThatAreNotLinear) {
  const Lifts lifts(3);  // joints at x = 0, 0.5 and 1; the curve lies at x = 0..0.3 along y = 0
  const auto found = lifts.relevance(2e-3, lifts.problem.free);
  EXPECT_FALSE(found.columns);
  std::vector<std::string> names;
  for (const std::size_t p : found.parameters) names.push_back(lifts.rig->parameters()[p].name);
  // The curve lies on the first joint's x axis, a turn about which moves nothing; the last joint carries none of it.
  // The second turns its share of the curve about x = 0.5.
  EXPECT_EQ(names,
            (std::vector<std::string>{"large", "small but wide", "joint0.ry", "joint0.rz", "joint1.ry", "joint1.rz"}));
}

TEST(Relevance, ATurnThatReturnsIsNotOverlooked) {
  // From -90 to 90 degrees a turn moves points both ways; its ends alone would show it, and so does the middle.
  const Lifts lifts(2);
  const auto found = lifts.relevance(0, lifts.problem.free);
  const auto place = std::find(found.parameters.begin(), found.parameters.end(), 6) - found.parameters.begin();
  ASSERT_LT(static_cast<std::size_t>(place), found.parameters.size());
  // About z by up to a quarter turn: a point at distance r from the axis moves by r sqrt(2), less what the second
  // joint holds. The effect is of the size of the curve.
  EXPECT_GT(found.effects[static_cast<std::size_t>(place)], 1.0);
  EXPECT_LT(found.effects[static_cast<std::size_t>(place)], 4.0);
}

}  // namespace
}  // namespace penpose::posing
