#include "core/base/parallel.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace penpose::base {

void parallel_for(std::size_t count, std::size_t threads, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  threads = std::min(threads, count);
  const auto bound = [&](std::size_t piece) { return count / threads * piece + std::min(piece, count % threads); };
  std::vector<std::jthread> workers;
  workers.reserve(threads - 1);
  for (std::size_t piece = 1; piece < threads; ++piece) {
    workers.emplace_back([&body, begin = bound(piece), end = bound(piece + 1)] { body(begin, end); });
  }
  body(bound(0), bound(1));
}

}  // namespace penpose::base
