#include "core/tracking/case_problem.h"

#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::tracking {
namespace {

struct Case {
  document::Model model;
  io::PoseCase pose_case;

  Case() {
    const auto mesh = tests::grid_mesh(10, 10);
    model = document::make_model(mesh, tests::random_shapes(*mesh, 6, 2), nullptr).value();
    pose_case.name = "smile";
    pose_case.free = {"shape4", "shape1", "shape4"};
    io::CaseReference reference;
    for (std::uint32_t v = 55; v <= 65; ++v) {
      reference.vertices.push_back(v);
      reference.target.push_back(mesh->positions()[v] + geometry::ModelVector{0, 0.1, 0});
    }
    pose_case.references.push_back(reference);
    pose_case.constraints.push_back({"chin", {0, 1, 2}});
  }
  [[nodiscard]] auto problem(FreeSet free = FreeSet::all, io::TargetForm form = io::TargetForm::points) const {
    return problem_of_case(model, pose_case, free, form);
  }
};

TEST(CaseProblem, PairsVertexIWithTargetI) {
  const Case c;
  const auto problem = c.problem().value();
  ASSERT_EQ(problem.pairs.size(), 1U);
  EXPECT_EQ(problem.pairs[0].reference[3].vertex[0], 58U);
  EXPECT_EQ(problem.pairs[0].target, c.pose_case.references[0].target);
  EXPECT_TRUE(problem.pairs[0].weights.empty());
  EXPECT_EQ(problem.start, rig::rest_pose(*c.model.rig));
  EXPECT_TRUE(posing::check_problem(*c.model.rig, problem));
}

TEST(CaseProblem, ConstraintsStayWhereTheyAreAtRest) {
  Case c;
  c.model.pose.assign(6, 1.0);  // where the model stands now does not matter
  const auto problem = c.problem().value();
  ASSERT_EQ(problem.constraints.size(), 1U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(problem.constraints[0].positions[i], c.model.mesh->positions()[i]);
}

TEST(CaseProblem, WhatIsNotFreeStaysAsTheModelStands) {
  Case c;
  c.model.pose.assign(6, 0.5);
  const auto problem = c.problem(FreeSet::of_case).value();
  EXPECT_EQ(problem.start, (rig::Pose{0.5, 0, 0.5, 0.5, 0, 0.5}));
  std::vector<geometry::ModelPoint> start(c.model.mesh->vertex_count());
  c.model.rig->evaluate(problem.start, start);
  EXPECT_EQ(problem.constraints[0].positions[1], start[1]);
  const auto meant = intent_of_case(c.model, c.pose_case, FreeSet::of_case, io::TargetForm::points, 0.01).value();
  EXPECT_EQ(meant.start, problem.start);
  EXPECT_EQ(meant.kept[0].target[1], start[1]);
}

TEST(CaseProblem, FreesAllParametersOrThoseOfTheCase) {
  Case c;
  EXPECT_EQ(c.problem(FreeSet::all)->free, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(c.problem(FreeSet::of_case)->free, (std::vector<std::size_t>{1, 4})) << "ascending, each once";
  c.pose_case.free.clear();
  EXPECT_EQ(c.problem(FreeSet::of_case)->free.size(), 6U) << "a case that names none leaves all free";
}

TEST(CaseProblem, ADrawnTargetIsOrderedSpacedAndLifted) {
  Case c;
  auto& target = c.pose_case.references[0].target;
  const auto points = target;
  // The same line, drawn from right to left in three strokes of the pen.
  target = {points[10], points[7], points[0]};
  const auto problem = c.problem(FreeSet::all, io::TargetForm::drawn).value();
  const auto camera = case_camera(c.model, c.pose_case);
  ASSERT_EQ(problem.pairs[0].target.size(), 11U);
  for (std::size_t i = 0; i < 11; ++i) {
    const auto rest = c.model.mesh->positions()[55 + i];
    EXPECT_NEAR(geometry::distance(problem.pairs[0].target[i], camera.eye()), geometry::distance(rest, camera.eye()),
                1e-9);
    const auto px = camera.project(problem.pairs[0].target[i]).value();
    EXPECT_NEAR(geometry::distance(px, camera.project(points[i]).value()), 0, 1e-3);
  }
}

TEST(CaseProblem, TheCamerasYawIsTheCases) {
  Case c;
  c.pose_case.view_yaw_degrees = 90;
  const auto camera = case_camera(c.model, c.pose_case);
  EXPECT_NEAR(camera.forward().x, -1, 1e-12);
  EXPECT_EQ(camera.viewport(), (geometry::Viewport{1000, 1000}));
}

TEST(CaseProblem, ADrawnTargetThatCannotBeSeenNamesItsCase) {
  Case c;
  c.pose_case.references[0].target[4].z = 1000;
  const auto behind = c.problem(FreeSet::all, io::TargetForm::drawn);
  ASSERT_FALSE(behind);
  EXPECT_EQ(behind.error().place, "case smile, reference 0");
  EXPECT_EQ(behind.error().what, "the target lies behind the camera");
}

}  // namespace
}  // namespace penpose::tracking
