#include "ui/app/film/film_view.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

constexpr geometry::CameraPose k_camera{{3, 4, 20}, {0.5, 1, 0}, {0, 1, 0}, 24};

/// Where a point of the model is in what is filmed, px.
PxPoint filmed(const FilmView& view, const geometry::ModelPoint& point) {
  const auto camera = geometry::Camera::make(view.camera, view.whole);
  EXPECT_TRUE(camera.ok());
  const auto px = camera->project(point);
  return {px->x - view.part.left, px->y - view.part.top};
}

TEST(FilmView, ShowsWhatTheCanvasShowsToThePx) {
  const geometry::Viewport window{1380, 860};
  for (const Area& free : {Area{60, 40, 1060, 700}, Area{0, 0, 1380, 860}, Area{500, 300, 900, 860}}) {
    const FilmView view = film_view(k_camera, window, free, film_size(free));
    const auto shown = geometry::Camera::make(k_camera, window);
    for (const geometry::ModelPoint point : {geometry::ModelPoint{0, 0, 0}, {1, 2, 0.5}, {-1, 0.4, 1}}) {
      const auto on_canvas = shown->project(point);
      const PxPoint in_film = filmed(view, point);
      EXPECT_NEAR(in_film.x, on_canvas->x - free.left, 1.0);
      EXPECT_NEAR(in_film.y, on_canvas->y - free.top, 1.0);
    }
    EXPECT_LE(view.part.left + view.part.size.width, view.whole.width);
    EXPECT_LE(view.part.top + view.part.size.height, view.whole.height);
  }
}

TEST(FilmView, ShowsAllOfTheCanvasInItsMiddleAtAnySize) {
  const geometry::Viewport window{1000, 800};
  const Area free{100, 50, 700, 650};
  const auto shown = geometry::Camera::make(k_camera, window);
  for (const geometry::Viewport size : {geometry::Viewport{1280, 720}, {1080, 1080}, {200, 400}}) {
    const FilmView view = film_view(k_camera, window, free, size);
    const double scale = std::min(size.width / 600.0, size.height / 600.0);
    for (const geometry::ModelPoint point : {geometry::ModelPoint{0, 0, 0}, {1, 2, 0.5}}) {
      const auto on_canvas = shown->project(point);
      const PxPoint in_film = filmed(view, point);
      EXPECT_NEAR(in_film.x, 0.5 * size.width + scale * (on_canvas->x - free.middle().x), 1.0);
      EXPECT_NEAR(in_film.y, 0.5 * size.height + scale * (on_canvas->y - free.middle().y), 1.0);
    }
    EXPECT_EQ(view.part.size, size);
    EXPECT_LE(view.part.left + size.width, view.whole.width);
    EXPECT_LE(view.part.top + size.height, view.whole.height);
  }
}

TEST(FilmView, AFlatViewStaysACamera) {
  geometry::CameraPose flat = k_camera;
  flat.vertical_fov_degrees = 1;
  const FilmView view = film_view(flat, {1380, 860}, {60, 40, 1060, 300}, {1280, 720});
  EXPECT_TRUE(geometry::Camera::make(view.camera, view.whole).ok());
}

}  // namespace
}  // namespace penpose::app
