#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "ui/app/app.h"
#include "ui/app/input/navigation.h"
#include "ui/app/view/backdrop.h"

// From where one looks: the model's own front, with perspective or without.

namespace penpose::app {
namespace {

/// The view by which a project keeps what its front is.
constexpr std::string_view k_front = "front";

/// Degrees about +Y by which the model's own front stands away from +Z.
double front_of(const document::Document& document) {
  for (const auto& named : document.views) {
    if (named->name == k_front) return viewpoint_of(named->view.camera).yaw_degrees;
  }
  return 0;
}

}  // namespace

void App::frame_from(const render::Viewpoint& from) {
  viewpoint_ = from;
  framed_ = true;
  const bool was_flat = flat();
  view_ = framed(surface_.positions(), window_, free_, from);
  if (was_flat) set_flat(true);
}

void App::look_from(const render::Viewpoint& viewpoint) {
  const render::Viewpoint from{viewpoint.yaw_degrees + front_of(workspace_.document()), viewpoint.pitch_degrees};
  if (framed_) return frame_from(from);
  // Whoever looks closely goes on looking closely; Frame shows all.
  if (!pen_is_drawing()) view_.camera = seen_from(view_, from, free_.middle());
}

render::Viewpoint App::looking_from() const {
  const render::Viewpoint now = viewpoint_of(view_.camera);
  return {now.yaw_degrees - front_of(workspace_.document()), now.pitch_degrees};
}

void App::set_front() {
  if (pen_is_drawing()) return;
  document::View view = view_;
  view.camera = seen_from(view_, {viewpoint_of(view_.camera).yaw_degrees, 0}, free_.middle());
  if (!workspace_.perform(document::SaveView{std::string(k_front), view})) return;
  view_.camera = view.camera;
  framed_ = false;
  tell("this side is the model's front now: Front, 3/4 and Side go by it");
}

void App::open_backdrop(const std::string& path) {
  geometry::Box box;
  for (const glm::vec3& p : surface_.positions()) box.add(geometry::ModelPoint(p));
  const bool empty = surface_.positions().empty();
  auto made = Backdrop::open(path, empty ? geometry::ModelPoint(0) : box.center(),
                             empty ? 1.0 : std::max(box.maximum.y - box.minimum.y, 0.1 * box.diagonal()));
  if (!made) return tell(made.error().line(path), true);
  panels_.backdrop = std::move(*made);
  panels_.dialog = Dialog::none;
  panels_.folder = std::filesystem::path(path).parent_path().string();
  const std::size_t frames = panels_.backdrop->frame_count();
  tell(frames > 1 ? std::to_string(frames) + " pictures, one a frame: drag them to where they fit, then Done"
                  : "Drag the picture to where it fits, the wheel sizes it, then Done");
}

bool App::flat() const { return view_.camera.vertical_fov_degrees < k_flat_degrees + 0.5; }

void App::set_flat(bool on) {
  if (on == flat() || pen_is_drawing()) return;
  // What lies at the depth of the middle stays as large as it is.
  view_.camera = with_field_of_view(view_.camera, on ? k_flat_degrees : k_usual_degrees);
}

}  // namespace penpose::app
