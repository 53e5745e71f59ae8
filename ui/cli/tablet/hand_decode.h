#pragma once

#include <string>

#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::cli {

/// What of the hand `penpose decode` prints.
enum class HandPart { pad, touch };

struct HandDecodeOptions {
  std::string trace;
  std::string protocol;  ///< empty: what each device's own is
  HandPart part = HandPart::pad;
  bool json = false;
};

/// `penpose decode TRACE --pad|--touch [--csv | --json]`: keys and wheels, or fingers, of every interface of a trace.
/// Returns the exit code.
[[nodiscard]] int decode_hands(const HandDecodeOptions& options, const decode::TabletTable* own);

}  // namespace penpose::cli
