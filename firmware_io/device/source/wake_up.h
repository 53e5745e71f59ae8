#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// What makes a tablet send pen reports: strings to read, then feature reports to send, then output reports.
struct WakeUp {
  std::vector<std::uint8_t> read_strings;
  std::vector<std::vector<std::uint8_t>> send_features;
  std::vector<std::vector<std::uint8_t>> send_outputs;
  int feature_delay_ms = 0;  ///< wait before each feature report
  bool ask_first = false;    ///< send a feature report only where the device does not say already what it would set

  [[nodiscard]] bool empty() const { return read_strings.empty() && send_features.empty() && send_outputs.empty(); }
};

/// What the table says of a tablet; empty unless the match is certain, because a tablet that is another one may take
/// the same bytes for something else.
[[nodiscard]] WakeUp wake_up_of(const std::optional<decode::TabletMatch>& match);

/// Told each step in a line, for the recording: "wake string 200: ...", "wake feature 02 02: sent", "... refused: ...".
using TellStep = std::function<void(std::string_view)>;
/// Waits that many milliseconds.
using WaitMs = std::function<void(int)>;

/// Takes all steps in order. One that fails is told and stepped over: of many tablets only the asking counts, and they
/// answer with an error. Gives the number of reports that were refused.
int wake(ReportSource& source, const WakeUp& steps, const TellStep& tell, const WaitMs& wait);

}  // namespace penpose::device
