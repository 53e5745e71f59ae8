#include <algorithm>
#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/articulation/mirror.h"
#include "core/articulation/motion/knots.h"
#include "core/articulation/sketched_deformers.h"
#include "tests/support/models/articulation_models.h"

// Deformers with more than one target.

namespace penpose::articulation {
namespace {

using tests::Trunk;

Sketch curl(const Trunk& trunk) {
  Sketch sketch = trunk.curl();
  return sketch;
}

/// The same with its half-way target up instead of down.
Sketch with_between(const Trunk& trunk, double value) {
  Sketch sketch = curl(trunk);
  Between up{value, {}, std::nullopt};
  for (const PxPoint& p : sketch.reference) up.target.push_back({p.x, p.y - 0.15 * (p.x - sketch.reference.front().x)});
  sketch.betweens = {up};
  return sketch;
}

TEST(Knots, CountFullyAtTheirOwnAmountAndNotAtTheNeighbours) {
  const auto knots = knots_of(std::vector<double>{-1, 0.25, 0.5});
  ASSERT_EQ(knots.size(), 3U);
  for (const Knot& knot : knots) {
    EXPECT_EQ(knot.weight(knot.amount), 1);
    EXPECT_EQ(knot.weight(0), 0);
    EXPECT_EQ(knot.weight(1), 0);
  }
  EXPECT_EQ(knots[1].weight(0.5), 0);
  EXPECT_NEAR(knots[1].weight(0.125), 0.5, 1e-15);
  EXPECT_NEAR(knots[2].weight(0.75), 0.5, 1e-15);
  EXPECT_EQ(knots[0].weight(-2), 2) << "nothing lies beyond: it goes on as it came";
  EXPECT_EQ(knots_of(std::vector<double>{2})[0].weight(3), 2);
  EXPECT_EQ(knots_of(std::vector<double>{2})[0].weight(0.5), 0);
}

TEST(Between, IsReachedAtItsValueAndLeavesTheOwnTargetAlone) {
  const Trunk trunk = tests::make_trunk();
  const auto plain = build_deformer(curl(trunk), *trunk.canvas).value();
  const auto both = build_deformer(with_between(trunk, 0.5), *trunk.canvas).value();
  ASSERT_EQ(both->betweens().size(), 1U);
  const auto at_half = both->curve_at(0.5);
  const auto at_one = both->curve_at(1);
  for (std::size_t i = 0; i < at_half.size(); ++i) {
    EXPECT_LT(geometry::distance(at_half[i], both->betweens()[0][i]), 1e-9);
    EXPECT_LT(geometry::distance(at_one[i], plain->target()[i]), 1e-9);
  }
  EXPECT_GT(both->betweens()[0].back().y, 0.1) << "half-way it is up";
  EXPECT_LT(both->target().back().y, -0.5);
  // At its own target every vertex is where it was without the other one; at rest nothing has moved.
  const auto moved = both->displacements(1);
  const auto before = plain->displacements(1);
  for (std::size_t i = 0; i < plain->vertices().size(); ++i) {
    const auto at = std::lower_bound(both->vertices().begin(), both->vertices().end(), plain->vertices()[i]);
    ASSERT_TRUE(at != both->vertices().end() && *at == plain->vertices()[i]);
    EXPECT_LT(geometry::distance(moved[static_cast<std::size_t>(at - both->vertices().begin())], before[i]), 1e-9);
  }
  for (const ModelVector& move : both->displacements(0)) EXPECT_EQ(move, ModelVector{0});
}

TEST(Between, IsWhatADeformerOfThatTargetAloneDoes) {
  const Trunk trunk = tests::make_trunk();
  const Sketch sketch = with_between(trunk, 0.4);
  const auto both = build_deformer(sketch, *trunk.canvas).value();
  Sketch alone = sketch;
  alone.target = sketch.betweens[0].target;
  alone.betweens.clear();
  const auto other = build_deformer(alone, *trunk.canvas).value();
  const auto moved = both->displacements(0.4);
  const auto wanted = other->displacements(1);
  double tip = 0;
  for (std::size_t i = 0; i < other->vertices().size(); ++i) {
    const auto at = std::lower_bound(both->vertices().begin(), both->vertices().end(), other->vertices()[i]);
    const double off = geometry::distance(moved[static_cast<std::size_t>(at - both->vertices().begin())], wanted[i]);
    tip = std::max(tip, off);
  }
  // The line is read on the curve where the control has it, so that along it points may lie a little elsewhere.
  EXPECT_LT(tip, 0.35);
}

TEST(Between, TurnsNothingOverOnItsWay) {
  const Trunk trunk = tests::make_trunk();
  EXPECT_EQ(build_deformer(with_between(trunk, 0.5), *trunk.canvas).value()->strain().turned_over, 0U);
}

TEST(Between, IsEvaluatedAtAFewVerticesAsAtAll) {
  const Trunk trunk = tests::make_trunk();
  const auto deformer = build_deformer(with_between(trunk, 0.5), *trunk.canvas).value();
  const auto set = SketchedDeformers::make({deformer}).value();
  const std::vector<std::uint32_t> some{deformer->vertices()[10], deformer->vertices()[100], 0};
  const auto bound = set->bind(some);
  std::vector<ModelVector> all(trunk.canvas->positions().size(), ModelVector{0});
  const std::vector<double> value{0.3};
  set->add(value, all);
  std::vector<ModelVector> few(some.size(), ModelVector{0});
  bound->add(value, few);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(few[i], all[some[i]]);
  std::vector<ModelVector> column(some.size());
  EXPECT_FALSE(bound->column(0, column)) << "it goes round a corner";
}

TEST(Between, IsMirroredWithItsDeformer) {
  const Trunk trunk = tests::make_trunk();
  const Sketch other = mirrored(with_between(trunk, 0.5), {0});
  ASSERT_EQ(other.betweens.size(), 1U);
  EXPECT_NEAR(other.betweens[0].target.back().x, 1000 - with_between(trunk, 0.5).betweens[0].target.back().x, 1e-9);
}

TEST(Between, BadOnesAreRefusedWithTheirPlace) {
  const Trunk trunk = tests::make_trunk();
  const auto place_of = [&](const Sketch& sketch) {
    const auto built = build_deformer(sketch, *trunk.canvas);
    return built ? std::string("none") : built.error().place;
  };
  EXPECT_EQ(place_of(with_between(trunk, 0.5)), "none");
  EXPECT_EQ(place_of(with_between(trunk, 0)), "betweens/0/value");
  EXPECT_EQ(place_of(with_between(trunk, 1)), "betweens/0/value");
  EXPECT_EQ(place_of(with_between(trunk, 1.5)), "betweens/0/value") << "out of the range";
  Sketch twice = with_between(trunk, 0.5);
  twice.betweens.push_back(twice.betweens[0]);
  EXPECT_EQ(place_of(twice), "betweens/1/value");
  Sketch empty = with_between(trunk, 0.5);
  empty.betweens[0].target.clear();
  EXPECT_EQ(place_of(empty), "betweens/0/target");
  Sketch point = with_between(trunk, 0.5);
  point.betweens[0].target = {{500, 500}, {500, 500}};
  EXPECT_TRUE(place_of(point).starts_with("betweens/0/target"));
  Sketch paper = with_between(trunk, 0.5);
  paper.paper = true;
  EXPECT_EQ(place_of(paper), "betweens");
}

}  // namespace
}  // namespace penpose::articulation
