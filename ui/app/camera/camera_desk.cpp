#include "ui/app/camera/camera_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penpose::app {
namespace {

/// A view of this name is the model's own front (Canvas::set_front), and no camera.
constexpr std::string_view k_front_view = "front";

/// Moments of keys are those of frames; half of the shortest frame is less.
constexpr double k_same_s = 1e-6;

document::PartOfPicture part_of(const Area& area) { return {{area.left, area.top}, {area.right, area.bottom}}; }

}  // namespace

std::vector<std::shared_ptr<const document::NamedView>> CameraDesk::kept() const {
  std::vector<std::shared_ptr<const document::NamedView>> views = editing_.document().views;
  std::erase_if(views, [](const auto& one) { return one->name == k_front_view; });
  return views;
}

document::View CameraDesk::seen() const { return document::view_of_part(canvas_.view(), part_of(canvas_.free_area())); }

void CameraDesk::show(const document::FramedCamera& framed) {
  if (editing_.pen_is_drawing()) return;
  canvas_.set_camera(document::camera_of_whole(framed, canvas_.window(), part_of(canvas_.free_area())));
}

void CameraDesk::go_to(const document::NamedView& kept) {
  const geometry::Viewport& size = kept.view.viewport;
  show({kept.view.camera, static_cast<double>(size.width) / size.height});
}

void CameraDesk::go_to_key(std::uint32_t key) {
  for (const auto& one : kept()) {
    if (one->key == key) return go_to(*one);
  }
  const std::string number = std::to_string(key);
  notices_.tell("no camera is kept on " + number + ": Ctrl+" + number + " keeps this view there");
}

std::string CameraDesk::fresh_name() const {
  const auto& views = editing_.document().views;
  for (int number = 1;; ++number) {
    const std::string name = "Camera " + std::to_string(number);
    if (std::none_of(views.begin(), views.end(), [&](const auto& one) { return one->name == name; })) return name;
  }
}

void CameraDesk::keep(std::uint32_t key) {
  std::string name;
  for (const auto& one : kept()) {
    if (key != 0 && one->key == key) name = one->name;
  }
  const bool replaces = !name.empty();
  if (!replaces) name = fresh_name();
  if (!editing_.perform(document::SaveView{name, seen(), key})) return;
  const std::string where = key == 0 ? std::string() : " on " + std::to_string(key);
  notices_.tell((replaces ? "kept anew: " : "kept: ") + name + where);
}

void CameraDesk::replace(const std::string& name) { editing_.perform(document::SaveView{name, seen(), 0}); }

bool CameraDesk::rename(const std::string& name, const std::string& to) {
  if (to == k_front_view) {
    notices_.tell("\"front\" is the model's own front: choose another name", true);
    return false;
  }
  return static_cast<bool>(editing_.perform(document::NameView{name, to}));
}

void CameraDesk::remove(const std::string& name) { editing_.perform(document::DeleteView{{name}}); }

void CameraDesk::key_here() {
  const bool first = !moves();
  const document::CameraKey* before = key_before();
  const bool here = on_key();
  const document::KeyKind kind = here ? before->kind : document::KeyKind::smooth;
  const double time_s = here ? before->time_s : playback_.time_s();
  if (!editing_.perform(document::KeyCamera{time_s, seen(), kind})) return;
  if (!first) return;
  notices_.tell("the camera is keyed: films show it from now on; go elsewhere in time, turn the view, key it again");
}

const document::CameraKey* CameraDesk::key_before() const {
  if (!moves()) return nullptr;
  const document::CameraKey* before = nullptr;
  for (const document::CameraKey& one : editing_.document().camera->keys) {
    if (one.time_s <= playback_.time_s() + k_same_s) before = &one;
  }
  return before;
}

bool CameraDesk::on_key() const {
  const document::CameraKey* before = key_before();
  return before != nullptr && std::abs(before->time_s - playback_.time_s()) <= k_same_s;
}

void CameraDesk::delete_key() {
  if (on_key()) editing_.perform(document::DeleteCameraKeys{{key_before()->time_s}});
}

void CameraDesk::cut() {
  const document::CameraKey* before = key_before();
  if (before == nullptr) return;
  const bool cuts = before->kind != document::KeyKind::stepped;
  const document::KeyKind kind = cuts ? document::KeyKind::stepped : document::KeyKind::smooth;
  if (!editing_.perform(document::KeyCamera{before->time_s, before->view, kind})) return;
  notices_.tell(cuts ? "the camera stands still up to its next key, and cuts there"
                     : "the camera moves smoothly to its next key");
}

void CameraDesk::look_through(bool on) {
  through_ = on;
  shown_track_.reset();
  if (on && !moves()) notices_.tell("the camera has no key yet: Key the camera makes one of this view");
}

void CameraDesk::begin() {
  through_ = false;
  shown_track_.reset();
}

void CameraDesk::follow() {
  if (!looks_through() || editing_.pen_is_drawing() || player_.plays_session()) return;
  const auto& track = editing_.document().camera;
  const bool same = track == shown_track_ && playback_.time_s() == shown_s_ && canvas_.window() == shown_window_ &&
                    canvas_.free_area() == shown_free_;
  if (same) return;
  shown_track_ = track;
  shown_s_ = playback_.time_s();
  shown_window_ = canvas_.window();
  shown_free_ = canvas_.free_area();
  show(*document::camera_at(*track, shown_s_));
}

}  // namespace penpose::app
