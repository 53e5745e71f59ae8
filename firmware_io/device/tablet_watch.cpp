#include "firmware_io/device/tablet_watch.h"

#include <algorithm>
#include <poll.h>
#include <unistd.h>

#include "firmware_io/device/udev_handles.h"

namespace penpose::device {
namespace {

/// Exists while udev runs; only then do its events come.
constexpr const char* k_udev_socket = "/run/udev/control";
/// A device comes with several events, interface by interface; they are taken together.
constexpr int k_settle_ms = 30;
constexpr int k_most_settles = 40;

bool same(const LiveTablet& a, const LiveTablet& b) {
  if (a.interface.parent != b.interface.parent || a.interface.usb_node != b.interface.usb_node) return false;
  if (a.interface.usb_name != b.interface.usb_name) return false;
  // Taken from the kernel's driver or given back, it is still the same.
  if (!a.interface.usb_name.empty() && (a.access == Access::busy || b.access == Access::busy)) return true;
  return a.path() == b.path() && a.access == b.access && a.method == b.method;
}

std::vector<LiveTablet> without(const std::vector<LiveTablet>& list, const std::vector<LiveTablet>& others) {
  std::vector<LiveTablet> rest;
  for (const LiveTablet& tablet : list) {
    const bool there = std::any_of(others.begin(), others.end(), [&](const LiveTablet& o) { return same(tablet, o); });
    if (!there) rest.push_back(tablet);
  }
  return rest;
}

}  // namespace

TabletChanges changes_between(const std::vector<LiveTablet>& before, const std::vector<LiveTablet>& after) {
  return {without(after, before), without(before, after)};
}

class TabletWatch::Monitor {
 public:
  Udev library;
  UdevMonitor monitor;

  /// Takes one event if one comes within the time.
  [[nodiscard]] bool take(int timeout_ms) const {
    pollfd waiting{udev_monitor_get_fd(monitor.get()), POLLIN, 0};
    if (::poll(&waiting, 1, timeout_ms) <= 0) return false;
    const UdevDevice device(udev_monitor_receive_device(monitor.get()));
    return true;
  }
};

TabletWatch::TabletWatch(std::unique_ptr<Monitor> monitor, const decode::TabletTable* own,
                         std::vector<LiveTablet> tablets)
    : monitor_(std::move(monitor)), own_(own), tablets_(std::move(tablets)) {}
TabletWatch::TabletWatch(TabletWatch&&) noexcept = default;
TabletWatch& TabletWatch::operator=(TabletWatch&&) noexcept = default;
TabletWatch::~TabletWatch() = default;

base::Result<TabletWatch> TabletWatch::start(const decode::TabletTable* own) {
  auto made = std::make_unique<Monitor>();
  made->library.reset(udev_new());
  const bool udev_runs = ::access(k_udev_socket, F_OK) == 0;
  if (made->library)
    made->monitor.reset(udev_monitor_new_from_netlink(made->library.get(), udev_runs ? "udev" : "kernel"));
  if (!made->monitor) return base::Error{"the system tells nothing of devices that come and go", "", ""};
  udev_monitor_filter_add_match_subsystem_devtype(made->monitor.get(), "hidraw", nullptr);
  udev_monitor_filter_add_match_subsystem_devtype(made->monitor.get(), "usb", nullptr);
  if (udev_monitor_enable_receiving(made->monitor.get()) < 0) {
    return base::Error{"the system tells nothing of devices that come and go", "", ""};
  }
  auto tablets = list_tablets(own);
  if (!tablets) return tablets.error();
  return TabletWatch(std::move(made), own, std::move(tablets).value());
}

int TabletWatch::wake_fd() const { return udev_monitor_get_fd(monitor_->monitor.get()); }

TabletChanges TabletWatch::next(int timeout_ms) {
  if (!monitor_->take(timeout_ms)) return {};
  for (int i = 0; i < k_most_settles && monitor_->take(k_settle_ms); ++i) {
  }
  auto now = list_tablets(own_, tablets_);
  if (!now) return {};
  TabletChanges changes = changes_between(tablets_, *now);
  tablets_ = std::move(now).value();
  return changes;
}

}  // namespace penpose::device
