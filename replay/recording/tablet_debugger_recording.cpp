// OpenTabletDriver's tablet debugger writes a line a report while data recording is on (ReportFormatter.cs): since
// October 2025 "Device:NAME, { HEX }, Delta:MILLISECONDSms, ...", since 0.6.2 without the name, before that the bytes
// alone.

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/base/text/letters.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"
#include "replay/recording/hex_line.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {
namespace {

/// Reports whose line says no time are so far apart, as those of many tablets.
constexpr std::int64_t k_usual_period_us = 5000;
constexpr std::int64_t k_longest_pause_us = 3'600'000'000;
constexpr std::size_t k_most_debugged_interfaces = 256, k_longest_name = 256;

struct DebuggerLine {
  std::string_view name;                      ///< of the tablet, in OpenTabletDriver's table; empty: not told
  std::string_view bytes;                     ///< words of two hexadecimal digits
  std::int64_t since_us = k_usual_period_us;  ///< since the line before
};

/// Milliseconds with a point or, in some languages, a comma.
std::optional<std::int64_t> milliseconds(std::string_view text) {
  const std::size_t point = text.find_first_of(".,");
  const auto whole = decimal_number(text.substr(0, point), k_longest_pause_us / 1000);
  if (!whole) return std::nullopt;
  std::int64_t micros = static_cast<std::int64_t>(*whole) * 1000;
  if (point == std::string_view::npos) return micros;
  std::int64_t unit = 100;
  for (const char c : text.substr(point + 1)) {
    if (c < '0' || c > '9') return std::nullopt;
    micros += (c - '0') * unit;
    unit /= 10;
  }
  return micros;
}

std::optional<DebuggerLine> debugger_line(std::string_view text) {
  constexpr std::string_view k_device = "Device:";
  constexpr std::string_view k_delta = "Delta:";
  DebuggerLine line;
  std::size_t open = 0;
  if (text.starts_with(k_device)) {
    open = text.find(", { ");
    if (open == std::string_view::npos) return std::nullopt;
    line.name = text.substr(k_device.size(), std::min(open - k_device.size(), k_longest_name));
    open += 2;
  }
  if (!text.substr(open).starts_with("{ ")) return std::nullopt;
  const std::size_t close = text.find(" }, ", open);
  if (close == std::string_view::npos || close < open + 2) return std::nullopt;
  line.bytes = text.substr(open + 2, close - open - 2);
  std::string_view rest = text.substr(close + 4);
  if (!rest.starts_with(k_delta)) return std::nullopt;
  rest.remove_prefix(k_delta.size());
  const auto since = milliseconds(rest.substr(0, rest.find("ms")));
  if (!since) return std::nullopt;
  line.since_us = *since;
  return line;
}

bool marks_debugger(std::string_view line) { return debugger_line(line).has_value(); }

/// Whether a line is the bytes of a report alone, in capitals as C# prints them.
bool is_bare_report(std::string_view line) {
  if (line.size() < 5 || line.size() % 3 != 2) return false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool fits = i % 3 == 2 ? c == ' ' : (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F');
    if (!fits) return false;
  }
  return true;
}

/// Such lines alone, but for empty ones and comments.
bool is_bare_reports(base::Bytes front) {
  bool any = false;
  bool other = false;
  find_line(front, [&](std::string_view line) {
    if (line.empty() || line.starts_with('#')) return false;
    other = !is_bare_report(line);
    any = any || !other;
    return other;
  });
  return any && !other;
}

const decode::Tablet* tablet_named(std::string_view name) {
  for (const decode::Tablet& tablet : decode::known_tablets().tablets()) {
    if (base::same_but_case(tablet.vendor + " " + tablet.name, name)) return &tablet;
  }
  return nullptr;
}

/// The interface of a tablet whose reports have this length; the pen's where none says so.
const decode::TabletIdentifier* interface_of_length(const decode::Tablet& tablet, std::size_t length) {
  for (const auto* identifiers : {&tablet.identifiers, &tablet.pads}) {
    for (const decode::TabletIdentifier& identifier : *identifiers) {
      if (identifier.input_report_length == length) return &identifier;
    }
  }
  return tablet.identifiers.empty() ? nullptr : &tablet.identifiers.front();
}

/// Appends a field of so many bytes less the report id; `main` is the item that ends it.
void append_field(std::vector<std::uint8_t>& out, std::size_t length, std::uint8_t main) {
  if (length < 2) return;
  const std::size_t count = length - 1;
  for (const std::size_t byte : {std::size_t{0x96}, count & 0xff, count >> 8, std::size_t{0x09}, std::size_t{0x01},
                                 std::size_t{main}, std::size_t{0x02}}) {
    out.push_back(static_cast<std::uint8_t>(byte));
  }
}

/// A descriptor that says no more than the lengths of the interface's reports, by which the table of tablets tells the
/// interfaces of one tablet apart (HID 1.11, section 6.2.2).
std::vector<std::uint8_t> descriptor_of_lengths(const decode::TabletIdentifier& identifier, base::Bytes report) {
  const std::uint8_t id = std::max<std::uint8_t>(report[0], 1);
  std::vector<std::uint8_t> out{0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85,
                                id,   0x15, 0x00, 0x26, 0xff, 0x00, 0x75, 0x08};
  append_field(out, report.size(), 0x81);
  append_field(out, identifier.output_report_length.value_or(0), 0x91);
  append_field(out, identifier.feature_report_length.value_or(0), 0xb1);
  out.push_back(0xc0);
  return out;
}

class TabletDebugger final : public LineConverter {
 public:
  base::Status line(std::string_view text, std::string& out) override {
    auto line = debugger_line(text);
    if (!line && is_bare_report(text)) line = DebuggerLine{{}, text, k_usual_period_us};
    if (!line) return base::Done{};
    bytes_.clear();
    const bool whole = append_hex_words(line->bytes, bytes_);
    time_us_ += begun_ ? line->since_us : 0;
    begun_ = true;
    if (!whole || bytes_.empty()) {
      out += k_unreadable_line;
      return base::Done{};
    }
    if (const auto number = number_of(line->name)) writer_.report(*number, time_us_, bytes_);
    out += writer_.take();
    return base::Done{};
  }
  void finish(std::string&) override {}

