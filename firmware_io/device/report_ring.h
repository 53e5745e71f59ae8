#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::device {

enum class RecordKind : std::uint8_t {
  report,  ///< `bytes` as the device sent them
  note,    ///< text in `bytes`: reports sent to wake the device, and why reading ended
  lost,    ///< `lost` reports between the one before and the one after did not fit into the ring
};

/// A record from a tablet, with its time (monotonic microseconds).
struct Record {
  RecordKind kind = RecordKind::report;
  std::int64_t time_us = 0;
  std::uint64_t lost = 0;
  std::vector<std::uint8_t> bytes;  ///< keeps its memory when the record is reused
};

/// Passes records of any length from exactly one thread to exactly one other, in order and without locks. Records that
/// do not fit are dropped and counted; a record of kind `lost` replaces them.
class ReportRing {
 public:
  /// Memory for about `bytes` of reports, rounded up to a power of two; a report costs 16 bytes plus its own.
  explicit ReportRing(std::size_t bytes);

  /// Producer: false if it did not fit.
  bool push(RecordKind kind, std::int64_t time_us, base::Bytes bytes);

  /// Consumer: takes the oldest record; false if there is none.
  bool pop(Record& into);

  /// Either: reports dropped so far.
  [[nodiscard]] std::uint64_t overruns() const { return overruns_.load(std::memory_order_relaxed); }
  /// Consumer: whether `pop` would give one.
  [[nodiscard]] bool empty() const;

 private:
  struct Header {
    std::int64_t time_us;
    std::uint32_t length;
    RecordKind kind;
  };
  static_assert(sizeof(Header) == 16);

  bool append(RecordKind kind, std::int64_t time_us, base::Bytes bytes);
  void copy_in(std::uint64_t at, const void* from, std::size_t count);
  void copy_out(std::uint64_t at, void* to, std::size_t count) const;

  std::vector<std::uint8_t> memory_;
  std::uint64_t mask_;
  std::uint64_t untold_ = 0;  ///< producer's: overruns without a record yet
  // Total bytes written and read; on separate cache lines, so that the two threads do not slow each other down.
  alignas(64) std::atomic<std::uint64_t> written_{0};
  alignas(64) std::atomic<std::uint64_t> read_{0};
  alignas(64) std::atomic<std::uint64_t> overruns_{0};
};

}  // namespace penpose::device
