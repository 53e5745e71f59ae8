#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penpose::model_io {

/// Makes every name different: the second "eye" becomes "eye.2" (or the next number that is free). Names that differ
/// already stay as they are.
void make_unique(std::vector<std::string>& names);

/// The text with every byte that is not part of valid UTF-8 replaced by "?", so that every format can write it.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace penpose::model_io
