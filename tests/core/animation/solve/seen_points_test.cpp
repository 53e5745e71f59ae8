#include "core/animation/solve/seen_points.h"

#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::animation {
namespace {

TEST(SeenPoints, FollowThePoseInThePicture) {
  const auto mesh = tests::grid_mesh(1, 1);
  rig::BlendShape shape;
  shape.parameter.name = "up";
  shape.vertices = {2, 3};
  shape.deltas = {{0, 0.5F, 0}, {0, 0.5F, 0}};
  const auto rig =
      rig::CharacterRig::make(mesh, {rig::BlendShapes::make({shape}, mesh->vertex_count()).value()}, nullptr).value();
  const auto camera = geometry::frame_box({{0, 0, 0}, {1, 1, 0}}, {200, 200}, 0);
  const posing::CurvePoint middle{{2, 3, 0}, {0.5, 0.5, 0}};
  SeenPoints points(*rig, {middle, posing::at_vertex(0)}, camera);
  const auto at_rest = points.at(std::vector<double>{0.0});
  const auto moved = points.at(std::vector<double>{1.0});
  const auto wanted = camera.project({0.5, 1.5, 0}).value();
  EXPECT_LT(geometry::distance(moved[0], wanted), 1e-9);
  EXPECT_LT(geometry::distance(at_rest[0], camera.project({0.5, 1, 0}).value()), 1e-9);
  EXPECT_EQ(moved[1].y, at_rest[1].y);
}

}  // namespace
}  // namespace penpose::animation
