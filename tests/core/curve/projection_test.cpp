#include "core/curve/projection.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::curve {
namespace {

/// A surface seen by a camera that looks down z at 0..1 x 0..1 in z = 0: 1 unit is 500 px, (0, 0) is at px (250, 750).
struct View {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  geometry::TriangleBvh surface;
  geometry::Camera camera;

  explicit View(std::shared_ptr<const mesh::TriangleMesh> m)
      : mesh(std::move(m)),
        surface(floats(*mesh), mesh->triangles()),
        camera(geometry::Camera::make({{0.5, 0.5, 1}, {0.5, 0.5, 0}, {0, 1, 0}, 90}, {1000, 1000}).value()) {}

  static std::vector<glm::vec3> floats(const mesh::TriangleMesh& mesh) {
    std::vector<glm::vec3> positions;
    for (const ModelPoint& p : mesh.positions()) positions.emplace_back(p);
    return positions;
  }
  [[nodiscard]] ModelPoint at(const mesh::MeshPoint& point) const {
    return mesh::position_of(point, mesh->triangles(), mesh->positions());
  }
};

std::vector<PxPoint> straight(PxPoint from, PxPoint to, int steps) {
  std::vector<PxPoint> line;
  for (int i = 0; i <= steps; ++i) line.push_back(from + (to - from) * (static_cast<double>(i) / steps));
  return line;
}

TEST(ProjectStroke, GluesEverySampleUnderThePen) {
  const View view(tests::grid_mesh(8, 8));
  const auto stroke = straight({300, 700}, {700, 300}, 20);
  const auto projected = project_stroke(stroke, view.camera, view.surface).value();
  ASSERT_EQ(projected.points.size(), stroke.size());
  EXPECT_EQ(projected.dropped, 0U);
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    EXPECT_EQ(projected.samples[i], i);
    EXPECT_NEAR(geometry::distance(projected.positions[i], view.at(projected.points[i])), 0, 1e-9);
    EXPECT_NEAR(projected.positions[i].z, 0, 1e-9);
    const PxPoint px = view.camera.project(projected.positions[i]).value();
    EXPECT_NEAR(geometry::distance(px, stroke[i]), 0, 1e-6);
    double sum = 0;
    for (const double b : projected.points[i].barycentric) sum += b;
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(ProjectStroke, TakesTheFaceThatIsVisible) {
  const View view(tests::ball_mesh(20, 20, 0.4));  // about the origin, which is at px (250, 750)
  const auto projected = project_stroke(straight({240, 745}, {262, 756}, 6), view.camera, view.surface).value();
  for (const ModelPoint& p : projected.positions) EXPECT_GT(p.z, 0.2) << "the near side of the ball";
}

TEST(ProjectStroke, DropsSamplesThatMissAndSaysHowMany) {
  const View view(tests::grid_mesh(4, 4));
  const auto stroke = straight({150, 500}, {450, 500}, 30);  // the mesh begins at x = 250
  const auto projected = project_stroke(stroke, view.camera, view.surface).value();
  EXPECT_EQ(projected.points.size() + projected.dropped, stroke.size());
  EXPECT_GE(projected.dropped, 9U);
  EXPECT_LE(projected.dropped, 11U);
  EXPECT_EQ(projected.samples.back(), 30U);
}

TEST(ProjectStroke, KeepsTheLongestRunOfSeveral) {
  const View view(tests::grid_mesh(4, 4));
  std::vector<PxPoint> stroke = straight({260, 400}, {300, 400}, 40);  // many samples, but 40 px
  stroke.push_back({100, 400});
  for (const PxPoint& p : straight({300, 600}, {700, 600}, 10)) stroke.push_back(p);  // few samples, 400 px
  stroke.push_back({900, 600});
  for (const PxPoint& p : straight({700, 500}, {650, 500}, 10)) stroke.push_back(p);
  const auto projected = project_stroke(stroke, view.camera, view.surface).value();
  ASSERT_EQ(projected.points.size(), 11U);
  EXPECT_EQ(projected.samples.front(), 42U);
  EXPECT_EQ(projected.samples.back(), 52U);
  EXPECT_EQ(projected.dropped, stroke.size() - 11);
}

TEST(ProjectStroke, SamplesInOnePlaceGiveOnePoint) {
  const View view(tests::grid_mesh(4, 4));
  const std::vector<PxPoint> stroke{{400, 400}, {400, 400}, {400, 400}, {420, 400}, {420, 400}};
  const auto projected = project_stroke(stroke, view.camera, view.surface).value();
  EXPECT_EQ(projected.samples, (std::vector<std::size_t>{0, 3}));
}

TEST(ProjectStroke, TellsWhenTheLineDoesNotTouchTheMesh) {
  const View view(tests::grid_mesh(4, 4));
  const auto what = [&](std::vector<PxPoint> stroke) {
    const auto projected = project_stroke(stroke, view.camera, view.surface);
    return projected ? std::string("projected") : projected.error().what;
  };
  const std::string no_touch = "the line does not touch the mesh";
  EXPECT_EQ(what({}), no_touch);
  EXPECT_EQ(what(straight({10, 10}, {200, 10}, 10)), no_touch);
  EXPECT_EQ(what({{400, 400}}), no_touch);
  EXPECT_EQ(what({{400, 400}, {400, 400}}), no_touch);
  EXPECT_EQ(what({{400, 400}, {10, 10}, {500, 400}}), no_touch) << "two runs of one point";
}

TEST(ProjectStroke, AnythingDrawnIsACurveOrAnError) {
  const View view(tests::ball_mesh(10, 10, 0.6));
  tests::Random random(17);
  int hit = 0;
  for (int run = 0; run < 300; ++run) {
    std::vector<PxPoint> stroke;
    const std::size_t size = random.index(12);
    for (std::size_t i = 0; i < size; ++i) {
      PxPoint p{random(0, 700), random(400, 1000)};
      if (random.index(12) == 0) p.x = random.index(2) == 0 ? NAN : 1e300;
      if (random.index(12) == 0) p.y = random.index(2) == 0 ? -INFINITY : NAN;
      stroke.push_back(p);
    }
    const auto projected = project_stroke(stroke, view.camera, view.surface);
    const auto curve = surface_curve(stroke, 2 + random.index(30), view.camera, view.surface);
    if (!projected) {
      EXPECT_FALSE(curve);
      continue;
    }
    ++hit;
    EXPECT_GE(projected->points.size(), 2U);
    for (const auto& part : {std::cref(*projected), std::cref(*curve)}) {
      for (std::size_t i = 0; i < part.get().points.size(); ++i) {
        EXPECT_LT(part.get().points[i].triangle, view.mesh->triangle_count());
        const PxPoint& sample = stroke[part.get().samples[i]];
        EXPECT_TRUE(std::isfinite(sample.x) && std::isfinite(sample.y)) << "a sample without a place hits nothing";
        EXPECT_NEAR(geometry::distance(view.at(part.get().points[i]), part.get().positions[i]), 0, 1e-6);
      }
    }
  }
  EXPECT_GT(hit, 30);
}

TEST(SurfaceCurve, IsEvenOnTheImagePlane) {
  const View view(tests::grid_mesh(8, 8));
  // Drawn slowly first, then fast.
  auto stroke = straight({300, 500}, {350, 500}, 50);
  stroke.push_back({700, 500});
  const auto curve = surface_curve(stroke, 9, view.camera, view.surface).value();
  ASSERT_EQ(curve.points.size(), 9U);
  ASSERT_EQ(curve.positions.size(), 9U);
  for (std::size_t i = 0; i < 9; ++i) {
    const PxPoint px = view.camera.project(view.at(curve.points[i])).value();
    EXPECT_NEAR(px.x, 300 + 50.0 * static_cast<double>(i), 1e-6);
    EXPECT_NEAR(px.y, 500, 1e-6);
  }
}

TEST(SurfaceCurve, BridgesWhatLiesBetweenTwoHits) {
  // Two sheets with a gap of 100 px between them; no sample fell into the gap.
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}, {0.4, 0, 0}, {0.4, 1, 0}, {0, 1, 0}, {0.6, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.6, 1, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const View view(mesh::TriangleMesh::build(source).value());
  const auto curve =
      surface_curve(std::vector<PxPoint>{{300, 500}, {430, 500}, {570, 500}, {700, 500}}, 9, view.camera, view.surface)
          .value();
  ASSERT_EQ(curve.points.size(), 9U);
  EXPECT_NEAR(view.at(curve.points[4]).x, 0.36, 1e-6) << "px 500 misses and takes the hit at 430 or 570";
  for (const auto& point : curve.points) {
    const double x = view.at(point).x;
    EXPECT_TRUE(x < 0.4001 || x > 0.5999);
  }
}

TEST(SurfaceCurve, RefusesACountOfOne) {
  const View view(tests::grid_mesh(2, 2));
  EXPECT_FALSE(surface_curve(straight({300, 500}, {400, 500}, 4), 1, view.camera, view.surface));
  EXPECT_FALSE(surface_curve(straight({300, 500}, {400, 500}, 4), 0, view.camera, view.surface));
}

}  // namespace
}  // namespace penpose::curve
