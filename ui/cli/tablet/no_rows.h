#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::cli {

/// The reports of a trace over all its interfaces, none of which gave a row of a pen.
struct RowlessReports {
  std::uint64_t all = 0;
  std::uint64_t desktop = 0;  ///< of a mouse or keyboard
  std::uint64_t unread = 0;   ///< of interfaces that nothing knows
  /// Why the first of those is not known, and what it is.
  std::optional<base::Error> refusal;
  decode::DeviceIdentity refused;
  int refusals = 0;  ///< interfaces that nothing knows
};

/// Why there are no rows, in one line.
[[nodiscard]] base::Error why_no_rows(const RowlessReports& reports);

/// "1 report", "4 reports".
[[nodiscard]] std::string reports_in_words(std::uint64_t count);

}  // namespace penpose::cli
