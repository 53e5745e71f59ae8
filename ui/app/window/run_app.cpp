#include "ui/app/window/run_app.h"

#include <ctime>
#include <filesystem>
#include <iostream>

#include "core/base/numbers.h"
#include "firmware_io/device/clock.h"
#include "ui/app/app.h"
#include "ui/app/hands/tablets.h"
#include "ui/app/interface.h"
#include "ui/app/window/sdl_sound.h"
#include "ui/app/window/stop_watch.h"
#include "ui/app/window/timings.h"
#include "ui/app/window/window.h"
#include "ui/files/load_model.h"
#include "ui/files/own_tablets.h"
#include "ui/files/process/kept_memory.h"
#include "ui/files/session_model.h"
#include "ui/live/live.h"

namespace penpose::app {
namespace {

/// Local time as a name of a file.
std::string date_name() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d_%H-%M-%S", &parts);
  return text;
}

base::Error in_file(base::Error error, const std::string& file) {
  error.place = error.place.empty() ? file : file + ": " + error.place;
  return error;
}

}  // namespace

base::Status run_app(const files::WindowRequest& request) {
  const std::int64_t began = device::monotonic_us();
  files::keep_little_memory();
  const auto own = files::read_own_tablets(request.own);
  if (!own) return own.error();
  std::error_code code;
  if (!request.session.empty() && std::filesystem::exists(request.session, code)) {
    return base::Error{"exists already and is not written over", request.session,
                       "choose another name or move it away"};
  }
  const auto live = live::open_live_output(request.live, live::live_outputs());
  if (!live) return live.error();
  auto window = Window::open(request);
  if (!window) return window.error();
  AppOptions options;
  options.folders = standard_folders();
  options.session = request.session;
  options.clock = device::monotonic_us;
  options.date = date_name;
  options.program = request.program;
  options.own_tablets = &*own;
  options.slow_screen = request.slow_screen;
  options.scale = request.scale;
  options.panel = {request.rotate, turned_input(request.rotate_input)};
  App app(options);
  app.of<SoundTrack>().set_output(make_sdl_sound());
  app.of<SystemDialogs>().set_portal(portal::make_file_portal([&] { (*window)->wake(); }),
                                     [&] { return (*window)->handle(); });
  const std::string file = request.model.empty() ? "builtin:demo" : request.model;
  // A session of an older edition is asked about, over what opens by itself.
  const bool asks = files::older_edition_of(file).has_value();
  const std::string model = asks ? files::k_default_model : files::ModelName{file, request.orientation}.text();
  if (const auto opened = app.of<Files>().open(model); !opened) return in_file(opened.error(), model);
  if (asks) app.of<Files>().try_open(file);
  if (!request.session.empty() && app.of<Recording>().path().empty()) {
    return base::Error{"cannot be written", request.session, "check the folder, its permissions and the free space"};
  }
  if (!request.replay.empty()) {
    if (const auto played = app.of<Files>().play_trace(request.replay); !played)
      return in_file(played.error(), request.replay);
  }
  Interface interface(app);
  if (request.rotate != 0 && !request.draw.empty() && request.draw != "cpu") {
    app.of<Notices>().tell("a turned picture is drawn by the processor, not by --draw " + request.draw);
  }
  const StopWatch stop([&] { (*window)->wake(); });
  Tablets tablets([&] { (*window)->wake(); }, &*own);
  Timings timings;
  timings.began_us = began;
  const auto status = (*window)->run(app, interface, tablets, timings, *live, !request.replay.empty());
  if (request.timings) std::cout << timings.text();
  return status;
}

}  // namespace penpose::app
