#include "ui/render/gl/mesh/mesh_pass.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"
#include "ui/render/gl/framebuffers.h"
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
  const auto context = OffscreenContext::make(DrawWay::gl);
  ASSERT_TRUE(context.ok());
  auto pass = MeshPass::make(GlDialect{});
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

TEST(MeshPass, AMeshOfMoreVerticesThanIndicesTellApartLooksTheSame) {
  const auto context = OffscreenContext::make(DrawWay::es);
  ASSERT_TRUE(context.ok());
  GlDialect dialect = dialect_of_context(DrawWay::es).value();
  Shown shown(sphere_model(1));
  // One half is plain, the other has a look that one sees through, which is sorted for each view.
  document::Look look;
  look.surfaces.resize(1);
  look.surfaces[0].alpha = document::AlphaMode::blend;
  look.surfaces[0].base_color = {1, 0.2, 0.2, 0.5};
  Appearance appearance;
  appearance.surfaces.resize(1);
  appearance.look = std::make_shared<const document::Look>(look);
  const auto triangles = static_cast<std::uint32_t>(shown.scene().triangles.size());
  for (std::uint32_t t = triangles / 2; t < triangles; ++t) appearance.look_triangles.push_back(t);
  appearance.batches.push_back({0, 0, triangles - triangles / 2, 0.5F, 0, false});
  Scene scene = shown.scene();
  scene.appearance = &appearance;
  scene.wireframe = true;
  scene.shape_number = scene.pose_number = 1;
  std::vector<Image> pictures;
  for (const std::uint32_t most : {dialect.most_vertices, 65536U, 50U}) {
    dialect.most_vertices = most;
    auto pass = MeshPass::make(dialect);
    Framebuffers targets(dialect);
    ASSERT_TRUE(pass.ok() && targets.resize(128, 128).ok());
    // From one side and then from the other, so that order changes after all was sent.
    for (const double yaw : {0.0, 140.0}) {
      const View view = make_view(scene.positions, frame_points(scene.positions, {128, 128}, {yaw, 10}));
      ASSERT_TRUE(pass->upload(scene).ok());
      pass->order(scene, view);
      targets.begin_surfaces();
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      pass->draw_opaque(view, true);
      pass->draw_translucent(view);
      pictures.push_back(targets.read());
    }
  }
  EXPECT_GT(differing(pictures[0], pictures[1]), 500);
  for (std::size_t i = 2; i < pictures.size(); ++i) EXPECT_EQ(differing(pictures[i], pictures[i % 2], 0), 0) << i;
}

}  // namespace
}  // namespace penpose::render
