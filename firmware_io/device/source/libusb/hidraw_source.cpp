#include "firmware_io/device/source/hidraw_source.h"

#include <algorithm>
#include <cerrno>
#include <hidapi/hidapi.h>

#include "firmware_io/device/clock.h"
#include "firmware_io/device/source/hidraw_base.h"

namespace penpose::device {
namespace {

struct Close {
  void operator()(hid_device* device) const { hid_close(device); }
};
using Handle = std::unique_ptr<hid_device, Close>;

class HidrawSource final : public HidrawBase {
 public:
  HidrawSource(Handle handle, std::string usb_node) : HidrawBase(std::move(usb_node)), handle_(std::move(handle)) {}

  ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) override {
    errno = 0;
    int got = hid_read_timeout(handle_.get(), into.data(), into.size(), 0);
    const bool at_once = got > 0;
    if (got == 0) got = hid_read_timeout(handle_.get(), into.data(), into.size(), timeout_ms);
    if (got < 0 && errno == EINTR) return {};
    // Unplugged: what the system has kept until then is still to be had, without waiting for it.
    if (got < 0) got = hid_read_timeout(handle_.get(), into.data(), into.size(), -1);
    if (got < 0) return {ReadState::gone, 0, monotonic_us()};
    if (got == 0) return {};
    const std::int64_t time_us = monotonic_us();
    return {ReadState::report, static_cast<std::size_t>(got), time_us, gauge_.was_full(at_once, time_us)};
  }

  base::Status send_feature(base::Bytes report) override {
    return sent(hid_send_feature_report(handle_.get(), report.data(), report.size()));
  }
  base::Status send_output(base::Bytes report) override {
    return sent(hid_write(handle_.get(), report.data(), report.size()));
  }
  base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t id, std::size_t length) override {
    std::vector<std::uint8_t> bytes(length);
    if (!bytes.empty()) bytes[0] = id;
    const int got = hid_get_feature_report(handle_.get(), bytes.data(), bytes.size());
    return received(std::move(bytes), got);
  }

 private:
  Handle handle_;
};

}  // namespace

base::Result<std::unique_ptr<ReportSource>> open_hidraw(const HidInterface& interface) {
  static const int initialised = hid_init();
  if (initialised != 0) return base::Error{"hidapi does not start", "", ""};
  Handle handle(hid_open_path(interface.hidraw_node.c_str()));
  if (!handle) {
    return base::Error{"cannot be opened", "", "`penpose devices` says what is missing"};
  }
  return std::unique_ptr<ReportSource>(std::make_unique<HidrawSource>(std::move(handle), interface.usb_node));
}

}  // namespace penpose::device
