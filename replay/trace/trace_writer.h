#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "replay/trace/trace_line.h"

namespace penpose::replay {

/// What a trace says of a device in front of its reports. Line breaks end `name` and `physical`.
struct TraceDevice {
  std::vector<std::uint8_t> report_descriptor;  ///< at most 65536 bytes, else a reader refuses it
  std::string name;
  std::string physical;  ///< ends in "/inputN" where N is the USB interface number
  std::uint16_t bus = 3;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::map<int, std::string> strings = {};  ///< of USB, by index, that were read
};

/// Makes the text of a trace as hid-recorder writes it; opens no file. What it gives out in pieces is, joined, a trace
/// whose every line is whole, so that a file cut off between two pieces is a valid trace.
class TraceWriter {
 public:
  explicit TraceWriter(TraceStyle style = {}) : style_(style) {}

  /// The lines D:, R:, N:, P: (only where it is known), I: and those of strings. Numbers run from 0 to 9999; declaring
  /// one again replaces what a reader knows of it, as after plugging in anew.
  void declare(int device, const TraceDevice& facts);

  /// A report of a declared device; a line D: stands before it where the line before was another device's. Times are
  /// microseconds since the recording's start, negative ones count as 0.
  void report(int device, std::int64_t time_us, base::Bytes bytes);

  /// The same of a report of `length` bytes of which only the first are known (append_cut_report).
  void cut_report(int device, std::int64_t time_us, std::size_t length, base::Bytes first);

  /// One comment line; line breaks become blanks.
  void comment(std::string_view text);
  /// A USB string that a device told later than its declaration.
  void string(int device, int index, std::string_view text);

  /// Everything written since the last call.
  [[nodiscard]] std::string take();
  /// Bytes that the next `take` gives.
  [[nodiscard]] std::size_t pending() const { return out_.size(); }

 private:
  void switch_to(int device);

  TraceStyle style_;
  std::string out_;
  std::optional<int> device_;  ///< that the lines belong to now
};

}  // namespace penpose::replay
