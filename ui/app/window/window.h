#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "ui/app/app.h"
#include "ui/app/hands/tablets.h"
#include "ui/app/interface.h"
#include "ui/app/window/timings.h"
#include "ui/files/window_request.h"
#include "ui/live/live.h"

namespace penpose::app {

/// The window: SDL's events in, pictures out. Waits for events and draws only when there is something new.
class Window {
 public:
  /// By the way to draw asked for, or else by the first of render::built_in_ways that starts. Errors: there is no
  /// display, or the way asked for does not start.
  static base::Result<std::unique_ptr<Window>> open(const files::WindowRequest& request);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Stays until the app wants to quit, or a played trace has ended where `until_played`. Tells `live` of every frame.
  base::Status run(App& app, Interface& interface, Tablets& tablets, Timings& timings, const live::Listener& live,
                   bool until_played);
  /// What the system's dialogs stand before (window_handle.h).
  [[nodiscard]] std::string handle() const;
  /// Makes `run` look for reports; from any thread.
  void wake() const;

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace penpose::app
