#include "ui/app/hands/tablets.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <poll.h>
#include <sys/eventfd.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "firmware_io/device/list/permission.h"
#include "firmware_io/device/report_pump.h"
#include "firmware_io/device/tablet_lights.h"
#include "ui/app/view/user_messages.h"
#include "ui/files/process/own_program.h"

namespace penpose::app {

struct Tablets::State {
  /// A tablet that is being read. Its number stays its own when it is plugged in again.
  struct Open {
    int number = 0;
    device::LiveTablet tablet;
    std::unique_ptr<device::ReportPump> pump;
    std::optional<decode::Lights> shown;  ///< the lights that it was told to show
    bool taken = false;                   ///< by another program, which was told
    bool replaced = false;                ///< by another way to read the same tablet
  };
  struct Opened {
    Open open;
    decode::DeviceIdentity identity;
    std::optional<decode::Lights> lights;  ///< that are on already
  };

  std::function<void()> wake;
  const decode::TabletTable* own;
  StartWatch start_watch;
  int stop_event = -1;
  std::atomic<bool> stop{false};
  std::atomic<unsigned> looks{0};
  std::thread thread;

  std::mutex mutex;  // guards what follows; held for moments only
  bool exclusive = false;
  std::vector<Open> open;
  std::vector<Opened> arrived;
  std::vector<std::string> refused;
  std::vector<std::pair<std::string, int>> known;  ///< tablets by their facts, and their numbers

  int number_of(const device::LiveTablet& tablet) {
    const auto& identity = tablet.interface.identity;
    const std::string key = std::to_string(identity.vendor) + ":" + std::to_string(identity.product) + ":" +
                            std::to_string(identity.interface_number.value_or(-1)) + ":" + identity.name;
    for (const auto& [name, number] : known) {
      const bool in_use =
          std::any_of(open.begin(), open.end(), [taken = number](const Open& one) { return one.number == taken; });
      if (name == key && !in_use) return number;
    }
    known.emplace_back(key, static_cast<int>(known.size()) + 1);
    return known.back().second;
  }

  void add(device::LiveTablet tablet) {
    const std::string name = tablet.interface.identity.name;
    auto source = tablet.access == device::Access::allowed ? device::open_tablet(tablet, own)
                                                           : base::Error{"cannot be opened", "", ""};
    const std::scoped_lock lock(mutex);
    if (!source) {
      // Fingers alone are missed by nobody who is told of the pen.
      if (tablet.carries == device::Carries::touch) return;
      const std::string why = device::missing(tablet, files::own_program());
      refused.push_back(name + ": " + (why.empty() ? source.error().line() : why));
      return;
    }
    auto pump = std::make_unique<device::ReportPump>(std::move(*source),
                                                     device::ReportPump::Options{tablet.wake_up(), exclusive});
    std::optional<decode::Lights> lights;
    if (device::kernel_switches_lights(tablet)) lights = device::seen_lights(tablet.interface);
    open.push_back({number_of(tablet), tablet, std::move(pump), {}});
    arrived.push_back({{open.back().number, tablet, nullptr, {}}, tablet.interface.identity, lights});
  }

  /// What is unplugged ends by itself, when all that it sent has been read.
  void end_replaced(const device::TabletChanges& changes) {
    const std::scoped_lock lock(mutex);
    for (const device::LiveTablet& left : changes.left) {
      if (!changes.replaced(left)) continue;
      for (Open& one : open) one.replaced = one.replaced || one.tablet.path() == left.path();
    }
  }

  /// A tablet that the kernel's driver does not serve shows the lights that the app has.
  static void show_lights(Open& one, const TabletEvents& events) {
    const auto lights = events.lights_of(one.number);
    // Behind a wireless receiver it may come again with another light than it left with.
    if (!lights) one.shown.reset();
    if (!lights || one.shown == lights || device::kernel_switches_lights(one.tablet)) return;
    one.shown = lights;
    const decode::DeviceIdentity& identity = one.tablet.interface.identity;
    if (auto report = decode::light_report(identity, *lights))
      one.pump->send_feature(std::move(*report), decode::only_light_byte(identity));
  }

