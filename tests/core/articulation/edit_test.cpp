#include "core/articulation/edit.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Trunk;

SketchedDeformers::Shared three(const Trunk& trunk) {
  std::vector<Sketch> sketches(3, trunk.curl());
  sketches[1].name = "second";
  sketches[2].name = "third";
  return SketchedDeformers::build(sketches, *trunk.canvas).value();
}

std::vector<std::string> names(const SketchedDeformers& set) {
  std::vector<std::string> all;
  for (const rig::Parameter& parameter : set.parameters()) all.push_back(parameter.name);
  return all;
}

TEST(Edit, RenamesDeletesReordersAndSharesTheRest) {
  const Trunk trunk = tests::make_trunk();
  const auto set = three(trunk);
  const auto renamed = with_name(*set, 1, "bend").value();
  EXPECT_EQ(names(*renamed), (std::vector<std::string>{"curl", "bend", "third"}));
  EXPECT_EQ(renamed->deformers()[0], set->deformers()[0]);
  EXPECT_EQ(names(*without(*set, 0).value()), (std::vector<std::string>{"second", "third"}));
  EXPECT_EQ(names(*moved(*set, 2, 0).value()), (std::vector<std::string>{"third", "curl", "second"}));
  EXPECT_EQ(names(*moved(*set, 0, 2).value()), (std::vector<std::string>{"second", "third", "curl"}));
  EXPECT_EQ(find_deformer(*set, "third"), 2U);
  EXPECT_EQ(find_deformer(*set, "fourth"), std::nullopt);
  EXPECT_EQ(names(*set), (std::vector<std::string>{"curl", "second", "third"}));  // nothing happened to it
}

TEST(Edit, RefusesWhatCannotBe) {
  const Trunk trunk = tests::make_trunk();
  const auto set = three(trunk);
  EXPECT_FALSE(with_name(*set, 1, "curl").ok());
  EXPECT_FALSE(with_name(*set, 1, "").ok());
  EXPECT_FALSE(with_name(*set, 3, "x").ok());
  EXPECT_FALSE(without(*set, 3).ok());
  EXPECT_FALSE(moved(*set, 0, 3).ok());
  EXPECT_FALSE(with_added(*set, set->deformers()[0]).ok());
}

TEST(Edit, ADeformerFollowsACurveDrawnAnew) {
  const Trunk trunk = tests::make_trunk();
  const auto set = three(trunk);
  const Sketch& sketch = set->deformers()[0]->sketch();
  // Up instead of down, from a camera that has moved.
  auto target = sketch.target;
  for (PxPoint& p : target) p.y = 1000 - p.y;
  geometry::CameraPose moved_camera = sketch.camera;
  moved_camera.eye.x += 2;
  auto redrawn_sketch = redrawn(sketch, CurveRole::target, target, moved_camera).value();
  EXPECT_TRUE(redrawn_sketch.target_camera.has_value());
  redrawn_sketch = redrawn(redrawn_sketch, CurveRole::target, target, sketch.camera).value();
  EXPECT_FALSE(redrawn_sketch.target_camera.has_value());
  const auto changed = with_sketch(*set, 0, redrawn_sketch, *trunk.canvas).value();
  EXPECT_GT(changed->deformers()[0]->target().back().y, 1.0);
  EXPECT_LT(set->deformers()[0]->target().back().y, -1.0);
  EXPECT_EQ(changed->deformers()[1], set->deformers()[1]);

  const auto inferred = redrawn(sketch, CurveRole::reference, {}, moved_camera).value();
  EXPECT_TRUE(build_deformer(inferred, *trunk.canvas).value()->inferred());
  EXPECT_FALSE(inferred.reference_camera.has_value());
  const auto smaller = redrawn(sketch, CurveRole::general, trunk.box(0.5, 3.5, 0.6), sketch.camera).value();
  const auto narrowed = with_sketch(*set, 0, smaller, *trunk.canvas).value();
  EXPECT_LT(narrowed->deformers()[0]->vertices().size(), set->deformers()[0]->vertices().size());
}

TEST(Edit, EveryCurveCanBeDrawnAnew) {
  const Trunk trunk = tests::make_trunk();
  const auto set = three(trunk);
  const Sketch& sketch = set->deformers()[1]->sketch();
  const auto redrawn_with = [&](CurveRole role, std::vector<PxPoint> points) {
    const auto other = redrawn(sketch, role, std::move(points), sketch.camera).value();
    return with_sketch(*set, 1, other, *trunk.canvas).value()->deformers()[1];
  };
  const auto at_full_weight = [](const Deformer& deformer) {
    return std::count(deformer.weights().begin(), deformer.weights().end(), 1.0);
  };
  const Deformer& before = *set->deformers()[1];
  const auto general = redrawn_with(CurveRole::general, trunk.box(0.5, 3.5, 0.6));
  EXPECT_LT(general->vertices().size(), before.vertices().size());
  const auto specific = redrawn_with(CurveRole::specific, trunk.box(2.0, 3.4, 0.5));
  EXPECT_EQ(specific->vertices().size(), before.vertices().size());
  EXPECT_LT(at_full_weight(*specific), at_full_weight(before));
  const auto reference = redrawn_with(CurveRole::reference, {trunk.seen({1.2, 0, 0.2}), trunk.seen({2.9, 0, 0.2})});
  EXPECT_GT(reference->reference().front().x, before.reference().front().x + 0.1);
  std::vector<PxPoint> up = sketch.target;
  for (PxPoint& p : up) p.y = 1000 - p.y;
  EXPECT_GT(redrawn_with(CurveRole::target, up)->target().back().y, before.target().back().y + 1.0);
  for (const auto& one : {general, specific, reference}) EXPECT_EQ(one->sketch().name, "second");
}

TEST(Edit, BothRegionsBelongToOneCamera) {
  const Trunk trunk = tests::make_trunk();
  const Sketch sketch = trunk.curl();
  geometry::CameraPose other = sketch.camera;
  other.eye.y += 1;
  EXPECT_EQ(redrawn(sketch, CurveRole::general, sketch.general, other).error().place, "camera");
  EXPECT_EQ(redrawn(sketch, CurveRole::specific, sketch.specific, other).error().place, "camera");
}

TEST(Edit, MirrorsAtTheEnd) {
  mesh::MeshSource source;
  for (const double side : {1.0, -1.0}) {
    tests::add_grid(source, "tusk", Trunk::k_rings, Trunk::k_around, true, [&](std::uint32_t r, std::uint32_t c) {
      ModelPoint p = Trunk::at(r, c);
      return ModelPoint((p.x + 4) * side, p.y, p.z);
    });
  }
  const auto canvas = tests::canvas_of(std::move(source));
  Sketch sketch = tests::make_trunk().curl();
  sketch.name = "tusk_L";
  sketch.camera.eye.x += 4;
  sketch.camera.look_at.x += 4;
  const auto set = SketchedDeformers::build(std::vector{sketch}, *canvas).value();
  const auto both = with_mirrored(*set, 0, *canvas).value();
  EXPECT_EQ(names(*both), (std::vector<std::string>{"tusk_L", "tusk_R"}));
  EXPECT_EQ(both->deformers()[0], set->deformers()[0]);
  EXPECT_FALSE(with_mirrored(*both, 0, *canvas).ok());  // the right one is there
}

}  // namespace
}  // namespace penpose::articulation
