#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

class Renderers : public EachWay {};
INSTANTIATE_TEST_SUITE_P(Ways, Renderers, testing::ValuesIn(built_in_ways()), way_name);

constexpr geometry::Viewport k_viewport{256, 256};

/// Area of the convex outline of points in px (monotone chain, shoelace).
double outline_area(std::vector<geometry::PxPoint> points) {
  std::sort(points.begin(), points.end(), [](auto a, auto b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<geometry::PxPoint> hull;
  const auto half = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      const auto turns_wrong = [&] {
        const auto a = hull[hull.size() - 2];
        const auto b = hull.back();
        return (b.x - a.x) * (p->y - a.y) - (b.y - a.y) * (p->x - a.x) <= 0;
      };
      while (hull.size() >= first + 2 && turns_wrong()) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  half(points.begin(), points.end());
  half(points.rbegin(), points.rend());
  double twice = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto a = hull[i];
    const auto b = hull[(i + 1) % hull.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

TEST_P(Renderers, ShowsTheBackgroundWhereNothingIsAndTheModelWhereItIs) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  for (const double size : {1e-7, 0.01, 1.0, 1e7}) {
    mesh::MeshSource source;
    add_box(source, geometry::ModelPoint{5, 1, -2} * size, geometry::ModelVector{1, 0.7, 0.4} * size);
    const Shown shown(model_of(source));
    const auto camera = frame_points(shown.positions, k_viewport);
    const Image empty = renderer->render({}, camera).value();
    const Image image = renderer->render(shown.scene(), camera).value();
    std::vector<geometry::PxPoint> corners;
    for (const auto& p : shown.positions) corners.push_back(*camera.project(geometry::ModelPoint(p)));
    const double area = outline_area(corners);
    EXPECT_NEAR(differing(image, empty), area, 0.03 * area) << size;
    for (const int x : {0, 255}) {
      for (const int y : {0, 255}) EXPECT_TRUE(std::equal(image.at(x, y), image.at(x, y) + 4, empty.at(x, y)));
    }
    EXPECT_EQ(image.at(0, 0)[3], 255);
  }
}

TEST_P(Renderers, LooksTheSameInEveryUnit) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  std::vector<Image> images;
  for (const double size : {1e-6, 1.0, 1e6}) {
    const Shown shown(sphere_model(size));
    images.push_back(renderer->render(shown.scene(), frame_points(shown.positions, k_viewport)).value());
  }
  EXPECT_LT(differing(images[0], images[1], 8), 80);
  EXPECT_LT(differing(images[2], images[1], 8), 80);
}

TEST_P(Renderers, SamePictureTwiceAndFromAnotherRenderer) {
  const auto renderer = make_renderer(GetParam());
  const auto other = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  ASSERT_NE(other, nullptr);
  const Shown shown(sphere_model(3));
  const auto camera = frame_points(shown.positions, k_viewport);
  const Image first = renderer->render(shown.scene(), camera).value();
  EXPECT_EQ(first, renderer->render(shown.scene(), camera).value());
  EXPECT_EQ(first, other->render(shown.scene(), camera).value());
}

TEST_P(Renderers, LightComesFromTheUpperLeftOfThePicture) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  const Image image = renderer->render(shown.scene(), frame_points(shown.positions, k_viewport, {140, 0})).value();
  EXPECT_GT(image.at(90, 90)[1], image.at(166, 166)[1] + 40);
}

TEST_P(Renderers, CurvesShowThroughTheModelInTheirColours) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  const auto camera = frame_points(shown.positions, k_viewport, {0, 0});
  std::vector<CurveDrawing> curves(3);
  for (std::size_t k = 0; k < 3; ++k) {
    curves[k].kind = static_cast<CurveKind>(k);
    // Behind the sphere's front: a depth test would hide them.
    const double y = 0.4 - 0.4 * static_cast<double>(k);
    curves[k].points = {{-0.5, y, 0}, {0.5, y, 0}};
  }
  Scene scene = shown.scene();
  scene.curves = curves;
  const Image image = renderer->render(scene, camera).value();
  constexpr std::size_t k_channel[3] = {1, 2, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto px = *camera.project({0, 0.4 - 0.4 * static_cast<double>(k), 0});
    const std::uint8_t* pixel = image.at(static_cast<int>(px.x), static_cast<int>(px.y));
    for (std::size_t c = 0; c < 3; ++c) {
      if (c == k_channel[k]) continue;
      EXPECT_GT(pixel[k_channel[k]], pixel[c] + 60) << k;
    }
  }
}

TEST_P(Renderers, ANewPoseIsShownWhenItsNumberChanges) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  const auto camera = frame_points(shown.positions, k_viewport);
  Scene scene = shown.scene();
  scene.shape_number = 1;
  scene.pose_number = 1;
  const Image before = renderer->render(scene, camera).value();
  std::vector<glm::vec3> squeezed = shown.positions;
  for (auto& p : squeezed) p.x *= 0.5F;
  scene.positions = squeezed;
  scene.pose_number = 2;
  const Image after = renderer->render(scene, camera).value();
  EXPECT_GT(differing(before, after), 3000);
  scene.positions = shown.positions;
  scene.pose_number = 1;
  EXPECT_EQ(renderer->render(scene, camera).value(), before);
}