  void run() {
    auto watch = start_watch();
    if (!watch) {
      {
        const std::scoped_lock lock(mutex);
        refused.push_back("No tablet found; draw with the mouse or by touch: " + message_of(watch.error()));
      }
      wake();
      return;
    }
    for (const auto& tablet : watch->tablets()) add(tablet);
    ++looks;
    wake();
    while (!stop) {
      std::vector<pollfd> waiting{{stop_event, POLLIN, 0}, {watch->wake_fd(), POLLIN, 0}};
      {
        const std::scoped_lock lock(mutex);
        for (const Open& one : open) waiting.push_back({one.pump->wake_fd(), POLLIN, 0});
      }
      if (::poll(waiting.data(), waiting.size(), -1) < 0 || stop) continue;
      if (waiting[1].revents != 0) {
        const device::TabletChanges changes = watch->next(0);
        end_replaced(changes);
        for (const auto& tablet : changes.arrived) add(tablet);
        ++looks;
      }
      {
        const std::scoped_lock lock(mutex);
        for (const Open& one : open) one.pump->wait(0);
      }
      wake();
    }
  }
};

Tablets::Tablets(std::function<void()> wake, const decode::TabletTable* own, StartWatch start_watch)
    : state_(std::make_unique<State>()) {
  state_->wake = std::move(wake);
  state_->own = own;
  state_->start_watch = start_watch ? std::move(start_watch) : [own] { return device::TabletWatch::start(own); };
  state_->stop_event = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  state_->thread = std::thread([this] { state_->run(); });
}

Tablets::~Tablets() {
  state_->stop = true;
  const std::uint64_t one = 1;
  static_cast<void>(!::write(state_->stop_event, &one, sizeof one));
  state_->thread.join();
  ::close(state_->stop_event);
}

void Tablets::set_exclusive(bool wanted) {
  const std::scoped_lock lock(state_->mutex);
  if (std::exchange(state_->exclusive, wanted) == wanted) return;
  for (const State::Open& one : state_->open) one.pump->set_exclusive(wanted);
}

unsigned Tablets::looks() const { return state_->looks; }

void Tablets::take(TabletEvents& events, Notices& notices) {
  std::vector<State::Open> gone;
  std::vector<std::pair<int, device::Record>> records;
  {
    const std::scoped_lock lock(state_->mutex);
    for (const auto& one : state_->arrived) {
      events.arrived(one.open.number, one.identity);
      if (one.lights) events.lights_seen(one.open.number, *one.lights);
    }
    state_->arrived.clear();
    for (const std::string& text : state_->refused) notices.tell(text, true);
    state_->refused.clear();
    device::Record record;
    for (auto& one : state_->open) {
      const bool ended = one.pump->gone() || one.replaced;
      if (!std::exchange(one.taken, one.pump->is_taken()) && one.taken) {
        notices.tell(one.tablet.interface.identity.name + ": another program has it for itself; close that program",
                     true);
      }
      while (one.pump->take(record)) records.emplace_back(one.number, std::move(record));
      if (ended) gone.push_back(std::move(one));
    }
    std::erase_if(state_->open, [](const State::Open& one) { return one.pump == nullptr; });
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.second.time_us < b.second.time_us; });
  for (const auto& [number, record] : records) {
    if (record.kind == device::RecordKind::report) events.report(number, record.time_us, record.bytes);
  }
  {
    const std::scoped_lock lock(state_->mutex);
    for (State::Open& one : state_->open) State::show_lights(one, events);
  }
  for (const State::Open& one : gone) events.left(one.number, one.tablet.interface.identity.name);
}

}  // namespace penpose::app
