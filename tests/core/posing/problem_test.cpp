#include "core/posing/problem.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

TEST(CurvePoint, IsAVertexOrAPointOfATriangle) {
  EXPECT_EQ(at_vertex(7).vertex[0], 7U);
  EXPECT_EQ(at_vertex(7).weight, (std::array<double, 3>{1, 0, 0}));
  const std::vector<mesh::Triangle> triangles{{0, 1, 2}, {4, 2, 9}};
  const CurvePoint point = at_mesh_point({1, {0.2, 0.3, 0.5}}, triangles);
  EXPECT_EQ(point.vertex, (std::array<std::uint32_t, 3>{4, 2, 9}));
  EXPECT_EQ(point.weight, (std::array<double, 3>{0.2, 0.3, 0.5}));
}

TEST(PressureWeights, HaveMeanOne) {
  const auto weights = pressure_weights(std::vector<double>{0.2, 0.4, 0.6});
  EXPECT_NEAR(weights[0], 0.5, 1e-15);
  EXPECT_NEAR(weights[1], 1.0, 1e-15);
  EXPECT_NEAR(weights[2], 1.5, 1e-15);
  EXPECT_EQ(pressure_weights(std::vector<double>{0, 0}), (std::vector<double>{1, 1}));
  EXPECT_TRUE(pressure_weights({}).empty());
}

TEST(CheckProblem, NamesWhatIsWrong) {
  const tests::Sheet sheet(4);
  const PoseProblem good = sheet.problem(rig::Pose(4, 0.5));
  ASSERT_TRUE(check_problem(*sheet.rig, good));
  const auto place = [&](auto spoil) {
    PoseProblem problem = good;
    problem.constraints.push_back({sheet.row(12), sheet.at(sheet.row(12), problem.start)});
    spoil(problem);
    return tests::place_of_fault(check_problem(*sheet.rig, problem));
  };
  EXPECT_EQ(place([](PoseProblem&) {}), "fine");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs.clear(); }), "");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs = {CurvePair{}}; }), "");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[2].target.pop_back(); }), "reference 2");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[2].target[5].x = NAN; }), "reference 2");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[1].reference[0].vertex[2] = 961; }), "reference 1");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[1].reference[0].weight[2] = INFINITY; }), "reference 1");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[4].weights.assign(30, 1); }), "reference 4");
  EXPECT_EQ(place([](PoseProblem& p) { p.pairs[4].weights.assign(31, 0); }), "reference 4");
  EXPECT_EQ(place([](PoseProblem& p) {
              p.pairs[4].weights.assign(31, 1);
              p.pairs[4].weights[3] = -1;
            }),
            "reference 4");
  EXPECT_EQ(place([](PoseProblem& p) {
              p.pairs[4].weights.assign(31, 0);
              p.pairs[4].weights[3] = 1;
            }),
            "fine");
  EXPECT_EQ(place([](PoseProblem& p) { p.constraints[0].positions.clear(); }), "constraint 0");
  EXPECT_EQ(place([](PoseProblem& p) { p.constraints[0].points[3].vertex[0] = 100000; }), "constraint 0");
  EXPECT_EQ(place([](PoseProblem& p) { p.start.push_back(0); }), "start");
  EXPECT_EQ(place([](PoseProblem& p) { p.start[2] = 1.01; }), "parameter shape2");
  EXPECT_EQ(place([](PoseProblem& p) { p.start[2] = NAN; }), "parameter shape2");
  EXPECT_EQ(place([](PoseProblem& p) { p.free = {1, 4}; }), "free 1");
  EXPECT_EQ(place([](PoseProblem& p) { p.free = {1, 1}; }), "free 1");
  EXPECT_EQ(place([](PoseProblem& p) { p.free = {2, 1}; }), "free 1");
  EXPECT_EQ(place([](PoseProblem& p) { p.free.clear(); }), "fine");
}

}  // namespace
}  // namespace penpose::posing
