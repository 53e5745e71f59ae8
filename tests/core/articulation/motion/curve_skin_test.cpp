#include "core/articulation/motion/curve_skin.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

std::shared_ptr<const CurveMotion> quarter_turn(Mode mode) {
  return std::make_shared<const CurveMotion>(std::vector<ModelPoint>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                             std::vector<ModelPoint>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, mode);
}

std::vector<ModelVector> moves(const CurveSkin& skin, double amount) {
  CurveSkinWorkspace work;
  std::vector<ModelVector> out(skin.size());
  skin.displacements(amount, work, out);
  return out;
}

TEST(CurveSkin, TurnsVerticesAboutTheirPlaceOnTheCurve) {
  // A vertex above the middle of the second segment: half of that segment's quarter turn.
  const std::vector<ClosestBinding> bindings = {{1, 0.5, 1.0, {1.5, 0.2, 0}, glm::dmat3(1)},
                                                {1, 1.0, 1.0, {2, 0.2, 0}, glm::dmat3(1)}};
  const CurveSkin skin(quarter_turn(Mode::rotate), {}, bindings, false);
  EXPECT_FALSE(skin.linear());
  const auto out = moves(skin, 1.0);
  const double half = std::sqrt(0.5);
  EXPECT_LT(geometry::distance(bindings[0].rest + out[0], ModelPoint(1 - 0.2 * half, 0.5 + 0.2 * half, 0)), 1e-14);
  EXPECT_LT(geometry::distance(bindings[1].rest + out[1], ModelPoint(0.8, 1, 0)), 1e-14);
}

TEST(CurveSkin, TranslationIsLinearAndBlendsByWeight) {
  const std::vector<ClosestBinding> bindings = {{1, 0.5, 1.0, {1.5, 0.2, 0}, glm::dmat3(1)},
                                                {1, 0.5, 0.25, {1.5, -3, 0}, glm::dmat3(1)}};
  const CurveSkin skin(quarter_turn(Mode::translate), {}, bindings, false);
  ASSERT_TRUE(skin.linear());
  EXPECT_LT(geometry::distance(skin.columns()[0], ModelVector(-0.5, 0.5, 0)), 1e-15);
  EXPECT_LT(geometry::distance(skin.columns()[1], ModelVector(-0.125, 0.125, 0)), 1e-15);
  for (const double amount : {0.3, 1.0, -2.0}) {
    const auto out = moves(skin, amount);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(out[i], skin.columns()[i] * amount);
  }
}

TEST(CurveSkin, PartlyWeightedVerticesKeepTheirDistanceToo) {
  const tests::Eye eye = tests::make_eye();
  const Sphere ball{{1, 0, -1}, 1};
  const std::vector<ClosestBinding> bindings = {{0, 0.5, 0.4, {0.5, 0.1, 0.2}, glm::dmat3(1)},
                                                {1, 0.9, 0.6, {1.9, 0.1, 0.1}, glm::dmat3(1)}};
  for (const Mode mode : {Mode::translate, Mode::rotate}) {
    const CurveSkin skin(quarter_turn(mode), KeptSurface::make(ball, *eye.canvas).value(), bindings, false);
    EXPECT_FALSE(skin.linear());
    for (const double amount : {0.1, 0.5, 1.0}) {
      const auto out = moves(skin, amount);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(geometry::distance(bindings[i].rest + out[i], ball.center),
                    geometry::distance(bindings[i].rest, ball.center), 1e-12);
      }
    }
  }
}

TEST(CurveSkin, ASubsetMovesAsTheWholeDoesToTheBit) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto motion = quarter_turn(Mode::rotate);
  std::vector<ClosestBinding> bindings;
  for (std::uint32_t i = 0; i < 40; ++i) {
    bindings.push_back({i % 2, i / 40.0, 1.0 - i / 80.0, {i * 0.05, 0.1 * i, 0.3}, glm::dmat3(1)});
  }
  const CurveSkin whole(motion, {}, bindings, false);
  const std::vector<std::uint32_t> some = {7, 3, 38, 3};
  const CurveSkin part = whole.subset(some);
  const auto all = moves(whole, 0.37);
  const auto few = moves(part, 0.37);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(few[i], all[some[i]]);
}

}  // namespace
}  // namespace penpose::articulation
