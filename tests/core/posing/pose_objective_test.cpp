#include "core/posing/pose_objective.h"

#include <gtest/gtest.h>

#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

/// A linear problem with ranges other than 0..1 and a start away from rest.
struct Setting {
  std::shared_ptr<const mesh::TriangleMesh> mesh = tests::grid_mesh(30, 30);
  std::shared_ptr<const rig::CharacterRig> rig;
  PoseProblem problem;
  std::unique_ptr<CurveSystem> system;
  Variables variables;
  LinearModel model;

  explicit Setting(double near_weight) {
    const auto made = tests::random_shapes(*mesh, 12, 4);
    std::vector<rig::BlendShape> shapes(made->shapes().begin(), made->shapes().end());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      shapes[i].parameter.minimum = -0.5 * static_cast<double>(i % 3);
      shapes[i].parameter.maximum = 1 + static_cast<double>(i % 2);
    }
    rig =
        rig::CharacterRig::make(mesh, {rig::BlendShapes::make(shapes, mesh->vertex_count()).value()}, nullptr).value();
    tests::Random random(5);
    problem.start = tests::random_pose(*rig, random);
    CurvePair pair;
    pair.reference = tests::Sheet::row(14);
    for (std::size_t i = 0; i < 31; ++i) pair.target.push_back(random.vector(1));
    pair.weights.assign(31, 1.5);
    problem.pairs.push_back(pair);
    for (std::size_t i = 0; i < 12; i += 1 + i % 2) problem.free.push_back(i);
    system = std::make_unique<CurveSystem>(*rig, problem);
    variables = make_variables(*rig, problem.free, problem.start);
    variables.opposed = {{0, 2, 0.4}, {1, 4, 0.25}};
    for (std::size_t i = 0; i < variables.count(); ++i) variables.opposed_from.push_back(0.1 * static_cast<double>(i));
    variables.opposed_weight = 0.7;
    model = make_linear_model(*system, problem.start, variables, system->columns(problem.start, problem.free).value(),
                              near_weight);
  }

  /// E(x) + near * (sum (u - start)^2 + 0.7 times the sum of 2 share (u_a - from_a) (u_b - from_b)), straight from the
  /// rig.
  [[nodiscard]] double value(const std::vector<double>& u) const {
    rig::Pose pose = problem.start;
    double near = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      pose[problem.free[i]] = variables.value(i, u[i]);
      near += (u[i] - variables.start[i]) * (u[i] - variables.start[i]);
    }
    for (const Opposed& pair : variables.opposed) {
      const double a = u[pair.a] - variables.opposed_from[pair.a];
      near += 0.7 * 2 * pair.share * a * (u[pair.b] - variables.opposed_from[pair.b]);
    }
    Residuals residuals(system->residual_count());
    system->residuals(pose, residuals);
    return system->energy(residuals) + model.near_weight * near;
  }
};

TEST(Variables, RunFromZeroToOneOverTheRange) {
  const Setting s(0);
  for (std::size_t i = 0; i < s.variables.count(); ++i) {
    const rig::Parameter& p = s.rig->parameters()[s.problem.free[i]];
    EXPECT_EQ(s.variables.parameter[i], s.problem.free[i]);
    EXPECT_EQ(s.variables.value(i, 0), p.minimum);
    EXPECT_NEAR(s.variables.value(i, 1), p.maximum, 1e-15);
    EXPECT_NEAR(s.variables.value(i, s.variables.start[i]), s.problem.start[s.problem.free[i]], 1e-15);
  }
}

TEST(LinearModel, ItsResidualsAreThoseOfTheRig) {
  const Setting s(0);
  tests::Random random(6);
  Residuals fast(s.system->residual_count());
  Residuals exact(s.system->residual_count());
  for (int run = 0; run < 10; ++run) {
    std::vector<double> u;
    rig::Pose pose = s.problem.start;
    for (std::size_t i = 0; i < s.variables.count(); ++i) {
      u.push_back(random.index(4) == 0 ? 0.0 : random(0, 1));
      pose[s.problem.free[i]] = s.variables.value(i, u.back());
    }
    s.model.residuals(u, fast);
    s.system->residuals(pose, exact);
    for (std::size_t i = 0; i < fast.size(); ++i) EXPECT_NEAR(fast[i], exact[i], 1e-12);
  }
}

