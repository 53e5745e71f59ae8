#pragma once

#include <cstdint>

namespace penpose::device {

/// Infers from the reads of a queue that drops silently whether it was full: then all its reports are available at
/// once, faster than any tablet sends. A merely slow reader also never empties the queue, but takes longer.
class QueueGauge {
 public:
  /// Number of reports that Linux queues for a reader of /dev/hidrawN; further ones are dropped.
  static constexpr int k_capacity = 63;

  /// Call after each read: whether its report was already waiting, and when it was read. True when the queue was full,
  /// once each time.
  bool was_full(bool at_once, std::int64_t time_us);

 private:
  int run_ = 0;  ///< reports that were read one right after another
  std::int64_t begin_us_ = 0;
};

}  // namespace penpose::device
