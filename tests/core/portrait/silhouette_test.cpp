#include "core/portrait/silhouette.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/math.h"

namespace penpose::portrait {
namespace {

using geometry::ModelPoint;

void add_sphere(mesh::MeshSource& source, const ModelPoint& centre, double radius) {
  constexpr std::uint32_t k_rings = 24, k_segments = 48;
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  for (std::uint32_t r = 0; r <= k_rings; ++r) {
    const double polar = base::k_pi * r / k_rings;
    const double across = r == 0 || r == k_rings ? 0.0 : base::sin(polar);
    for (std::uint32_t s = 0; s < k_segments; ++s) {
      const double around = 2.0 * base::k_pi * s / k_segments;
      source.positions.push_back(
          centre + ModelPoint{across * base::cos(around), base::cos(polar), across * base::sin(around)} * radius);
    }
  }
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return first + r * k_segments + s % k_segments; };
  for (std::uint32_t r = 0; r < k_rings; ++r) {
    for (std::uint32_t s = 0; s < k_segments; ++s) {
      if (r > 0) source.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      if (r + 1 < k_rings) source.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
  }
}

struct Scene {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<SurfaceLine> lines;

  explicit Scene(mesh::MeshSource source) {
    mesh = mesh::TriangleMesh::build(std::move(source)).value();
    const auto camera = geometry::Camera::make({{0.3, 0.2, 10}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value();
    const std::vector<glm::vec3> floats(mesh->positions().begin(), mesh->positions().end());
    lines = silhouette(camera, *mesh, mesh->positions(), geometry::TriangleBvh(floats, mesh->triangles()));
  }
  [[nodiscard]] ModelPoint place(const posing::CurvePoint& p) const {
    return mesh->positions()[p.vertex[0]] * p.weight[0] + mesh->positions()[p.vertex[1]] * p.weight[1];
  }
};

TEST(Silhouette, OfASphereIsOneClosedCircle) {
  mesh::MeshSource source;
  add_sphere(source, {0, 0, 0}, 1);
  const Scene scene(std::move(source));
  ASSERT_EQ(scene.lines.size(), 1U);
  const SurfaceLine& line = scene.lines.front();
  EXPECT_GT(line.size(), 48U);
  EXPECT_LT(geometry::distance(scene.place(line.front()), scene.place(line.back())), 1e-9);
  const ModelPoint eye{0.3, 0.2, 10};
  for (const posing::CurvePoint& p : line) {
    const ModelPoint place = scene.place(p);
    // Where the way to the eye is a tangent: p . eye = r^2.
    EXPECT_NEAR(place.x * eye.x + place.y * eye.y + place.z * eye.z, 1.0, 0.4);
    EXPECT_NEAR(geometry::length(place), 1.0, 0.01);
  }
}

TEST(Silhouette, LeavesOutWhatIsHidden) {
  mesh::MeshSource source;
  add_sphere(source, {0, 0, 2}, 1);
  add_sphere(source, {0.9, 0, -2}, 1);
  const Scene scene(std::move(source));
  bool far_side = false;
  for (const SurfaceLine& line : scene.lines) {
    for (const posing::CurvePoint& p : line) {
      const ModelPoint place = scene.place(p);
      if (place.z > 0.0) continue;
      far_side = true;
      EXPECT_GT(place.x, 0.5);
    }
  }
  EXPECT_TRUE(far_side);
}

TEST(Silhouette, GoesOnToWhatHidesItAndKeepsTheSurfaceOnOneSide) {
  mesh::MeshSource source;
  add_sphere(source, {0, 0, 2}, 1);
  add_sphere(source, {0.9, 0, -2}, 1);
  const Scene scene(std::move(source));
  ASSERT_EQ(scene.lines.size(), 2U);
  const auto camera = geometry::Camera::make({{0.3, 0.2, 10}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value();
  const auto px = [&](const posing::CurvePoint& p) {
    return camera.project(place_of(p, scene.mesh->positions())).value();
  };
  const SurfaceLine& front = scene.lines[0];
  const SurfaceLine& behind = scene.lines[1];
  ASSERT_EQ(front.front().vertex, front.back().vertex) << "nothing hides the nearer one";
  for (const posing::CurvePoint& end : {behind.front(), behind.back()}) {
    double nearest = 1e300;
    for (const posing::CurvePoint& p : front) nearest = std::min(nearest, geometry::distance(px(p), px(end)));
    EXPECT_LT(nearest, 12.0) << "px to the contour that hides it";
  }
  // Both go round the same way: twice the area that they go around has one sign.
  const auto area = [&](const SurfaceLine& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto a = px(line[i - 1]), b = px(line[i]);
      sum += a.x * b.y - a.y * b.x;
    }
    return sum;
  };
  EXPECT_GT(area(front) * (area(behind) + px(behind.back()).x * px(behind.front()).y -
                           px(behind.back()).y * px(behind.front()).x),
            0.0);
}

TEST(Silhouette, PointBetweenTwoPointsOfATriangle) {
  const posing::CurvePoint a{{4, 7, 0}, {0.25, 0.75, 0}}, b{{4, 9, 0}, {0.5, 0.5, 0}};
  const posing::CurvePoint p = point_between(a, b, 0.5);
  EXPECT_EQ(p.vertex, (std::array<std::uint32_t, 3>{4, 7, 9}));
  EXPECT_EQ(p.weight, (std::array<double, 3>{0.375, 0.375, 0.25}));
}

TEST(Silhouette, OfAFlatSheetThatFacesTheCameraIsNothing) {
  mesh::MeshSource source;
  source.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(Scene(std::move(source)).lines.empty());
}

}  // namespace
}  // namespace penpose::portrait
