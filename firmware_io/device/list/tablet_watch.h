#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// Changes since the previous list.
struct TabletChanges {
  std::vector<LiveTablet> arrived;
  std::vector<LiveTablet> left;
  [[nodiscard]] bool empty() const { return arrived.empty() && left.empty(); }
  /// Whether one that left is an event device that was read because no HID interface of the tablet could be opened yet,
  /// and one of them arrived. What is unplugged is not replaced.
  [[nodiscard]] bool replaced(const LiveTablet& one) const;
};

/// Compares two lists. A tablet stays the same one while it is plugged in. If its permission changed (a udev rule was
/// installed), it has left and arrived; if a program took it from the kernel's driver, it has not.
[[nodiscard]] TabletChanges changes_between(const std::vector<LiveTablet>& before,
                                            const std::vector<LiveTablet>& after);

/// Holds back devices in transition: a device comes and goes in steps, and for some tens of milliseconds its driver,
/// its node or both are missing. One that stays like that is reported after a while.
class Settling {
 public:
  /// The tablets to report of those `seen` now; a `known` one that is changing stays as it was.
  [[nodiscard]] std::vector<LiveTablet> settle(const std::vector<LiveTablet>& known, std::vector<LiveTablet> seen,
                                               std::int64_t now_us);
  /// When to look again, absent when nothing is held back.
  [[nodiscard]] std::optional<std::int64_t> until_us() const { return until_us_; }

 private:
  std::map<std::string, std::int64_t> since_us_;  ///< by place, those in transition at the last call
  std::optional<std::int64_t> until_us_;
};

/// Whether udev runs, which tells programs of devices that come and go.
[[nodiscard]] bool udev_runs();

/// Watches tablets come and go, through udev where it runs, and straight from the kernel on a bare board.
class TabletWatch {
 public:
  /// `own` (may be null) must outlive the watch. Errors: the system gives no events of devices.
  [[nodiscard]] static base::Result<TabletWatch> start(const decode::TabletTable* own = nullptr);

  TabletWatch(TabletWatch&&) noexcept;
  TabletWatch& operator=(TabletWatch&&) noexcept;
  ~TabletWatch();

  /// The connected tablets, as reported by `next`.
  [[nodiscard]] const std::vector<LiveTablet>& tablets() const { return tablets_; }
  /// Waits at most `timeout_ms` for a tablet to come or go; the result is empty if none did.
  [[nodiscard]] TabletChanges next(int timeout_ms);
  /// Becomes readable when `next` has events to process.
  [[nodiscard]] int wake_fd() const;

 private:
  class Monitor;
  TabletWatch(std::unique_ptr<Monitor> monitor, const decode::TabletTable* own, std::vector<LiveTablet> tablets);

  std::unique_ptr<Monitor> monitor_;
  const decode::TabletTable* own_;
  std::vector<LiveTablet> tablets_;
  Settling settling_;
};

}  // namespace penpose::device
