#include "firmware_io/device/source/event_source.h"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fcntl.h>
#include <libevdev/libevdev.h>
#include <poll.h>
#include <set>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/device/clock.h"
#include "firmware_io/device/source/exclusive_use.h"
#include "firmware_io/event/event_encoder.h"

namespace penpose::device {
namespace {

struct CloseEvents {
  void operator()(libevdev* device) const {
    const int file = libevdev_get_fd(device);
    libevdev_free(device);
    if (file >= 0) ::close(file);
  }
};
using OpenDevice = std::unique_ptr<libevdev, CloseEvents>;

std::string or_empty(const char* value) { return value == nullptr ? std::string() : std::string(value); }

event::EventAxes axes_of(const libevdev* device) {
  event::EventAxes axes;
  axes.name = or_empty(libevdev_get_name(device));
  axes.physical = or_empty(libevdev_get_phys(device));
  axes.bus = static_cast<std::uint16_t>(libevdev_get_id_bustype(device));
  axes.vendor = static_cast<std::uint16_t>(libevdev_get_id_vendor(device));
  axes.product = static_cast<std::uint16_t>(libevdev_get_id_product(device));
  const auto codes = [&](unsigned type, unsigned maximum, std::set<std::uint16_t>& into) {
    for (unsigned code = 0; code <= maximum; ++code) {
      if (libevdev_has_event_code(device, type, code) == 1) into.insert(static_cast<std::uint16_t>(code));
    }
  };
  codes(EV_KEY, KEY_MAX, axes.keys);
  codes(EV_REL, REL_MAX, axes.rels);
  codes(EV_MSC, MSC_MAX, axes.mscs);
  for (unsigned code = 0; code <= ABS_MAX; ++code) {
    const input_absinfo* info = libevdev_get_abs_info(device, code);
    if (info != nullptr) axes.abs[static_cast<std::uint16_t>(code)] = {info->minimum, info->maximum, info->resolution};
  }
  for (unsigned property = 0; property <= INPUT_PROP_MAX; ++property) {
    if (libevdev_has_property(device, property) == 1) axes.properties.insert(static_cast<std::uint16_t>(property));
  }
  return axes;
}

/// The state in which it was found.
void begin(event::EventEncoder& encoder, const event::EventAxes& axes, const libevdev* device) {
  const auto put = [&](unsigned type, unsigned code, int value) {
    encoder.begin_with({static_cast<std::uint16_t>(type), static_cast<std::uint16_t>(code), value});
  };
  for (const auto& [code, range] : axes.abs) {
    if (code < ABS_MT_SLOT) put(EV_ABS, code, libevdev_get_event_value(device, EV_ABS, code));
  }
  for (const std::uint16_t key : axes.keys) put(EV_KEY, key, libevdev_get_event_value(device, EV_KEY, key));
  for (int slot = 0; slot < libevdev_get_num_slots(device); ++slot) {
    put(EV_ABS, ABS_MT_SLOT, slot);
    for (const unsigned code : {ABS_MT_TRACKING_ID, ABS_MT_POSITION_X, ABS_MT_POSITION_Y, ABS_MT_TOOL_TYPE}) {
      int value = 0;
      if (libevdev_fetch_slot_value(device, static_cast<unsigned>(slot), code, &value) == 1) put(EV_ABS, code, value);
    }
  }
  if (libevdev_get_num_slots(device) > 0) put(EV_ABS, ABS_MT_SLOT, libevdev_get_current_slot(device));
}

class EventSource final : public ReportSource {
 public:
  EventSource(OpenDevice handle, event::EventEncoder encoder, const event::EventAxes& axes)
      : handle_(std::move(handle)),
        encoder_(std::move(encoder)),
        keys_(axes.keys),
        shared_with_desktop_(event::has_fingers(axes)) {}

  ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) override {
    bool waited = false;
    while (waiting_.empty()) {
      input_event raw{};
      const int code = libevdev_next_event(handle_.get(), flag_, &raw);
      if (code == -EAGAIN && flag_ == LIBEVDEV_READ_FLAG_SYNC) {
        flag_ = LIBEVDEV_READ_FLAG_NORMAL;
      } else if (code == -EAGAIN || code == -EINTR) {
        if (!use_.is_settled() && is_at_rest()) {
          use_.settle([&](bool on) { return grab(on); }, monotonic_us());
        }
        if (waited || !wait(timeout_ms)) return {};
        waited = true;
      } else if (code < 0) {
        return {ReadState::gone, 0, monotonic_us()};
      } else if (code == LIBEVDEV_READ_STATUS_SYNC && flag_ == LIBEVDEV_READ_FLAG_NORMAL) {
        // The kernel dropped what did not fit; libevdev asks for the present state and gives the difference.
        flag_ = LIBEVDEV_READ_FLAG_SYNC;
        lost_ = true;
      } else {
        take(raw);
      }
    }
    const std::vector<std::uint8_t> report = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    const std::size_t length = std::min(report.size(), into.size());
    std::copy_n(report.begin(), length, into.begin());
    return {ReadState::report, length, time_us_, std::exchange(lost_, false)};
  }

