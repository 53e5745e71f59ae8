#pragma once

#include <cstdint>
#include <string>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::cli {

/// A sample with where it came from.
struct PrintedSample {
  std::uint64_t report = 0;
  std::int64_t time_us = 0;
  int device = 0;
  const decode::PenSample* sample = nullptr;
  const decode::PenAxes* axes = nullptr;
};

/// The lines of `penpose decode --csv` (cli.md): axes and column names in front of the first row, then rows. Axes come
/// again where a recording of another tablet follows in the same file.
void append_csv_axes(std::string& out, const decode::PenAxes& axes);
void append_csv_header(std::string& out, const decode::PenAxes& axes, bool with_device);
void append_csv_row(std::string& out, const PrintedSample& printed, bool with_device);

/// The same facts as members of JSON objects, without the braces around the axes' or samples' list.
void append_json_axes(std::string& out, const decode::PenAxes& axes);
void append_json_sample(std::string& out, const PrintedSample& printed);

}  // namespace penpose::cli
