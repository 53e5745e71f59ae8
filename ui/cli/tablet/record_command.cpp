#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include "core/base/text/shown_text.h"
#include "firmware_io/device/clock.h"
#include "firmware_io/device/list/event_list.h"
#include "firmware_io/device/list/interface_list.h"
#include "firmware_io/device/list/permission.h"
#include "firmware_io/device/list/tablet_watch.h"
#include "firmware_io/device/live_tablet.h"
#include "firmware_io/device/report_pump.h"
#include "firmware_io/record/tablet_recorder.h"
#include "ui/cli/number_range.h"
#include "ui/cli/subcommand.h"
#include "ui/cli/tablet/tablet_options.h"
#include "ui/files/append_file.h"
#include "ui/files/files.h"
#include "ui/files/process/own_program.h"
#include "ui/files/process/stop_signal.h"

namespace penpose::cli {
namespace {

struct RecordOptions {
  std::string output;
  std::string device;
  files::OwnTablets own;
  double seconds = 0;
};

constexpr int k_wait_ms = 100;
constexpr std::int64_t k_batch_us = 4'000;
constexpr std::int64_t k_progress_us = 250'000;
constexpr std::int64_t k_flush_us = 1'000'000;

/// The interface that the option names, recognised or not, else all of every tablet that is plugged in.
base::Result<std::vector<device::LiveTablet>> wanted_tablets(const RecordOptions& options,
                                                             const decode::TabletTable* own) {
  if (!options.device.empty()) {
    auto interfaces = device::list_interfaces();
    auto events = device::list_event_devices();
    std::move(events.begin(), events.end(), std::back_inserter(interfaces));
    for (auto& interface : interfaces) {
      const bool event = options.device == interface.event_node;
      const bool hidraw = options.device == interface.hidraw_node;
      if (!event && !hidraw && options.device != "usb:" + interface.usb_name) continue;
      auto tablet = device::recognise(std::move(interface), own);
      // Whoever names a path wants it read that way.
      tablet.use(event ? device::Transport::event : hidraw ? device::Transport::hidraw : device::Transport::libusb);
      return std::vector<device::LiveTablet>{std::move(tablet)};
    }
    return base::Error{"no such device is plugged in", options.device, "`penpose devices` lists them"};
  }
  auto tablets = device::list_tablets(own);
  if (tablets.empty()) {
    return base::Error{"no tablet is plugged in", "", "plug one in, or name any HID device with --device"};
  }
  return tablets;
}

/// A tablet that is being recorded.
struct Recorded {
  int number = 0;
  std::string name;
  std::string place;
  std::unique_ptr<device::ReportPump> pump;
  bool ended = false;
  bool taken = false;  ///< by another program, which was said
};

/// The same for an interface as long as it is plugged in, whoever has it.
std::string place_of(const device::LiveTablet& tablet) {
  // A receiver's nodes are made anew when it hears another tablet.
  const bool has_node = tablet.transport != device::Transport::libusb;
  return tablet.interface.parent + " " + tablet.interface.usb_node + " " + tablet.interface.usb_name + " " +
         (has_node ? std::to_string(tablet.interface.node_made) : "");
}

class RecordRun {
 public:
  RecordRun(const RecordOptions& options, const decode::TabletTable* own) : options_(options), own_(own) {}
  int run();

 private:
  base::Status open();
  void begin(device::LiveTablet tablet);
  void end(Recorded& tablet, const char* why);
  void take_arrivals();
  base::Status write_new();
  void take_records();
  void tell_taken();
  void wait();
  [[nodiscard]] bool all_gone() const;
  [[nodiscard]] std::uint64_t lost() const;
  void show_progress(std::int64_t now_us);
  void print_summary() const;