  base::Status send_feature(base::Bytes) override { return no_reports(); }
  base::Status send_output(base::Bytes) override { return no_reports(); }
  base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t, std::size_t) override {
    return no_reports().error();
  }
  base::Result<std::string> read_string(std::uint8_t) override { return no_reports().error(); }

  void set_exclusive(bool wanted) override { use_.want(wanted && !shared_with_desktop_); }
  [[nodiscard]] bool is_taken() const override { return use_.is_refused(monotonic_us()); }

 private:
  static base::Status no_reports() { return base::Error{"an event device takes and gives no reports", "", ""}; }

  [[nodiscard]] bool wait(int timeout_ms) const {
    pollfd waiting{libevdev_get_fd(handle_.get()), POLLIN, 0};
    return ::poll(&waiting, 1, timeout_ms) > 0;
  }

  /// Nothing near, touched or held, as far as the kernel has said.
  [[nodiscard]] bool is_at_rest() const {
    return std::none_of(keys_.begin(), keys_.end(),
                        [&](std::uint16_t key) { return libevdev_get_event_value(handle_.get(), EV_KEY, key) != 0; });
  }

  [[nodiscard]] bool grab(bool on) const {
    return libevdev_grab(handle_.get(), on ? LIBEVDEV_GRAB : LIBEVDEV_UNGRAB) == 0;
  }

  void take(const input_event& raw) {
    const auto reports = encoder_.take({raw.type, raw.code, raw.value});
    if (reports.empty()) return;
    waiting_.assign(reports.begin(), reports.end());
    time_us_ = static_cast<std::int64_t>(raw.input_event_sec) * 1'000'000 + raw.input_event_usec;
  }

  OpenDevice handle_;
  event::EventEncoder encoder_;
  std::set<std::uint16_t> keys_;
  bool shared_with_desktop_;
  ExclusiveUse use_;
  event::EventEncoder::Reports waiting_;  ///< of the last frame, and not read yet
  std::int64_t time_us_ = 0;
  unsigned flag_ = LIBEVDEV_READ_FLAG_NORMAL;
  bool lost_ = false;
};

}  // namespace

base::Result<std::unique_ptr<ReportSource>> open_event_device(HidInterface& interface) {
  const auto fail = [](int code, const char* remedy) {
    return base::Error{"cannot be opened (" + std::generic_category().message(code) + ")", "", remedy};
  };
  const int file = ::open(interface.event_node.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return fail(errno, "`penpose devices` says what is missing");
  libevdev* made = nullptr;
  if (const int code = libevdev_new_from_fd(file, &made); code != 0) {
    ::close(file);
    return fail(-code, "name an input device");
  }
  OpenDevice handle(made);
  libevdev_set_clock_id(made, CLOCK_MONOTONIC);
  const event::EventAxes axes = axes_of(made);
  interface.identity.report_descriptor = event::report_descriptor(axes);
  interface.identity.input_report_length.reset();
  decode::complete_identity(interface.identity);
  event::EventEncoder encoder(axes);
  begin(encoder, axes, made);
  return std::unique_ptr<ReportSource>(std::make_unique<EventSource>(std::move(handle), std::move(encoder), axes));
}

}  // namespace penpose::device
