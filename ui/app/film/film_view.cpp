#include "ui/app/film/film_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penpose::app {
namespace {

constexpr double k_radians = std::numbers::pi / 180;

/// The whole number of px on both sides of a middle that reach so far.
int twice(double half) { return 2 * static_cast<int>(std::ceil(half)); }

int placed(double left, int room) { return std::clamp(static_cast<int>(std::lround(left)), 0, std::max(room, 0)); }

}  // namespace

FilmView film_view(const geometry::CameraPose& camera, geometry::Viewport window, const Area& free,
                   geometry::Viewport size) {
  const double scale = std::min(size.width / free.width(), size.height / free.height());
  // Cameras look at the middle of their picture; that of the free part lies beside it.
  const double aside = scale * (free.middle().x - 0.5 * window.width);
  const double below = scale * (free.middle().y - 0.5 * window.height);
  FilmView view;
  view.whole.width = twice(std::abs(aside) + 0.5 * size.width);
  view.whole.height = twice(std::max(std::abs(below) + 0.5 * size.height, 0.5 * scale * window.height));
  view.camera = camera;
  const double half =
      std::tan(0.5 * k_radians * camera.vertical_fov_degrees) * view.whole.height / (scale * window.height);
  view.camera.vertical_fov_degrees = 2 / k_radians * std::atan(half);
  view.part.size = size;
  view.part.left = placed(0.5 * (view.whole.width - size.width) + aside, view.whole.width - size.width);
  view.part.top = placed(0.5 * (view.whole.height - size.height) + below, view.whole.height - size.height);
  return view;
}

geometry::Viewport film_size(const Area& free) {
  return {std::max(2, 2 * static_cast<int>(free.width() / 2)), std::max(2, 2 * static_cast<int>(free.height() / 2))};
}

}  // namespace penpose::app
