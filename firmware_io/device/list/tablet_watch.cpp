#include "firmware_io/device/list/tablet_watch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <linux/netlink.h>
#include <poll.h>
#include <string_view>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>
#include <utility>

#include "firmware_io/device/clock.h"

namespace penpose::device {
namespace {

/// Exists while udev runs.
constexpr const char* k_udev_socket = "/run/udev/control";
/// Groups of NETLINK_KOBJECT_UEVENT (systemd's sd-device, enum MonitorNetlinkGroup).
constexpr std::uint32_t k_from_kernel = 1;
constexpr std::uint32_t k_from_udev = 2;
/// Longer than events are (UEVENT_BUFFER_SIZE of Linux, and what udev adds).
constexpr std::size_t k_longest_event = 8192;
/// A device comes with several events, interface by interface; they are taken together.
constexpr int k_settle_ms = 30;
constexpr int k_most_settles = 40;
/// How long a device may be on its way before it is taken for what it is.
constexpr std::int64_t k_patience_us = 500'000;

class File {
 public:
  explicit File(int file = -1) : file_(file) {}
  File(File&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  File& operator=(File&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~File() {
    if (file_ >= 0) ::close(file_);
  }
  [[nodiscard]] int get() const { return file_; }

 private:
  int file_;
};

bool same(const LiveTablet& a, const LiveTablet& b) {
  if (a.interface.parent != b.interface.parent || a.interface.usb_node != b.interface.usb_node) return false;
  if (a.interface.usb_name != b.interface.usb_name) return false;
  // Taken from the kernel's driver or given back, it is still the same.
  if (!a.interface.usb_name.empty() && (a.access == Access::busy || b.access == Access::busy)) return true;
  // Bound anew, its node is another one although it has the same name.
  const bool has_own_node = a.transport != Transport::libusb;
  if (has_own_node && a.interface.hid_name != b.interface.hid_name) return false;
  if (has_own_node && a.interface.node_made != b.interface.node_made) return false;
  return a.path() == b.path() && a.access == b.access && a.method == b.method;
}

/// The same for an interface as long as it is plugged in.
std::string place_of(const LiveTablet& tablet) {
  const HidInterface& interface = tablet.interface;
  const bool is_usb = !interface.usb_name.empty();
  return interface.parent + ' ' + interface.usb_node + ' ' + (is_usb ? interface.usb_name : interface.hid_name) +
         interface.event_node;
}

/// No driver yet or no longer, or no node to open. An event device may be there before a hidraw node of the same
/// tablet, which is preferred.
bool is_on_its_way(const LiveTablet& tablet) {
  return tablet.access == Access::absent || (tablet.interface.hidraw_node.empty() && tablet.access != Access::busy);
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

bool udev_runs() { return ::access(k_udev_socket, F_OK) == 0; }

bool TabletChanges::replaced(const LiveTablet& one) const {
  return one.transport == Transport::event && std::any_of(arrived.begin(), arrived.end(), [&](const LiveTablet& other) {
           return other.interface.parent == one.interface.parent && other.transport != Transport::event;
         });
}

TabletChanges changes_between(const std::vector<LiveTablet>& before, const std::vector<LiveTablet>& after) {
  return {without(after, before), without(before, after)};
}

std::vector<LiveTablet> Settling::settle(const std::vector<LiveTablet>& known, std::vector<LiveTablet> seen,
                                         std::int64_t now_us) {
  std::vector<LiveTablet> told;
  std::map<std::string, std::int64_t> since_us;
  until_us_.reset();
  for (LiveTablet& tablet : seen) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const LiveTablet& other) { return same(tablet, other); });
    if (is_known || !is_on_its_way(tablet)) {
      told.push_back(std::move(tablet));
      continue;
    }
    const std::string place = place_of(tablet);
    const auto before = since_us_.find(place);
    const std::int64_t begin_us = before == since_us_.end() ? now_us : before->second;
    since_us[place] = begin_us;
    if (now_us - begin_us >= k_patience_us) {
      told.push_back(std::move(tablet));
      continue;
    }
    until_us_ = std::min(until_us_.value_or(begin_us + k_patience_us), begin_us + k_patience_us);
    const auto as_it_was =
        std::find_if(known.begin(), known.end(), [&](const LiveTablet& other) { return place_of(other) == place; });
    if (as_it_was != known.end()) told.push_back(*as_it_was);
  }
  since_us_ = std::move(since_us);
  return told;
}

class TabletWatch::Monitor {
 public:
  /// Errors: the system has none of the three files.
  [[nodiscard]] static std::unique_ptr<Monitor> start() {
    auto made = std::make_unique<Monitor>();
    made->events = File(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    // Where udev runs, its events come later than the kernel's and so are those to wait for.
    address.nl_groups = udev_runs() ? k_from_udev : k_from_kernel;
    if (::bind(made->events.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return nullptr;
    made->timer = File(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
    made->either = File(::epoll_create1(EPOLL_CLOEXEC));
    for (const int file : {made->events.get(), made->timer.get()}) {
      epoll_event event{};
      event.events = EPOLLIN;
      if (::epoll_ctl(made->either.get(), EPOLL_CTL_ADD, file, &event) != 0) return nullptr;
    }
    return made;
  }

  /// Makes `either` readable then; never where there is no time.
  void wake_at(std::optional<std::int64_t> time_us) const {
    itimerspec when{};
    if (time_us) {
      when.it_value.tv_sec = *time_us / 1'000'000;
      when.it_value.tv_nsec = *time_us % 1'000'000 * 1000;
    }
    ::timerfd_settime(timer.get(), TFD_TIMER_ABSTIME, &when, nullptr);
  }

  /// Whether the time of `wake_at` has come since the last call, or a device of ours has come or gone: waits for that,
  /// and then until nothing more comes.
  [[nodiscard]] bool wait(int timeout_ms) const {
    if (!readable(either, timeout_ms)) return false;
    std::uint64_t times = 0;
    bool changed = ::read(timer.get(), &times, sizeof times) == sizeof times;
    for (int i = 0; i < k_most_settles && readable(events, i == 0 ? 0 : k_settle_ms); ++i) changed |= take();
    return changed;
  }

  File either;  ///< readable when one of the other two is

 private:
  [[nodiscard]] static bool readable(const File& file, int timeout_ms) {
    pollfd waiting{file.get(), POLLIN, 0};
    return ::poll(&waiting, 1, timeout_ms) > 0;
  }

  /// Takes one event; whether it is of a device of ours.
  [[nodiscard]] bool take() const {
    std::array<char, k_longest_event> buffer{};
    sockaddr_nl sender{};
    iovec into{buffer.data(), buffer.size()};
    msghdr message{};
    message.msg_name = &sender;
    message.msg_namelen = sizeof sender;
    message.msg_iov = &into;
    message.msg_iovlen = 1;
    const ssize_t got = ::recvmsg(events.get(), &message, 0);
    // Events that were lost may have been of ours.
    if (got < 0) return errno == ENOBUFS;
    // Any program may send to this socket; to a group only root.
    if (sender.nl_groups == 0) return false;
    const std::string_view text(buffer.data(), static_cast<std::size_t>(got));
    for (const char* subsystem : {"hidraw", "usb", "input"}) {
      if (text.find("SUBSYSTEM=" + std::string(subsystem) + '\0') != std::string_view::npos) return true;
    }
    return false;
  }

  File events;
  File timer;
};

TabletWatch::TabletWatch(std::unique_ptr<Monitor> monitor, const decode::TabletTable* own,
                         std::vector<LiveTablet> tablets)
    : monitor_(std::move(monitor)), own_(own), tablets_(std::move(tablets)) {}
TabletWatch::TabletWatch(TabletWatch&&) noexcept = default;
TabletWatch& TabletWatch::operator=(TabletWatch&&) noexcept = default;
TabletWatch::~TabletWatch() = default;

base::Result<TabletWatch> TabletWatch::start(const decode::TabletTable* own) {
  auto made = Monitor::start();
  if (!made) return base::Error{"the system tells nothing of devices that come and go", "", ""};
  return TabletWatch(std::move(made), own, list_tablets(own));
}

int TabletWatch::wake_fd() const { return monitor_->either.get(); }

TabletChanges TabletWatch::next(int timeout_ms) {
  if (!monitor_->wait(timeout_ms)) return {};
  auto settled = settling_.settle(tablets_, list_tablets(own_, tablets_), monotonic_us());
  monitor_->wake_at(settling_.until_us());
  TabletChanges changes = changes_between(tablets_, settled);
  tablets_ = std::move(settled);
  return changes;
}

}  // namespace penpose::device