 private:
  /// The number of the interface that sent bytes_: reports of one length, of one tablet.
  std::optional<int> number_of(std::string_view name) {
    const std::pair key{std::string(name), bytes_.size()};
    const auto found = numbers_.find(key);
    if (found != numbers_.end()) return found->second;
    if (numbers_.size() >= k_most_debugged_interfaces) return std::nullopt;
    const int number = static_cast<int>(numbers_.size());
    numbers_[key] = number;
    TraceDevice device;
    device.name = name;
    const decode::Tablet* const tablet = tablet_named(name);
    const auto* const identifier = tablet != nullptr ? interface_of_length(*tablet, bytes_.size()) : nullptr;
    if (identifier != nullptr) {
      device.vendor = identifier->vendor;
      device.product = identifier->product;
      if (identifier->input_report_length == bytes_.size())
        device.report_descriptor = descriptor_of_lengths(*identifier, bytes_);
    }
    writer_.declare(number, device);
    return number;
  }

  std::map<std::pair<std::string, std::size_t>, int> numbers_;
  std::vector<std::uint8_t> bytes_;
  std::int64_t time_us_ = 0;
  bool begun_ = false;
  TraceWriter writer_;
};

ReadBytes convert_tablet_debugger(ReadBytes read) {
  return convert_lines(std::move(read), std::make_shared<TabletDebugger>());
}

bool marks_diagnostics(std::string_view line) { return line.starts_with("\"App Version\": \"OpenTabletDriver "); }

base::Error holds_no_reports() {
  return {"is OpenTabletDriver's diagnostics, which hold no reports", "",
          "give what its tablet debugger records, or record with `penpose record`"};
}

}  // namespace

RecordingFormat tablet_debugger_recording() {
  return {"OpenTabletDriver's tablet debugger", is_bare_reports, marks_debugger, convert_tablet_debugger, nullptr};
}

RecordingFormat open_tablet_driver_diagnostics() {
  return {"OpenTabletDriver's diagnostics", nullptr, marks_diagnostics, nullptr, holds_no_reports};
}

}  // namespace penpose::replay
