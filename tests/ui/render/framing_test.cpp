#include "ui/render/framing.h"

#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

TEST(Framing, ShowsAllPointsWithAMarginOnTheTightSides) {
  for (const double radius : {1e-6, 1.0, 1e6}) {
    mesh::MeshSource source;
    add_box(source, {3 * radius, -radius, 0}, geometry::ModelVector{0.3, 1, 0.5} * radius);
    const auto points = to_float(source.positions);
    for (const double yaw : {0.0, 25.0, 90.0, 200.0}) {
      const auto camera = frame_points(points, {600, 400}, {yaw, 10});
      double top = 1e9;
      double bottom = -1e9;
      double left = 1e9;
      double right = -1e9;
      for (const auto& point : points) {
        const auto px = camera.project(geometry::ModelPoint(point));
        ASSERT_TRUE(px.has_value());
        top = std::min(top, px->y);
        bottom = std::max(bottom, px->y);
        left = std::min(left, px->x);
        right = std::max(right, px->x);
      }
      EXPECT_NEAR(top, 400.0 / 12, 0.01 * 400) << radius << " " << yaw;
      EXPECT_NEAR(bottom, 400.0 * 11 / 12, 0.01 * 400);
      EXPECT_GT(left, 600.0 / 12 - 1);
      EXPECT_LT(right, 600.0 * 11 / 12 + 1);
      EXPECT_NEAR(left + right, 600, 2);
    }
  }
}

TEST(Framing, SurvivesNothingAndOnePoint) {
  EXPECT_TRUE(frame_points({}, {100, 100}).project({0, 0, 0}).has_value());
  const std::vector<glm::vec3> one{{5, 5, 5}};
  const auto px = frame_points(one, {100, 100}).project({5, 5, 5});
  ASSERT_TRUE(px.has_value());
  EXPECT_NEAR(px->x, 50, 1);
}

TEST(Framing, KnowsItsViews) {
  EXPECT_EQ(find_viewpoint("front")->yaw_degrees, 0);
  EXPECT_EQ(find_viewpoint("side")->yaw_degrees, 90);
  EXPECT_TRUE(find_viewpoint("three-quarter").has_value());
  EXPECT_FALSE(find_viewpoint("behind").has_value());
}

/// A figure ten units high whose topmost sphere is moved by shapes; `all` of them move the feet as well, and the throat
/// below it by a share of that.
document::Model figure(bool all, float throat = 0) {
  mesh::MeshSource source;
  add_box(source, {0, 4, 0}, {1, 4, 0.5});
  const std::size_t body = source.positions.size();
  add_sphere(source, {0, 9, 0}, 0.8, 12);
  const std::size_t neck = source.positions.size();
  add_box(source, {0, 7, 0.7}, {0.1, 0.3, 0.05});
  const std::size_t neck_end = source.positions.size();
  const auto mesh = mesh::TriangleMesh::build(source).value();
  std::vector<rig::BlendShape> shapes;
  for (const char* name : {"jaw", "brow", "smile"}) {
    rig::BlendShape shape{{name, 0, 0, 1}, {}, {}, {}};
    if (all) shape.vertices.push_back(0);
    for (auto v = static_cast<std::uint32_t>(body); v < body + 60; ++v) shape.vertices.push_back(v);
    shape.deltas.assign(shape.vertices.size(), {0, -0.1F, 0});
    for (std::size_t v = neck; v < neck_end && throat > 0; ++v) {
      shape.vertices.push_back(static_cast<std::uint32_t>(v));
      shape.deltas.emplace_back(0, -0.1F * throat, 0);
    }
    shapes.push_back(std::move(shape));
  }
  return document::make_model(mesh, rig::BlendShapes::make(shapes, mesh->vertex_count()).value(), nullptr).value();
}

TEST(Framing, TheFaceOfAFigureIsWhereItsShapesWork) {
  const document::Model model = figure(false);
  const auto face = face_vertices(model);
  ASSERT_GE(face.size(), 60U);
  for (const std::uint32_t v : face) EXPECT_GT(model.mesh->positions()[v].y, 7.9);
  EXPECT_EQ(face_vertices(figure(false, 0.4F)), face) << "a throat that is taken along is no face";
  EXPECT_GT(face_vertices(figure(false, 1)).size(), face.size());
  EXPECT_TRUE(face_vertices(figure(true)).empty()) << "shapes of the whole body tell of no face";
  EXPECT_TRUE(face_vertices(sphere_model(1)).empty());
}

}  // namespace
}  // namespace penpose::render