  const RecordOptions& options_;
  const decode::TabletTable* own_;
  std::optional<device::TabletWatch> watch_;
  std::vector<Recorded> tablets_;
  record::TabletRecorder recorder_;
  std::optional<files::AppendFile> file_;
  std::vector<std::pair<int, device::Record>> batch_;
  std::int64_t flushed_us_ = 0;
  std::int64_t waited_us_ = 0;
  std::int64_t shown_us_ = 0;
  std::uint64_t shown_reports_ = 0;
  bool visible_ = ::isatty(STDERR_FILENO) == 1;
};

/// Opens a tablet and begins to read it; what stands in the way is said on standard error.
void RecordRun::begin(device::LiveTablet tablet) {
  const std::string name = base::shown_name(tablet.interface.identity.name);
  const bool allowed = tablet.access == device::Access::allowed;
  auto source = allowed ? device::open_tablet(tablet, own_) : base::Error{"cannot be opened", "", ""};
  if (!source) {
    base::Error refusal = source.error();
    refusal.place = name + " (" + tablet.path() + ")";
    if (const auto why = device::missing(tablet, files::own_program()); !why.empty()) refusal.remedy = why;
    std::cerr << "penpose: " << refusal.line() << '\n';
    return;
  }
  const int number = recorder_.add_tablet(tablet.interface.identity, tablet.interface.trace_path(), own_);
  auto pump =
      std::make_unique<device::ReportPump>(std::move(*source), device::ReportPump::Options{tablet.wake_up(), true});
  tablets_.push_back({number, name, place_of(tablet), std::move(pump)});
  std::cerr << (visible_ ? "\r\033[K" : "") << "recording " << name << " (" << tablet.path() << ", "
            << (tablet.method.empty() ? "not recognised" : tablet.method) << ")\n";
}

base::Status RecordRun::open() {
  // Watched from before the first look, so that none slips through between.
  if (options_.device.empty()) {
    if (auto watch = device::TabletWatch::start(own_)) watch_.emplace(std::move(*watch));
  }
  auto wanted = wanted_tablets(options_, own_);
  if (!wanted) return wanted.error();
  for (device::LiveTablet& tablet : *wanted) begin(std::move(tablet));
  if (tablets_.empty()) return base::Error{"no tablet could be opened", "", "see above"};
  auto file = files::AppendFile::create(options_.output, recorder_.take());
  if (!file) return base::Error{file.error().what, options_.output, file.error().remedy};
  file_ = std::move(*file);
  return base::Done{};
}

void RecordRun::end(Recorded& tablet, const char* why) {
  // It may have sent something since the last `take`.
  device::Record record;
  while (tablet.pump->take(record)) recorder_.add(tablet.number, record);
  const std::string held = recorder_.end(tablet.number);
  tablet.ended = true;
  std::cerr << (visible_ ? "\r\033[K" : "") << tablet.name << why
            << (held.empty() ? "" : " with " + held + " held: let go") << '\n';
}

/// Tablets that come while others are recorded join them; one that can be read in a better way now is read once.
void RecordRun::take_arrivals() {
  if (!watch_) return;
  device::TabletChanges changes = watch_->next(0);
  for (const device::LiveTablet& left : changes.left) {
    if (!changes.replaced(left)) continue;
    for (Recorded& recorded : tablets_) {
      if (recorded.ended || recorded.place != place_of(left)) continue;
      recorded.pump->stop();
      end(recorded, " is read anew");
    }
  }
  for (device::LiveTablet& tablet : changes.arrived) {
    // One that was taken from the kernel's driver looks like another one since then.
    const bool known = std::any_of(tablets_.begin(), tablets_.end(), [&](const Recorded& recorded) {
      return !recorded.ended && recorded.place == place_of(tablet);
    });
    if (!known) begin(std::move(tablet));
  }
}

void RecordRun::take_records() {
  // What two tablets sent is put in order by time.
  batch_.clear();
  device::Record record;
  for (Recorded& tablet : tablets_) {
    while (tablet.pump->take(record)) batch_.emplace_back(tablet.number, std::move(record));
  }
  std::stable_sort(batch_.begin(), batch_.end(),
                   [](const auto& a, const auto& b) { return a.second.time_us < b.second.time_us; });
  for (const auto& [number, taken] : batch_) recorder_.add(number, taken);
  for (Recorded& tablet : tablets_) {
    if (!tablet.ended && tablet.pump->gone()) end(tablet, " was unplugged");
  }
}

void RecordRun::tell_taken() {
  for (Recorded& tablet : tablets_) {
    if (std::exchange(tablet.taken, tablet.pump->is_taken()) || !tablet.taken) continue;
    std::cerr << (visible_ ? "\r\033[K" : "") << "penpose: " << tablet.name
              << ": another program has it for itself, so nothing comes; close that program\n";
  }
}

base::Status RecordRun::write_new() {
  const std::string text = recorder_.take();
  if (auto done = file_->append(text); !done) return done;
  const std::int64_t now = device::monotonic_us();
  if (!recorder_.take_pen_up() && now - flushed_us_ < k_flush_us) return base::Done{};
  flushed_us_ = now;
  return file_->flush();
}

void RecordRun::wait() {
  // Of many reports a second several are taken together.
  const std::int64_t early_us = waited_us_ + k_batch_us - device::monotonic_us();
  if (early_us > 0) ::usleep(static_cast<useconds_t>(std::min(early_us, k_batch_us)));
  std::vector<pollfd> waiting;
  for (const Recorded& tablet : tablets_) {
    if (!tablet.ended) waiting.push_back({tablet.pump->wake_fd(), POLLIN, 0});
  }
  if (watch_) waiting.push_back({watch_->wake_fd(), POLLIN, 0});
  ::poll(waiting.data(), waiting.size(), k_wait_ms);
  waited_us_ = device::monotonic_us();
  for (const Recorded& tablet : tablets_) {
    if (!tablet.ended) tablet.pump->wait(0);
  }
}

/// Reports that came while this program was too slow, those among them that no comment tells of yet.
std::uint64_t RecordRun::lost() const {
  std::uint64_t sum = 0;
  for (const Recorded& tablet : tablets_) sum += tablet.pump->overruns();
  return sum;
}

bool RecordRun::all_gone() const {
  return std::all_of(tablets_.begin(), tablets_.end(), [](const Recorded& tablet) { return tablet.ended; });
}

void RecordRun::show_progress(std::int64_t now_us) {
  if (!visible_ || now_us - shown_us_ < k_progress_us) return;
  const auto& counts = recorder_.counts();
  const double seconds = static_cast<double>(now_us - shown_us_) / 1e6;
  const auto rate = std::lround(static_cast<double>(counts.reports - shown_reports_) / seconds);
  std::cerr << "\r\033[K" << counts.reports << " reports, " << (shown_us_ == 0 ? 0 : rate) << " a second, "
            << counts.strokes << " strokes";
  if (lost() > 0) std::cerr << ", " << lost() << " lost";
  std::cerr << std::flush;
  shown_us_ = now_us;
  shown_reports_ = counts.reports;
}

void RecordRun::print_summary() const {
  const auto& counts = recorder_.counts();
  if (visible_) std::cerr << "\r\033[K" << std::flush;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3f", static_cast<double>(counts.span_us) / 1e6);
  std::cout << options_.output << ": " << counts.reports << " reports in " << seconds << " s, " << counts.strokes
            << " strokes, " << counts.keys << " keys, " << lost() << " lost\n";
  for (const Recorded& tablet : tablets_) {
    if (tablet.pump->full_queues() == 0) continue;
    std::cerr << "penpose: " << tablet.name << ": the system's queue was full " << tablet.pump->full_queues()
              << " times, reports may be missing; the comments of the trace say where\n";
  }
  for (const Recorded& tablet : tablets_) {
    if (tablet.pump->refused() == 0) continue;
    std::cerr << "penpose: " << tablet.name << " refused " << tablet.pump->refused()
              << " of the reports that wake it; the comments of the trace say which\n";
  }
}

int RecordRun::run() {
  const files::StopSignal stop;
  if (const auto opened = open(); !opened) return files::report(opened.error());
  const std::int64_t begin = device::monotonic_us();
  const auto length_us = static_cast<std::int64_t>(options_.seconds * 1e6);
  base::Status status = base::Done{};
  bool over = false;
  while (status && !over) {
    wait();
    // Decided before the last look at the tablets, so that it takes all that came until then.
    const std::int64_t now = device::monotonic_us();
    over = files::StopSignal::asked() || (options_.seconds > 0 && now - begin >= length_us);
    take_records();
    tell_taken();
    take_arrivals();
    over = over || all_gone();
    status = write_new();
    show_progress(now);
  }
  for (const Recorded& tablet : tablets_) {
    if (!tablet.ended) static_cast<void>(recorder_.end(tablet.number));
  }
  if (status) status = file_->flush();
  if (!status) return files::report(status.error(), options_.output);
  print_summary();
  return k_success;
}

int record(const RecordOptions& options) {
  const auto own = files::read_own_tablets(options.own);
  if (!own) return files::report(own.error());
  return RecordRun(options, &*own).run();
}

void add_record_options(const Command& command, RecordOptions& options) {
  command.add_option("-o,--output", options.output, "The trace to write").required();
  command.add_option("--device", options.device, "One device by its path, as `penpose devices` gives it");
  command.add_option("--seconds", options.seconds, "Stop after that time")
      .check(number_range(1e-3, 1e9), "0.001 to 1000000000");
  add_tablet_options(command, options.own);
}

}  // namespace

Subcommand record_subcommand() {
  return subcommand<RecordOptions>(
      "record", files::Rights::all,
      "Records what tablets send, in hid-recorder's format, until Ctrl-C or until they are unplugged.",
      add_record_options, record, {"penpose record -o pen.hid", "until Ctrl-C, or until the tablets are unplugged"},
      {"penpose record -o short.hid --seconds 10", "ten seconds of them"});
}

}  // namespace penpose::cli
