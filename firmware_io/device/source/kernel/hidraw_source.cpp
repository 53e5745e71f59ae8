#include "firmware_io/device/source/hidraw_source.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

#include "firmware_io/device/clock.h"
#include "firmware_io/device/source/hidraw_base.h"

namespace penpose::device {
namespace {

/// Linux, Documentation/hid/hidraw.rst.
class HidrawSource final : public HidrawBase {
 public:
  HidrawSource(int file, std::string usb_node) : HidrawBase(std::move(usb_node)), file_(file) {}
  ~HidrawSource() override { ::close(file_); }

  ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) override {
    ssize_t got = ::read(file_, into.data(), into.size());
    const bool at_once = got > 0;
    if (got < 0 && errno == EAGAIN) {
      pollfd waiting{file_, POLLIN, 0};
      if (::poll(&waiting, 1, timeout_ms) <= 0) return {};
      got = ::read(file_, into.data(), into.size());
    }
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    // Unplugged: the kernel says so only after all reports that it has kept.
    if (got < 0) return {ReadState::gone, 0, monotonic_us()};
    if (got == 0) return {};
    const std::int64_t time_us = monotonic_us();
    return {ReadState::report, static_cast<std::size_t>(got), time_us, gauge_.was_full(at_once, time_us)};
  }

  base::Status send_feature(base::Bytes report) override {
    std::vector<std::uint8_t> bytes(report.begin(), report.end());
    return sent(::ioctl(file_, HIDIOCSFEATURE(bytes.size()), bytes.data()));
  }
  base::Status send_output(base::Bytes report) override { return sent(::write(file_, report.data(), report.size())); }
  base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t id, std::size_t length) override {
    std::vector<std::uint8_t> bytes(std::clamp<std::size_t>(length, 1, k_longest_report - 1));
    bytes[0] = id;
    const int got = ::ioctl(file_, HIDIOCGFEATURE(bytes.size()), bytes.data());
    return received(std::move(bytes), got);
  }

 private:
  int file_;
};

}  // namespace

base::Result<std::unique_ptr<ReportSource>> open_hidraw(const HidInterface& interface) {
  const int file = ::open(interface.hidraw_node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    return base::Error{"cannot be opened (" + std::generic_category().message(errno) + ")", "",
                       "`penpose devices` says what is missing"};
  }
  return std::unique_ptr<ReportSource>(std::make_unique<HidrawSource>(file, interface.usb_node));
}

}  // namespace penpose::device
