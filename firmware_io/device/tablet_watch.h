#pragma once

#include <memory>
#include <vector>

#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// What has changed since the list before.
struct TabletChanges {
  std::vector<LiveTablet> arrived;
  std::vector<LiveTablet> left;
  [[nodiscard]] bool empty() const { return arrived.empty() && left.empty(); }
};

/// Compares two lists. A tablet is the same one while it stays plugged in; one whose permission changed (the udev rule
/// came in between) has left and arrived, one that a program took from the kernel's driver has not.
[[nodiscard]] TabletChanges changes_between(const std::vector<LiveTablet>& before,
                                            const std::vector<LiveTablet>& after);

/// Watches tablets come and go, through udev where it runs, and straight from the kernel on a bare board.
class TabletWatch {
 public:
  /// `own` (may be null) must outlive the watch. Errors: udev gives no events.
  [[nodiscard]] static base::Result<TabletWatch> start(const decode::TabletTable* own = nullptr);

  TabletWatch(TabletWatch&&) noexcept;
  TabletWatch& operator=(TabletWatch&&) noexcept;
  ~TabletWatch();

  /// What is plugged in now, as far as `next` has told.
  [[nodiscard]] const std::vector<LiveTablet>& tablets() const { return tablets_; }
  /// Waits at most `timeout_ms` for a tablet to come or go; what it gives is empty when none did.
  [[nodiscard]] TabletChanges next(int timeout_ms);
  /// Becomes readable when `next` has something to look at.
  [[nodiscard]] int wake_fd() const;

 private:
  class Monitor;
  TabletWatch(std::unique_ptr<Monitor> monitor, const decode::TabletTable* own, std::vector<LiveTablet> tablets);

  std::unique_ptr<Monitor> monitor_;
  const decode::TabletTable* own_;
  std::vector<LiveTablet> tablets_;
};

}  // namespace penpose::device