TEST_P(Renderers, EdgesOfWhatDoesNotChangeGetSmoothWithOneSampleAPixel) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  renderer->set_occlusion(false);
  renderer->set_smoothing(true);
  mesh::MeshSource source;
  add_box(source, geometry::ModelPoint{0}, geometry::ModelVector{1});
  const Shown shown(model_of(source));
  const auto camera = frame_points(shown.positions, k_viewport);
  const Image empty = renderer->render({}, camera).value();
  Scene scene = shown.scene();
  scene.shape_number = scene.pose_number = 1;
  const Image first = renderer->render(scene, camera).value();
  EXPECT_TRUE(renderer->refining());
  Image last = first;
  int pictures = 0;
  for (; renderer->refining() && pictures < 100; ++pictures) last = renderer->render(scene, camera).value();
  EXPECT_GT(pictures, 3);
  EXPECT_LT(pictures, 20);
  EXPECT_EQ(renderer->render(scene, camera).value().pixels, last.pixels) << "then it stays";
  // Its shape is the same; only its edges change.
  EXPECT_NEAR(differing(last, empty), differing(first, empty), 0.05 * differing(first, empty));
  EXPECT_GT(differing(last, first), 50);
  EXPECT_LT(differing(last, first), 0.2 * differing(first, empty));
  // A change begins anew, and shows at once.
  std::vector<glm::vec3> moved = shown.positions;
  for (glm::vec3& p : moved) p.x += 0.02F;
  scene.positions = moved;
  scene.pose_number = 2;
  EXPECT_GT(differing(renderer->render(scene, camera).value(), last), 50);
  EXPECT_TRUE(renderer->refining());
}

TEST_P(Renderers, OverlayColoursAndWireframeShow) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  const auto camera = frame_points(shown.positions, k_viewport, {0, 0});
  const Image plain = renderer->render(shown.scene(), camera).value();
  Scene scene = shown.scene();
  const std::vector<Color> blue(shown.positions.size(), weight_color(0.5F));
  scene.overlay = blue;
  const Image covered = renderer->render(scene, camera).value();
  EXPECT_GT(covered.at(128, 128)[2], covered.at(128, 128)[0] + 60);
  scene = shown.scene();
  EXPECT_EQ(renderer->render(scene, camera).value(), plain);
  scene.wireframe = true;
  EXPECT_GT(differing(renderer->render(scene, camera).value(), plain, 8), 5000);
}

TEST_P(Renderers, OneSeesThroughTranslucentSurfaces) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  mesh::MeshSource source;
  add_sphere(source, geometry::ModelPoint{0}, 0.5);
  const auto inner = static_cast<std::uint16_t>(source.positions.size());
  add_sphere(source, geometry::ModelPoint{0}, 1);
  const Shown shown(model_of(source));
  Appearance look;
  look.surfaces = {{{0.8F, 0.05F, 0.05F, 1}, 0.6F, 0}, {{0.8F, 0.8F, 0.8F, 0.1F}, 0.6F, 0}};
  look.surface_of_vertex.assign(shown.positions.size(), 1);
  std::fill_n(look.surface_of_vertex.begin(), inner, std::uint16_t{0});
  Scene scene = shown.scene();
  scene.appearance = &look;
  const Image image = renderer->render(scene, frame_points(shown.positions, k_viewport)).value();
  EXPECT_GT(image.at(128, 128)[0], image.at(128, 128)[2] + 50);
}

TEST_P(Renderers, ACameraInsideTheModelSeesItsInside) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  const auto camera = geometry::Camera::make({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 60}, k_viewport).value();
  const Image empty = renderer->render({}, camera).value();
  EXPECT_GT(differing(renderer->render(shown.scene(), camera).value(), empty, 0), 60000);
}

TEST_P(Renderers, RefusesAPictureThatIsTooLargeAndGoesOn) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  const Shown shown(sphere_model(1));
  EXPECT_FALSE(renderer->render(shown.scene(), frame_points(shown.positions, {1 << 20, 8})).ok());
  EXPECT_TRUE(renderer->render(shown.scene(), frame_points(shown.positions, {64, 64})).ok());
}

/// Px of a picture that the model covers, and how many of them differ by more than `step` from another's.
double share_near(const Image& image, const Image& other, const Image& empty, int step) {
  int covered = 0;
  int near = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (std::equal(&image.pixels[i], &image.pixels[i] + 4, &empty.pixels[i])) continue;
    ++covered;
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(image.pixels[i + c] - other.pixels[i + c]));
    near += most <= step ? 1 : 0;
  }
  return covered == 0 ? 0 : static_cast<double>(near) / covered;
}

TEST_P(Renderers, DrawsWhatTheOthersDraw) {
  const auto renderer = make_renderer(GetParam());
  // Where the best way does not start it is the processor.
  auto best = make_offscreen_renderer(built_in_ways().front());
  const auto reference = best ? std::move(*best) : make_renderer(DrawWay::cpu);
  ASSERT_TRUE(renderer && reference);
  const document::Model model = character::make_demo_head().value();
  const PosedMesh posed = posed_mesh(model);
  const Appearance appearance = make_appearance(model, {});
  const geometry::Viewport size{800, 480};
  for (const double yaw : {0.0, 35.0}) {
    const auto camera = frame_points(posed.positions, size, {yaw, 5});
    Scene scene = scene_of(model, posed, appearance);
    scene.shape_number = scene.pose_number = 1;
    std::array<Image, 2> pictures;
    std::array<Renderer*, 2> both{renderer.get(), reference.get()};
    for (std::size_t i = 0; i < 2; ++i) {
      // As in the window, once it has come to rest.
      both[i]->set_occlusion(false);
      both[i]->set_smoothing(true);
      do {
        pictures[i] = both[i]->render(scene, camera).value();
      } while (both[i]->refining());
    }
    Scene nothing;
    const Image empty = renderer->render(nothing, camera).value();
    EXPECT_GT(share_near(pictures[0], pictures[1], empty, 4), 0.995) << yaw;
  }
}

}  // namespace
}  // namespace penpose::render
