#include "core/articulation/measured_deformer.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/articulation/measure/doubts.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Trunk;

base::Result<std::shared_ptr<const Deformer>> build(Sketch sketch, const Canvas& canvas) {
  return build_deformer(sketch, canvas);
}

/// A flat sheet around the origin, 4 units wide, that is seen from +z; with a hole where `holed`.
std::shared_ptr<const Canvas> sheet(bool holed = false) {
  mesh::MeshSource source;
  tests::add_grid(source, "sheet", 41, 41, false, [](std::uint32_t r, std::uint32_t c) {
    return ModelPoint{c * 0.1 - 2, r * 0.1 - 2, 0};
  });
  if (holed) {
    std::erase_if(source.triangles, [&](const mesh::Triangle& t) {
      const ModelPoint& p = source.positions[t[0]];
      return std::abs(p.x - 0.9) < 0.25 && std::abs(p.y) < 0.25;
    });
    source.parts.front().triangle_count = static_cast<std::uint32_t>(source.triangles.size());
  }
  return tests::canvas_of(std::move(source));
}

std::vector<PxPoint> box(double x, double y, double half) {
  // 100 px a unit, see camera() below.
  const auto at = [](double a, double b) { return PxPoint{500 + 100 * a, 500 - 100 * b}; };
  return {at(x - half, y - half), at(x + half, y - half), at(x + half, y + half), at(x - half, y + half)};
}

/// The middle of the sheet is taken by a line across it and brought up.
Sketch lift(double up, double turn = 0) {
  Sketch sketch;
  sketch.name = "lift";
  sketch.viewport = {1000, 1000};
  const double away = 5 / std::tan(15 * tests::k_degree);
  sketch.camera = {{0, 0, away}, {0, 0, 0}, {0, 1, 0}, 30};
  sketch.general = box(0, 0, 1.55);
  sketch.specific = box(0, 0, 0.55);
  for (int i = -4; i <= 4; ++i) {
    sketch.reference.push_back({500.0 + 10 * i, 500});
    const double angle = turn * tests::k_degree;
    sketch.target.push_back({500 + 10 * i * std::cos(angle), 500 - 100 * up - 10 * i * std::sin(angle)});
  }
  return sketch;
}

TEST(MeasuredDeformer, ReachesTheTargetEitherWay) {
  const auto canvas = sheet();
  for (const Mode mode : {Mode::translate, Mode::rotate}) {
    Sketch sketch = lift(0.3, 30);
    sketch.mode = mode;
    const auto deformer = build(sketch, *canvas).value();
    const auto reached = deformer->curve_at(1);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      EXPECT_LT(geometry::distance(reached[i], deformer->target()[i]), 1e-9);
      EXPECT_LT(geometry::distance(deformer->curve_at(0)[i], deformer->reference()[i]), 1e-9);
    }
    // The vertex in the middle of the line goes where the line's middle goes.
    const auto vertices = deformer->vertices();
    const auto middle = std::lower_bound(vertices.begin(), vertices.end(), 20U * 41U + 20U) - vertices.begin();
    const ModelVector moved = deformer->displacements(1)[static_cast<std::size_t>(middle)];
    const ModelVector way = (deformer->target()[15] + deformer->target()[16]) * 0.5 -
                            (deformer->reference()[15] + deformer->reference()[16]) * 0.5;
    EXPECT_LT(geometry::distance(moved, way), 1e-6);
  }
}

TEST(MeasuredDeformer, TakesTheWayThatDistortsLess) {
  const auto canvas = sheet();
  EXPECT_EQ(build(lift(0.3), *canvas).value()->mode(), Mode::translate);
  const auto swung = tests::make_trunk();
  EXPECT_EQ(build(swung.curl(), *swung.canvas).value()->mode(), Mode::rotate);
}

TEST(MeasuredDeformer, WeightsAreStraightOverTheSurfaceAndOneAtFreeEnds) {
  const auto canvas = sheet();
  const auto deformer = build(lift(0.2), *canvas).value();
  double half_way = 0;
  for (std::size_t i = 0; i < deformer->vertices().size(); ++i) {
    const ModelPoint& p = canvas->positions()[deformer->vertices()[i]];
    if (std::max(std::abs(p.x), std::abs(p.y)) < 0.54) {
      EXPECT_EQ(deformer->weights()[i], 1.0);
    }
    if (std::abs(p.x - 1.0) < 0.01 && std::abs(p.y) < 0.01) half_way = deformer->weights()[i];
  }
  // From 1 at 0.55 to 0 at 1.55.
  EXPECT_NEAR(half_way, 0.55, 0.03);
  const Trunk trunk = tests::make_trunk();
  const auto curl = build(trunk.curl(), *trunk.canvas).value();
  const auto last = curl->vertices().back();
  EXPECT_EQ(last, trunk.canvas->positions().size() - 1);
  EXPECT_EQ(curl->weights().back(), 1.0) << "the tip has nothing beyond it";
}

