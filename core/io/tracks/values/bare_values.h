#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/text/csv_reader.h"

namespace penpose::io {

/// The names of so many numbers whose file has none; empty where nobody knows. 52: ARKit's shapes in the order of
/// Apple's documentation (jawLeft before jawRight). 51: without tongueOut. 55: with headRoll, leftEyeRoll and
/// rightEyeRoll behind, as Azure's speech service documents its blend shapes. 61: with the turns of the head and the
/// eyes behind, as Unreal Engine's EARFaceBlendShape lists them.
[[nodiscard]] std::vector<std::string> usual_names(std::size_t count);
/// The note on them.
[[nodiscard]] std::string usual_names_note(std::size_t count);

/// How many numbers the first list of numbers in a text of JSON has; 0: there is none near the beginning.
[[nodiscard]] std::size_t first_numbers(std::string_view json);

/// A table of numbers without a header that has as many columns as usual_names knows, or one more that grows: a time.
struct BareTable {
  bool timed = false;
  std::size_t count = 0;  ///< of values; 0: it is none
};
[[nodiscard]] BareTable bare_table(std::string_view text);

/// Returns true for a cell that means nothing: "", "None", "null", "NA", "N/A" or "-", in any case.
[[nodiscard]] bool is_hole(std::string_view cell);

}  // namespace penpose::io
