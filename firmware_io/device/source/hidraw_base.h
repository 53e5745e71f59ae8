#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "firmware_io/device/queue_gauge.h"
#include "firmware_io/device/report_source.h"
#include "firmware_io/device/source/usb_strings.h"

namespace penpose::device {

/// What both ways to hidraw do alike.
class HidrawBase : public ReportSource {
 public:
  explicit HidrawBase(std::string usb_node) : usb_node_(std::move(usb_node)) {}
  base::Result<std::string> read_string(std::uint8_t index) override { return read_usb_string(usb_node_, index); }

 protected:
  static base::Status sent(std::ptrdiff_t count) {
    if (count < 0) return base::Error{"the device took no report", "", "plug it in again"};
    return base::Done{};
  }
  static base::Result<std::vector<std::uint8_t>> received(std::vector<std::uint8_t> bytes, int count) {
    if (count < 0) return base::Error{"the device gives no report", "", ""};
    bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(count)));
    return bytes;
  }

  QueueGauge gauge_;

 private:
  std::string usb_node_;
};

}  // namespace penpose::device