TEST(MeasuredDeformer, DoesNotDependOnTheDirectionOfItsLines) {
  const Trunk trunk = tests::make_trunk();
  Sketch sketch = trunk.curl();
  const auto one = build(sketch, *trunk.canvas).value();
  std::reverse(sketch.reference.begin(), sketch.reference.end());
  std::reverse(sketch.target.begin(), sketch.target.end());
  const auto other = build(sketch, *trunk.canvas).value();
  ASSERT_EQ(one->vertices().size(), other->vertices().size());
  const auto a = one->displacements(0.6);
  const auto b = other->displacements(0.6);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(geometry::distance(a[i], b[i]), 0.02);
}

TEST(MeasuredDeformer, TellsOfATargetThatNoSmoothMotionReaches) {
  const auto canvas = sheet();
  const auto near = build(lift(0.4), *canvas).value();
  EXPECT_TRUE(doubts_of(*near).empty());
  EXPECT_EQ(near->strain().turned_over, 0U);
  // Beyond the border of its region, which is 1 unit away.
  const auto far = build(lift(1.4), *canvas).value();
  ASSERT_EQ(doubts_of(*far).size(), 1U);
  EXPECT_GT(far->strain().turned_over + far->strain().creased, 0U);
  Sketch longer = lift(0.1);
  for (PxPoint& p : longer.target) p.x = 500 + 3 * (p.x - 500);
  ASSERT_FALSE(doubts_of(*build(longer, *canvas).value()).empty());
  EXPECT_NE(doubts_of(*build(longer, *canvas).value())[0].find("3.0 times as long"), std::string::npos);
  Sketch beyond = lift(0.1);
  beyond.specific = box(1.3, 0, 0.6);
  const auto doubts = doubts_of(*build(beyond, *canvas).value());
  ASSERT_FALSE(doubts.empty());
  EXPECT_NE(doubts[0].find("on its right"), std::string::npos) << doubts[0];
}

TEST(MeasuredDeformer, RefusesRegionsThatHoldNothing) {
  const auto canvas = sheet();
  Sketch outside = lift(0.2);
  outside.specific = box(1.8, 0, 0.1);
  const auto refused = build(outside, *canvas);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().place, "specific");
  EXPECT_NE(refused.error().what.find("right of"), std::string::npos) << refused.error().what;
  Sketch nothing = lift(0.2);
  nothing.general = box(4, 4, 0.3);
  EXPECT_EQ(build(nothing, *canvas).error().place, "general");
  mesh::MeshSource one;
  one.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  EXPECT_EQ(build(lift(0.2), *tests::canvas_of(std::move(one))).error().place, "general");
}

TEST(MeasuredDeformer, TakesHolesCoincidentVerticesAndAWholeModel) {
  const auto holed = build(lift(0.3), *sheet(true)).value();
  EXPECT_EQ(holed->strain().turned_over, 0U);
  mesh::MeshSource doubled;
  tests::add_grid(doubled, "sheet", 41, 41, false, [](std::uint32_t r, std::uint32_t c) {
    return ModelPoint{std::min(c, 39U) * 0.1 - 2, r * 0.1 - 2, 0};  // the last column lies on the one before it
  });
  Sketch right = lift(0.3);
  right.general = box(1, 0, 1.2);
  EXPECT_TRUE(build(right, *tests::canvas_of(std::move(doubled))).ok());
  Sketch whole = lift(0.3);
  whole.general = box(0, 0, 3);
  const auto all = build(whole, *sheet()).value();
  EXPECT_EQ(all->strain().turned_over, 0U);
  // It has no border: what is farthest hardly moves.
  ASSERT_EQ(all->vertices().front(), 0U);
  EXPECT_LT(all->weights().front(), 0.02);
}

}  // namespace
}  // namespace penpose::articulation
