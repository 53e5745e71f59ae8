#include "core/geometry/camera.h"
#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

int32_t penpose_view_of(penpose_library* library, penpose_handle character, double yaw_degrees, double pitch_degrees,
                        int32_t width, int32_t height, penpose_view* view, penpose_error* error) {
  return call_character(library, character, error, [&](const character::Character& one, CharacterObject&) {
    needed(view, "view");
    constexpr std::int32_t k_longest_px = 32768;
    if (width < 1 || height < 1 || width > k_longest_px || height > k_longest_px)
      fail_argument("a picture whose sides are not 1 to 32768 px", "width", "give its size");
    constexpr double k_widest = 1e6;
    if (!(yaw_degrees >= -k_widest && yaw_degrees <= k_widest && pitch_degrees >= -k_widest &&
          pitch_degrees <= k_widest))
      fail_argument("an angle that is not finite or too large", "yaw_degrees", "give degrees");
    *view = view_to_c(one.view_from(yaw_degrees, pitch_degrees, {width, height}));
  });
}

int32_t penpose_project(const penpose_view* view, const double* xyz, size_t count, double* px, penpose_error* error) {
  return call(error, [&] {
    const document::View seen = view_of(needed(view, "view"));
    const auto camera = taken(geometry::Camera::make(seen.camera, seen.viewport));
    const auto points = points_of(xyz, count, "xyz");
    const auto out = array(px, 2 * count, "px");
    std::vector<geometry::PxPoint> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto place = camera.project(points[i]);
      if (!place) fail(PENPOSE_REFUSED, {"a point lies behind the view", "xyz/" + std::to_string(i), "turn the view"});
      places.push_back(*place);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      out[2 * i] = places[i].x;
      out[2 * i + 1] = places[i].y;
    }
  });
}
