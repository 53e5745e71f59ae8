#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

namespace penpose::tests {

/// Runs `body(begin, end)` over 0..count in contiguous pieces on up to `threads` threads (0: one for each processor).
/// The pieces may run at the same time and in any order, so `body` writes only to outputs that belong to its own
/// indices; then the result is the same for every number of threads. Returns when all pieces are done; what the
/// first of those that throw has thrown is thrown again then.
inline void parallel_for(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  threads = std::min(threads, count);
  const auto bound = [&](std::size_t piece) { return count / threads * piece + std::min(piece, count % threads); };
  // What a piece throws would end the program where it is; it goes on to the caller instead, the first piece's first.
  std::vector<std::exception_ptr> thrown(threads);
  const auto run = [&](std::size_t piece) {
    try {
      body(bound(piece), bound(piece + 1));
    } catch (...) {
      thrown[piece] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> workers;
    workers.reserve(threads - 1);
    std::size_t piece = 1;
    try {
      for (; piece < threads; ++piece) workers.emplace_back([&run, piece] { run(piece); });
    } catch (const std::system_error&) {
      // Where the system gives no more threads, this one does their work.
      for (; piece < threads; ++piece) run(piece);
    }
    run(0);
  }
  for (const std::exception_ptr& one : thrown) {
    if (one) std::rethrow_exception(one);
  }
}

}  // namespace penpose::tests