TEST(PoseObjective, BothFormsGiveTheEnergyAndThePullToTheStart) {
  const Setting s(0.37);
  const auto linear = make_linear_objective(s.model);
  const auto general = make_general_objective(*s.system, s.variables, s.problem.start, s.model.near_weight);
  EXPECT_EQ(linear->image_size(), s.system->residual_count());
  EXPECT_EQ(general->image_size(), 0U);
  std::vector<std::size_t> all(s.variables.count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  tests::Random random(7);
  std::vector<double> image(linear->image_size());
  for (int run = 0; run < 10; ++run) {
    std::vector<double> u;
    for (std::size_t i = 0; i < all.size(); ++i) u.push_back(random(0, 1));
    const double expected = s.value(u);
    for (PoseObjective* objective : {linear.get(), general.get()}) {
      objective->select(all, s.variables.start);
      EXPECT_EQ(objective->dimension(), all.size());
      objective->make_image(u, image);
      EXPECT_NEAR(objective->value(u, image), expected, 1e-10);
    }
  }
}

TEST(PoseObjective, TheOthersStandWhereTheyWereSelected) {
  const Setting s(0);
  const auto linear = make_linear_objective(s.model);
  const auto general = make_general_objective(*s.system, s.variables, s.problem.start, 0);
  tests::Random random(8);
  std::vector<double> image(linear->image_size());
  for (int run = 0; run < 10; ++run) {
    std::vector<double> at;
    for (std::size_t i = 0; i < s.variables.count(); ++i) at.push_back(random(0, 1));
    const std::vector<std::size_t> subset{random.index(3), 3 + random.index(3)};
    const std::vector<double> u{random(0, 1), random(0, 1)};
    std::vector<double> whole = at;
    whole[subset[0]] = u[0];
    whole[subset[1]] = u[1];
    for (PoseObjective* objective : {linear.get(), general.get()}) {
      objective->select(subset, at);
      objective->make_image(u, image);
      EXPECT_NEAR(objective->value(u, image), s.value(whole), 1e-10);
    }
  }
}

TEST(PoseObjective, APairOfWhichOneVariableStandsStillCountsToo) {
  const Setting s(0.37);
  const auto linear = make_linear_objective(s.model);
  const auto general = make_general_objective(*s.system, s.variables, s.problem.start, s.model.near_weight);
  std::vector<double> at = s.variables.start;
  at[2] = at[2] < 0.5 ? 1 : 0;
  std::vector<double> image(linear->image_size());
  const std::vector<std::size_t> subset{0};
  std::vector<double> whole = at;
  const auto value = [&](PoseObjective& objective, double u) {
    objective.select(subset, at);
    objective.make_image(std::vector<double>{u}, image);
    return objective.value(std::vector<double>{u}, image);
  };
  const auto expected = [&](double u) {
    whole[0] = u;
    return s.value(whole);
  };
  for (PoseObjective* objective : {linear.get(), general.get()}) {
    EXPECT_NEAR(value(*objective, 0.9) - value(*objective, 0.1), expected(0.9) - expected(0.1), 1e-10);
  }
}

TEST(PoseObjective, AnImageMovesAlongWithAVariable) {
  const Setting s(0.1);
  const auto linear = make_linear_objective(s.model);
  const std::vector<std::size_t> subset{1, 4, 5};
  linear->select(subset, s.variables.start);
  std::vector<double> carried(linear->image_size());
  std::vector<double> fresh(linear->image_size());
  linear->make_image(std::vector<double>{0.2, 0.3, 0.4}, carried);
  linear->shift_image(1, 0.5, carried);
  linear->make_image(std::vector<double>{0.2, 0.8, 0.4}, fresh);
  for (std::size_t i = 0; i < fresh.size(); ++i) EXPECT_NEAR(carried[i], fresh[i], 1e-13);
}

}  // namespace
}  // namespace penpose::posing
