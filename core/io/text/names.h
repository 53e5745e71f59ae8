#pragma once

#include <string>
#include <vector>

namespace penpose::io {

/// Makes every name different: the second "eye" becomes "eye.2" (or the next number that is free). Names that differ
/// already stay as they are.
void make_unique(std::vector<std::string>& names);

}  // namespace penpose::io
