#include "ui/app/window/screen.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "firmware_io/device/clock.h"
#include "firmware_io/device/list/tablet_watch.h"
#include "ui/app/canvas/own_scale.h"
#include "ui/app/hands/panel_turn.h"
#include "ui/app/view/present/cpu_presenter.h"
#include "ui/app/view/present/output/drm_screens.h"
#include "ui/app/window/x_resources.h"

namespace penpose::app {
namespace {

constexpr SDL_Rect k_usual{0, 0, 1280, 800};

/// SDL's ways to a screen that no desktop has.
bool is_bare(std::string_view driver) { return driver == "KMSDRM" || driver == "kmsdrm" || driver == "evdev"; }

/// The video drivers to try: only what can be there, because the others complain on standard error.
std::string drivers(bool bare, render::DrawWay way) {
  if (bare) return way == render::DrawWay::cpu ? "evdev" : "KMSDRM";
  if (const char* wanted = std::getenv("SDL_VIDEODRIVER"); wanted != nullptr) return wanted;
  const bool x11 = std::getenv("DISPLAY") != nullptr;
  const bool wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  return wayland && x11 ? "wayland,x11" : wayland ? "wayland" : "x11";
}

}  // namespace

Screen::Screen(const files::WindowRequest& request)
    : wanted_(request.screen),
      rotation_(rotation_of(request.rotate).value_or(Rotation::none)),
      finger_rotation_(turned_input(request.rotate_input) == TurnedInput::none ? Rotation::none : rotation_),
      wanted_dpi_(request.dpi),
      wanted_scale_(request.scale),
      slow_(request.slow_screen) {
  const char* driver = std::getenv("SDL_VIDEODRIVER");
  bare_ = driver != nullptr ? is_bare(driver) : !std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY");
}

Screen::~Screen() {
  output_.reset();
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

std::optional<render::DrawWay> Screen::only_way() const {
  if (rotation_ == Rotation::none && !slow_) return std::nullopt;
  return render::DrawWay::cpu;
}

base::Status Screen::start(render::DrawWay way) {
  output_.reset();
  bare_output_ = bare_ && way == render::DrawWay::cpu;
  if (bare_output_) {
    auto opened = open_screen_output(wanted_, slow_);
    if (!opened) {
      const base::Error& error = opened.error();
      return base::Error{
          "there is no display to open a window on, and no screen (" + error.place + ": " + error.what + ")", "",
          error.remedy};
    }
    output_ = std::move(*opened);
    bare_dpi_ = output_->dpi();
  } else if (bare_) {
    const DrmScreens screens = find_drm_screens();
    const auto index = static_cast<std::size_t>(wanted_.value_or(0));
    if (index < screens.all.size()) {
      bare_dpi_ = screens.all[index].dpi;
      if (wanted_) SDL_SetHint(SDL_HINT_KMSDRM_DEVICE_INDEX, std::to_string(screens.all[index].card).c_str());
    }
  }
  SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, drivers(bare_, way).c_str(), SDL_HINT_OVERRIDE);
  if (SDL_WasInit(SDL_INIT_VIDEO) != 0) {
    if (!bare_) return base::Done{};
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) == 0) {
    const char* driver = SDL_GetCurrentVideoDriver();
    on_x_ = driver != nullptr && std::string_view(driver) == "x11";
    if (on_x_) {
      const XDisplaySays says = ask_x_display();
      text_dpi_ = xft_dpi(says.resources).value_or(0);
      server_dpi_ = says.dpi;
    }
    return base::Done{};
  }
  const std::string why = SDL_GetError();
  return base::Error{"there is no display to open a window on (" + why.substr(0, why.find('\n')) + ")", "",
                     "start it on a desktop, or on a console as a user of the group video; `penpose --help` lists what "
                     "needs none"};
}

SDL_Rect Screen::place_of_window(bool fills) const {
  if (bare_output_) {
    const geometry::Viewport all = panel();
    return {0, 0, all.width, all.height};
  }
  int index = std::min(wanted_.value_or(0), std::max(0, SDL_GetNumVideoDisplays() - 1));
  if (bare_ && wanted_) {
    const DrmScreens screens = find_drm_screens();
    const auto wanted = static_cast<std::size_t>(*wanted_);
    index = wanted < screens.all.size() ? screens.all[wanted].of_card : 0;
  }
  SDL_Rect all = k_usual;
  SDL_GetDisplayBounds(index, &all);
  if (fills || bare_) return all;
  const double scale = opening_scale(index);
  const int width = opened_px(k_usual.w, scale, all.w);
  const int height = opened_px(k_usual.h, scale, all.h);
  return {all.x + (all.w - width) / 2, all.y + (all.h - height) / 2, width, height};
}

