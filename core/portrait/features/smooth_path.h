#pragma once

#include <cstddef>
#include <vector>

namespace penpose::portrait {

/// One place a row so that the sum of their scores is highest, where neighbours are at most `jump` places apart and
/// cost `rough` times the square of that. Precondition: rows of one length, not empty.
[[nodiscard]] std::vector<std::size_t> smooth_path(const std::vector<std::vector<double>>& scores, int jump,
                                                   double rough);

}  // namespace penpose::portrait
