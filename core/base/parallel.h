#pragma once

#include <cstddef>
#include <functional>

namespace penpose::base {

/// Runs `body(begin, end)` over 0..count in contiguous pieces on up to `threads` threads (0: one for each processor).
/// The pieces may run at the same time and in any order, so `body` writes only to outputs that belong to its own
/// indices; then the result is the same for every number of threads. Returns when all pieces are done; what the
/// first of those that throw has thrown is thrown again then.
void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace penpose::base