void Screen::take(SDL_Window* window) {
  window_ = window;
  if (bare_output_) {
    // SDL knows no screen here and gives the mouse to no window; this makes it say that there is one.
    bare_mouse_ = {panel().width / 2.0, panel().height / 2.0};
    SDL_WarpMouseInWindow(window, panel().width / 2, panel().height / 2);
  } else {
    SDL_Rect all = k_usual;
    SDL_GetDisplayBounds(SDL_GetWindowDisplayIndex(window), &all);
    SDL_SetWindowMinimumSize(window, std::min(all.w, 480), std::min(all.h, 320));
  }
}

bool Screen::lacks_input() { return bare_ && inputs_.has_new() && !device::udev_runs(); }

std::unique_ptr<Presenter> Screen::cpu_presenter() {
  if (!bare_output_) output_ = make_window_output(window_);
  return make_cpu_presenter(*output_, rotation_, slow_, device::monotonic_us);
}

geometry::Viewport Screen::panel() const {
  if (bare_output_) return output_->size().value_or(geometry::Viewport{});
  int width = 0;
  int height = 0;
  SDL_GL_GetDrawableSize(window_, &width, &height);
  return {width, height};
}

double Screen::dpi() const {
  if (bare_) return wanted_dpi_ > 0 ? wanted_dpi_ : bare_dpi_;
  return display_dpi(SDL_GetWindowDisplayIndex(window_));
}

double Screen::display_dpi(int index) const {
  if (wanted_dpi_ > 0) return wanted_dpi_;
  float diagonal = 0;
  if (SDL_GetDisplayDPI(index, &diagonal, nullptr, nullptr) != 0) return server_dpi_;
  return static_cast<double>(diagonal);
}

double Screen::opening_scale(int index) const {
  if (wanted_scale_ > 0) return wanted_scale_;
  // Elsewhere a window's units are those that the compositor scales.
  if (!on_x_) return 1;
  const double own = desktop_scale(1);
  return own > 0 ? own : display_dpi(index) / k_scale_one_dpi;
}

double Screen::own_scale() const {
  int width = 0;
  int height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  return desktop_scale(width > 0 ? static_cast<double>(panel().width) / width : 0);
}

double Screen::desktop_scale(double px_a_unit) const {
  if (wanted_dpi_ > 0 || bare_) return 0;
  SystemScale system;
  system.text_dpi = text_dpi_;
  system.px_a_unit = px_a_unit;
  system.server_dpi = server_dpi_;
  const char* qt = std::getenv("QT_SCALE_FACTOR");
  system.toolkits = qt != nullptr ? toolkit_scale(qt, nullptr)
                                  : toolkit_scale(std::getenv("GDK_SCALE"), std::getenv("GDK_DPI_SCALE"));
  return app::own_scale(system);
}

geometry::PxPoint Screen::moved_mouse(geometry::PxPoint to, geometry::PxPoint by) {
  if (bare_output_) {
    // SDL lets a mouse that belongs to no window leave the screen, and presses would be where it went.
    bare_mouse_ = {std::clamp(bare_mouse_.x + by.x, 0.0, std::max(0.0, panel().width - 1.0)),
                   std::clamp(bare_mouse_.y + by.y, 0.0, std::max(0.0, panel().height - 1.0))};
  }
  return of_mouse(to.x, to.y);
}

geometry::PxPoint Screen::of_mouse(double x, double y) const {
  if (bare_output_) return on_picture(bare_mouse_, panel(), rotation_);
  int width = 0;
  int height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  const double per_unit = width > 0 ? static_cast<double>(panel().width) / width : 1;
  return on_picture({x * per_unit, y * per_unit}, panel(), rotation_);
}

geometry::PxPoint Screen::of_finger(double x, double y) const {
  const geometry::Viewport of = turned_size(size(), finger_rotation_);
  return on_picture({x * of.width, y * of.height}, of, finger_rotation_);
}

}  // namespace penpose::app
