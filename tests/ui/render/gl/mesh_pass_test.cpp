#include "ui/render/gl/mesh_pass.h"

#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"
#include "ui/render/gl/offscreen_context.h"

namespace penpose::render {
namespace {

TEST(MeshPass, ViewBringsAnyModelToTheSameNumbers) {
  const auto project = [](const View& view, const glm::vec3& p) {
    return view.to_clip * (view.to_view * glm::vec4((p - view.middle) * view.scale, 1));
  };
  for (const double size : {1e-9, 1.0, 1e9}) {
    mesh::MeshSource source;
    add_box(source, geometry::ModelPoint{100, 0, 0} * size, geometry::ModelVector{1, 2, 3} * size);
    const auto points = to_float(source.positions);
    const auto camera = frame_points(points, {300, 200});
    const View view = make_view(points, camera);
    for (const auto& p : points) {
      const glm::vec4 clip = project(view, p);
      const auto px = camera.project(geometry::ModelPoint(p));
      EXPECT_NEAR((clip.x / clip.w + 1) * 150, px->x, 0.02) << size;
      EXPECT_NEAR((1 - clip.y / clip.w) * 100, px->y, 0.02) << size;
      EXPECT_LT(std::abs(clip.z), clip.w) << "between the near and the far plane";
      const float depth = clip.z / clip.w * 0.5F + 0.5F;
      const float z = 1 / (view.depth_to_z.x * depth + view.depth_to_z.y);
      EXPECT_NEAR(z, camera.depth(geometry::ModelPoint(p)) * static_cast<double>(view.scale), 1e-3);
    }
  }
}

TEST(MeshPass, ArraysThatDoNotFitAreRefused) {
  const auto context = OffscreenContext::make();
  ASSERT_TRUE(context.ok());
  auto pass = MeshPass::make();
  ASSERT_TRUE(pass.ok());
  const Shown shown(sphere_model(1));
  EXPECT_TRUE(pass->upload(shown.scene()).ok());
  Scene scene = shown.scene();
  scene.normals = scene.normals.subspan(1);
  EXPECT_FALSE(pass->upload(scene).ok());
  scene = shown.scene();
  scene.positions = scene.positions.subspan(1);
  scene.normals = scene.normals.subspan(1);
  EXPECT_FALSE(pass->upload(scene).ok()) << "a triangle uses the vertex that is gone";
  scene = shown.scene();
  const Appearance wrong{{}, {}, {}, {}};
  scene.appearance = &wrong;
  EXPECT_FALSE(pass->upload(scene).ok());
}

}  // namespace
}  // namespace penpose::render
