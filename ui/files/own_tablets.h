#pragma once

#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::files {

inline constexpr const char* k_tablets_option = "--tablets";
inline constexpr const char* k_tablet_option = "--tablet";

/// What the user says of tablets.
struct OwnTablets {
  std::string file;  ///< of their own, empty: none
  std::string
      name;  ///< of the one that is meant, from the file or from those that are known; empty: what it is found to be
};

/// The tablets of the file, or the one that is named; none where neither is.
[[nodiscard]] base::Result<decode::TabletTable> read_own_tablets(const OwnTablets& own);

/// Says of a guess (decode::Recognition) what to do.
[[nodiscard]] std::string guess_note(const std::string& guess);

}  // namespace penpose::files
