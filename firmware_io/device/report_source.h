#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/interface.h"
#include "core/base/result.h"

namespace penpose::device {

/// The longest report that Linux passes on.
inline constexpr std::size_t k_longest_report = 16384;

enum class ReadState : std::uint8_t {
  report,   ///< `length` bytes were read, received at `time_us`
  nothing,  ///< no report within the time
  gone,     ///< the device was unplugged or failed; there are no more reports
};

struct ReadOutcome {
  ReadState state = ReadState::nothing;
  std::size_t length = 0;
  std::int64_t time_us = 0;
  bool queue_was_full = false;  ///< before this report, so that reports may be missing there
};

/// One open HID interface. All calls come from one thread at a time. The destructor closes it and gives
/// the interface back to the system.
class ReportSource : public base::Interface {
 public:
  /// Waits at most `timeout_ms` for a report, its id first where reports are numbered; `into` holds k_longest_report.
  virtual ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) = 0;

  /// Sends a report, first byte its id (0 where reports have none).
  virtual base::Status send_feature(base::Bytes report) = 0;
  virtual base::Status send_output(base::Bytes report) = 0;
  /// Reads a feature report of at most that length, its id first.
  virtual base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t id, std::size_t length) = 0;
  /// Reads a USB string descriptor; characters outside ASCII come as '?'.
  virtual base::Result<std::string> read_string(std::uint8_t index) = 0;

  /// Whether what the device sends is to reach nobody else, the desktop among them; takes effect within the calls of
  /// `read`, once nothing is near, touched or held. Ignored where the system offers no such choice.
  virtual void set_exclusive(bool /*wanted*/) {}
  /// Whether that was asked for and another program has the device for itself, so that nothing comes from it.
  [[nodiscard]] virtual bool is_taken() const { return false; }
};

}  // namespace penpose::device
