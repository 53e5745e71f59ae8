#pragma once

#include <cstdint>
#include <vector>

namespace penpose::speech {

/// How English words are said, in CMU's form: PocketSphinx' dictionary where Debian has it; empty where it is not.
[[nodiscard]] std::vector<std::uint8_t> english_dictionary();

}  // namespace penpose::speech
