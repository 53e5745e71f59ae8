#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// The steps that make a tablet send pen reports: strings to read, then feature reports to send, then output reports.
struct WakeUp {
  std::vector<std::uint8_t> read_strings;
  std::vector<std::vector<std::uint8_t>> send_features;
  std::vector<std::vector<std::uint8_t>> send_outputs;
  int feature_delay_ms = 0;  ///< wait before each feature report
  bool ask_first = false;    ///< send a feature report only if the device does not have that state already

  [[nodiscard]] bool empty() const { return read_strings.empty() && send_features.empty() && send_outputs.empty(); }
};

/// The steps for a tablet of the table; empty unless the match is certain, because another tablet may interpret the
/// same bytes differently.
[[nodiscard]] WakeUp wake_up_of(const std::optional<decode::TabletMatch>& match);

/// Receives a line for each step, for the recording: "wake string 200: ...", "wake feature 02 02: sent", "... refused:
/// ...".
using TellStep = std::function<void(std::string_view)>;
/// Waits that many milliseconds.
using WaitMs = std::function<void(int)>;

/// Runs all steps in order. A failed step is logged and skipped: for many tablets only the request matters, and they
/// answer with an error. Returns the number of refused reports.
int wake(ReportSource& source, const WakeUp& steps, const TellStep& tell, const WaitMs& wait);

}  // namespace penpose::device
