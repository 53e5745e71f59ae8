#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "firmware_io/decode/hand_factory.h"

namespace penpose::cli {

/// The state of a pad with where it came from.
struct PrintedPad {
  std::uint64_t report = 0;
  std::int64_t time_us = 0;
  int device = 0;
  const decode::PadSample* sample = nullptr;
  const decode::PadFeatures* features = nullptr;
};

/// The fingers at the end of a frame.
struct PrintedTouch {
  std::uint64_t report = 0;
  std::int64_t time_us = 0;
  int device = 0;
  std::span<const decode::TouchContact> contacts;
};

/// The lines of `penpose decode --pad --csv` and `--touch --csv` (cli.md).
void append_csv_pad_header(std::string& out, bool with_device);
void append_csv_pad(std::string& out, const PrintedPad& printed, bool with_device);
void append_csv_touch_header(std::string& out, bool with_device);
void append_csv_touch(std::string& out, const PrintedTouch& printed, bool with_device);

/// The same facts, and those that the rows leave out, as a JSON object that `out` has opened; its brace is closed.
void append_json_pad(std::string& out, const PrintedPad& printed, const decode::Battery& battery);
void append_json_touch(std::string& out, const PrintedTouch& printed);

/// What the interface has of pad and touch, as members of an object, and which of several tablets it is read as (empty:
/// it is known).
void append_json_hand(std::string& out, int device, const std::string& name, const decode::HandDecoders& hand);

}  // namespace penpose::cli
