#pragma once

#include <cstdint>

namespace penpose::device {

/// Tells from the reads of a queue that drops without a word whether it was full: then all that it holds is there at
/// once, faster than any tablet sends. A reader that is merely slow sees no end of the queue either, but takes longer.
class QueueGauge {
 public:
  /// Reports that Linux keeps for a reader of /dev/hidrawN; what comes when there are as many is dropped.
  static constexpr int k_capacity = 63;

  /// After each read: whether its report was there already, and when it was read. True when the queue was full, once
  /// each time that it was.
  bool was_full(bool at_once, std::int64_t time_us);

 private:
  int run_ = 0;  ///< reports that were read one right after another
  std::int64_t begin_us_ = 0;
};

}  // namespace penpose::device
