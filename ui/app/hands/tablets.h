#pragma once

#include <functional>
#include <memory>

#include "firmware_io/device/list/tablet_watch.h"
#include "ui/app/hands/tablet_events.h"

namespace penpose::app {

/// Tablets that are plugged in, each drained by a thread of its own, so that no report is dropped while a frame is
/// made. One more thread waits for all of them and wakes the window up.
class Tablets {
 public:
  using StartWatch = std::function<base::Result<device::TabletWatch>()>;

  /// `wake` is called from another thread whenever there is something to take. `own` may be null. `start_watch` stands
  /// in for the system's own watch.
  Tablets(std::function<void()> wake, const decode::TabletTable* own, StartWatch start_watch = {});
  ~Tablets();
  Tablets(const Tablets&) = delete;
  Tablets& operator=(const Tablets&) = delete;

  /// Hands on all that came since the last call, in the order of its times.
  void take(TabletEvents& events, Notices& notices);
  /// Whether pens and pads that the desktop reads as well are kept from it (ReportPump::set_exclusive). At first they
  /// are not.
  void set_exclusive(bool wanted);
  /// Counts how often the system's devices were looked at: once at the start, and whenever any came or went, after
  /// which it wakes the window up.
  [[nodiscard]] unsigned looks() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penpose::app
