#include "core/document/time/animation_building.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/animation_sampling.h"
#include "tests/support/models/model_samples.h"

namespace penpose::document {
namespace {

Model two_shapes() {
  mesh::MeshSource source;
  tests::add_square(source, "a", 0);
  rig::BlendShape shape;
  shape.parameter.name = "up";
  shape.vertices = {0};
  shape.deltas = {{0, 0.5F, 0}};
  rig::BlendShape other = shape;
  other.parameter.name = "side";
  auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  auto shapes = rig::BlendShapes::make({shape, other}, mesh->vertex_count()).value();
  return make_model(mesh, shapes, nullptr).value();
}

TEST(AnimationBuilding, KeysGoThroughThePoses) {
  Model model = two_shapes();
  const std::vector<double> times{5.0, 5.5, 5.5, 6.0};
  const std::vector<rig::Pose> poses{{0, 0.5}, {1, 0.25}, {0.3, 0.3}, {0.5, 0}};
  model.animations = {make_animation(model, "talk", times, poses)};
  ASSERT_EQ(model.animations[0].channels.size(), 1U);
  EXPECT_EQ(model.animations[0].channels[0].times_s, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(sample(model, model.animations[0], 0.5).weights, (std::vector<double>{1, 0.25}));
  EXPECT_EQ(sample(model, model.animations[0], 0.75).weights, (std::vector<double>{0.75, 0.125}));
}

TEST(AnimationBuilding, AStandMovesTheWholeModelAboutItsPivot) {
  Model model = two_shapes();
  const auto rest = posed_positions(model);
  const std::vector<double> times{0, 1};
  const std::vector<rig::Pose> poses(2, rig::Pose{0, 0});
  model.animations = {make_animation(model, "talk", times, poses)};
  const double half = std::sqrt(0.5);
  const std::vector<Placement> placements{{}, {glm::dquat(half, 0, 0, half), {1, 2, 3}, 2}};
  const geometry::ModelPoint pivot(0.5, 0, 0);
  const auto moved = with_placements(std::move(model), 0, pivot, times, placements);
  ASSERT_TRUE(moved.ok());
  const auto end = model_at(*moved, sample(*moved, moved->animations[0], 1)).value();
  const auto positions = posed_positions(end);
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const auto p = rest[v] - pivot;
    const geometry::ModelPoint wanted =
        pivot + geometry::ModelPoint(1, 2, 3) + 2.0 * geometry::ModelPoint(-p.y, p.x, p.z);
    EXPECT_NEAR(geometry::distance(positions[v], wanted), 0, 1e-5);
  }
  const auto start = model_at(*moved, sample(*moved, moved->animations[0], 0)).value();
  for (std::size_t v = 0; v < rest.size(); ++v)
    EXPECT_NEAR(geometry::distance(posed_positions(start)[v], rest[v]), 0, 1e-6);
}

TEST(AnimationBuilding, AStandMovesTheVerticesThatNoJointCarriesToo) {
  Model bare = two_shapes();
  rig::Joint joint;
  joint.name = "head";
  const std::size_t count = bare.mesh->vertex_count();
  // The first vertex alone is carried, as eyes are that are children of the face's node.
  std::vector<std::uint32_t> first(count + 1, 1);
  first[0] = 0;
  auto skeleton = rig::Skeleton::make({joint}, std::move(first), {{0, 1.0}}).value();
  Model model = make_model(bare.mesh, bare.shapes, skeleton).value();
  const auto rest = posed_positions(model);
  const std::vector<double> times{0, 1};
  model.animations = {make_animation(model, "nod", times, std::vector<rig::Pose>(2, model.pose))};
  const std::vector<Placement> placements{{}, {glm::dquat(1, 0, 0, 0), {1, 2, 3}, 1}};
  const auto moved = with_placements(std::move(model), 0, geometry::ModelPoint(0), times, placements).value();
  const auto end = model_at(moved, sample(moved, moved.animations[0], 1)).value();
  const auto positions = posed_positions(end);
  for (std::size_t v = 0; v < rest.size(); ++v) {
    EXPECT_NEAR(geometry::distance(positions[v], rest[v] + geometry::ModelVector(1, 2, 3)), 0, 1e-5) << v;
  }
  EXPECT_EQ(moved.skeleton->joints().back().name, "head.2");
}

}  // namespace
}  // namespace penpose::document
