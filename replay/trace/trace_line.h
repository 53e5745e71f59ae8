#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::replay {

enum class TraceLineKind : std::uint8_t {
  other,       ///< a comment, a remark, an empty line
  device,      ///< D: the lines that follow belong to interface `device`
  descriptor,  ///< R: report descriptor in `bytes`
  name,        ///< N: in `value`
  physical,    ///< P: in `value`
  identity,    ///< I: bus, vendor and product
  string,      ///< # string INDEX: "TEXT" of the device, in `index` and `value`
  report,      ///< E: an input report in `bytes` at `time_us`
};

/// How a program writes its numbers; hid-recorder's versions differ.
struct TraceStyle {
  bool blank_after_device = true;  ///< "D: 0" or "D:0"
  bool upper_case_ids = false;     ///< "056A" or "056a"
  int second_digits = 1;           ///< least number of digits before the point, 6 in newer versions
  bool carriage_return = false;    ///< lines end with CR LF
};

/// One line of a trace. What it points to is valid until the next line is read.
struct TraceLine {
  TraceLineKind kind = TraceLineKind::other;
  std::uint64_t number = 0;  ///< from 1
  std::string_view text;     ///< without the line end
  std::string_view end;      ///< "\n", "\r\n", or empty where the file ends without one
  int device = 0;
  std::string_view value;
  int index = 0;
  std::uint16_t bus = 0;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::int64_t time_us = 0;
  base::Bytes bytes;
  /// Why a line that starts like one of the kinds is none: it counts as `other`. Empty otherwise.
  std::string_view problem;
};

/// Reads one line; `bytes` takes what `line.bytes` will point to. `text` is without its line end.
[[nodiscard]] TraceLine parse_trace_line(std::string_view text, std::vector<std::uint8_t>& bytes);

// Lines as hid-recorder writes them, appended to `out`.
void append_device(std::string& out, int device, const TraceStyle& style = {});
void append_descriptor(std::string& out, base::Bytes descriptor, const TraceStyle& style = {});
void append_name(std::string& out, std::string_view name, const TraceStyle& style = {});
void append_physical(std::string& out, std::string_view path, const TraceStyle& style = {});
void append_identity(std::string& out, std::uint16_t bus, std::uint16_t vendor, std::uint16_t product,
                     const TraceStyle& style = {});
void append_report(std::string& out, std::int64_t time_us, base::Bytes report, const TraceStyle& style = {});
/// A USB string of a device: a comment for programs that do not know it. It tells models with the same ids apart.
void append_string(std::string& out, int index, std::string_view text, const TraceStyle& style = {});
/// A report of `length` bytes of which only the first are known: a reader leaves it out and says so.
void append_cut_report(std::string& out, std::int64_t time_us, std::size_t length, base::Bytes first,
                       const TraceStyle& style = {});
/// A comment of one line; line breaks in `text` become blanks, because a second line would not be a comment.
void append_comment(std::string& out, std::string_view text, const TraceStyle& style = {});

/// Appends a line byte for byte as it was read.
void append_line(std::string& out, const TraceLine& line);

}  // namespace penpose::replay
