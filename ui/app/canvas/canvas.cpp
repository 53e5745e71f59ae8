#include "ui/app/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "ui/app/input/navigation.h"

namespace penpose::app {
namespace {

/// The view by which a project keeps what its front is.
constexpr std::string_view k_front = "front";

constexpr double k_usual_dpi = 96;

}  // namespace

double front_degrees(const document::Document& document) {
  for (const auto& named : document.views) {
    if (named->name == k_front) return viewpoint_of(named->view.camera).yaw_degrees;
  }
  return document.model->front_yaw_degrees;
}

Canvas::Canvas(EditingSession& editing, Preferences& preferences, Notices& notices, const Player& player)
    : editing_(editing), preferences_(preferences), notices_(notices), player_(player) {}

double Canvas::dpi() const {
  // Displays that report less or more are wrong.
  constexpr double k_least_dpi = 60;
  constexpr double k_most_dpi = 600;
  return dpi_ >= k_least_dpi && dpi_ <= k_most_dpi ? dpi_ : 96;
}

double Canvas::base_scale() const {
  if (asked_scale_ > 0) return asked_scale_;
  return own_scale_ > 0 ? own_scale_ : dpi() / k_usual_dpi;
}

double Canvas::scale() const { return preferences_.settings().scale * base_scale(); }

void Canvas::ask_scale(double scale) { asked_scale_ = scale / preferences_.settings().scale; }

double Canvas::target_px() const {
  constexpr double k_target_mm = 9;
  constexpr double k_mm_per_inch = 25.4;
  // By density, where the usual is 1.
  constexpr double k_compact = 0.72;
  constexpr double k_touch = 1.3;
  const Settings& settings = preferences_.settings();
  const double density = settings.density == Density::compact ? k_compact
                         : settings.density == Density::touch ? k_touch
                                                              : 1.0;
  // What the system scales is no smaller for that on the glass, unless that was asked for.
  const double wanted_dpi = k_usual_dpi * base_scale();
  const double counted_dpi = asked_scale_ > 0 ? wanted_dpi : std::max(dpi(), wanted_dpi);
  return std::ceil(k_target_mm / k_mm_per_inch * counted_dpi * std::max(1.0, settings.scale) * density);
}

void Canvas::resized(geometry::Viewport window, double dpi, double own) {
  window = {std::clamp(window.width, 1, 16384), std::clamp(window.height, 1, 16384)};
  dpi_ = dpi;
  own_scale_ = own;
  if (window == window_ && view_.viewport == window) return;
  window_ = window;
  view_.viewport = window;
  free_.right = std::max(free_.left + 1, std::min(free_.right, static_cast<double>(window.width)));
  free_.bottom = std::max(free_.top + 1, std::min(free_.bottom, static_cast<double>(window.height)));
  if (framed_) frame_from(viewpoint_);
}

void Canvas::set_free_area(const Area& area) {
  if (area == free_ || area.width() < 50 || area.height() < 50) return;
  free_ = area;
  if (framed_) frame_from(viewpoint_);
}

void Canvas::commit() {
  if (editing_.pen_is_drawing() || player_.plays_session()) return;
  editing_.set_view(view_);
}

void Canvas::set_camera(const geometry::CameraPose& camera) {
  view_.camera = camera;
  framed_ = false;
}

void Canvas::show_played() { view_.camera = editing_.editor().view().camera; }

void Canvas::frame_all() {
  frames_face_ = false;
  frame_from(viewpoint_of(view_.camera));
}

void Canvas::frame_points(std::span<const glm::vec3> points) {
  const bool was_flat = flat();
  view_ = framed(points, window_, free_, viewpoint_of(view_.camera));
  framed_ = false;
  if (was_flat) set_flat(true);
}

void Canvas::frame_face() {
  frames_face_ = true;
  frame_from(viewpoint_of(view_.camera));
}

void Canvas::begin() {
  surface_.update(editing_.shown().model(), editing_.shown().pose());
  framed_ = true;
  frames_face_ = true;
  set_flat(false);
  look_from(*render::find_viewpoint("front"));
}

void Canvas::turn(double yaw, double pitch) { set_camera(orbited(view_.camera, yaw, pitch)); }

void Canvas::zoom(double factor, PxPoint about) { set_camera(zoomed(view_, factor, about, surface_.size())); }

void Canvas::pan(PxPoint by) { set_camera(panned(view_, by)); }

void Canvas::frame_from(const render::Viewpoint& from) {
  viewpoint_ = from;
  framed_ = true;
  const bool was_flat = flat();
  const std::vector<glm::vec3> face = frames_face_ ? surface_.face_positions() : std::vector<glm::vec3>();
  view_ = framed(face.empty() ? surface_.positions() : std::span<const glm::vec3>(face), window_, free_, from);
  if (was_flat) set_flat(true);
}

void Canvas::look_from(const render::Viewpoint& viewpoint) {
  const render::Viewpoint from{viewpoint.yaw_degrees + front_degrees(editing_.document()), viewpoint.pitch_degrees};
  if (framed_) return frame_from(from);
  // Whoever looks closely goes on looking closely; Frame shows all.
  if (!editing_.pen_is_drawing()) view_.camera = seen_from(view_, from, free_.middle());
}

render::Viewpoint Canvas::looking_from() const {
  const render::Viewpoint now = viewpoint_of(view_.camera);
  return {now.yaw_degrees - front_degrees(editing_.document()), now.pitch_degrees};
}

void Canvas::set_front() {
  if (editing_.pen_is_drawing()) return;
  document::View view = view_;
  view.camera = seen_from(view_, {viewpoint_of(view_.camera).yaw_degrees, 0}, free_.middle());
  if (!editing_.perform(document::SaveView{std::string(k_front), view})) return;
  view_.camera = view.camera;
  framed_ = false;
  notices_.tell("this side is the model's front now: Front, 3/4 and Side go by it");
}

bool Canvas::flat() const { return view_.camera.vertical_fov_degrees < k_flat_degrees + 0.5; }

void Canvas::set_flat(bool on) {
  if (on == flat() || editing_.pen_is_drawing()) return;
  // What lies at the depth of the middle stays as large as it is.
  view_.camera = with_field_of_view(view_.camera, on ? k_flat_degrees : k_usual_degrees);
}

}  // namespace penpose::app
