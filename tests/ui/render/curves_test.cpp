#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

class DrawnCurves : public EachWay {};
INSTANTIATE_TEST_SUITE_P(Ways, DrawnCurves, testing::ValuesIn(built_in_ways()), way_name);

Image draw(Renderer& renderer, const std::vector<CurveDrawing>& curves) {
  Scene scene;
  scene.curves = curves;
  scene.background = {from_srgb(0x000000), from_srgb(0x000000)};
  const auto camera = geometry::Camera::make({}, {200, 200}).value();
  return renderer.render(scene, camera).value();
}

CurveDrawing line(double y, float width_px) {
  CurveDrawing curve;
  for (int x = 20; x <= 180; x += 2) curve.points_px.push_back({static_cast<double>(x), y});
  curve.width_px = width_px;
  curve.color = Color{1, 1, 1, 1};
  return curve;
}

/// Sum of the brightness across the curve at one column, in px of full white.
double width_at(const Image& image, int x) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) sum += image.at(x, y)[1] / 255.0;
  return sum;
}

TEST_P(DrawnCurves, HasTheWidthAskedForHoweverDenseThePointsAre) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  for (const float width : {2.0F, 5.0F, 12.0F}) {
    const double dense = width_at(draw(*renderer, {line(100.3, width)}), 100);
    CurveDrawing sparse = line(100.3, width);
    sparse.points_px = {{20, 100.3}, {180, 100.3}};
    EXPECT_NEAR(dense, static_cast<double>(width), 1.2) << "the outline adds a little";
    EXPECT_NEAR(dense, width_at(draw(*renderer, {sparse}), 100), 0.15);
  }
}

TEST_P(DrawnCurves, WidthFollowsThePressure) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  CurveDrawing curve = line(100, 1);
  for (std::size_t i = 0; i < curve.points_px.size(); ++i) curve.widths_px.push_back(2 + 0.2F * static_cast<float>(i));
  const Image image = draw(*renderer, {curve});
  EXPECT_NEAR(width_at(image, 150) - width_at(image, 50), 10, 1);
}

TEST_P(DrawnCurves, LaterCurvesLieOverEarlierOnesAndHighlightedOverAll) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  CurveDrawing red = line(100, 10);
  red.color = Color{1, 0, 0, 1};
  CurveDrawing blue = line(100, 10);
  blue.color = Color{0, 0, 1, 1};
  EXPECT_GT(draw(*renderer, {red, blue}).at(100, 100)[2], 250);
  red.highlighted = true;
  EXPECT_GT(draw(*renderer, {red, blue}).at(100, 100)[0], 250);
}

TEST_P(DrawnCurves, PointColoursRunAlongTheCurve) {
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  CurveDrawing curve = line(100, 8);
  curve.points_px = {{20, 100}, {180, 100}};
  curve.point_colors = {{1, 0, 0, 1}, {0, 0, 1, 1}};
  const Image image = draw(*renderer, {curve});
  EXPECT_GT(image.at(30, 100)[0], 200);
  EXPECT_GT(image.at(170, 100)[2], 200);
}

}  // namespace
}  // namespace penpose::render
