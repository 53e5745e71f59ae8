#include "firmware_io/device/report_ring.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace penpose::device {
namespace {

constexpr std::size_t k_least_bytes = 256;
constexpr std::size_t k_most_bytes = std::size_t{1} << 30;

}  // namespace

ReportRing::ReportRing(std::size_t bytes)
    : memory_(std::bit_ceil(std::clamp(bytes, k_least_bytes, k_most_bytes))), mask_(memory_.size() - 1) {}

void ReportRing::copy_in(std::uint64_t at, const void* from, std::size_t count) {
  if (count == 0) return;
  const std::size_t start = at & mask_;
  const std::size_t first = std::min(count, memory_.size() - start);
  std::memcpy(memory_.data() + start, from, first);
  std::memcpy(memory_.data(), static_cast<const std::uint8_t*>(from) + first, count - first);
}

void ReportRing::copy_out(std::uint64_t at, void* to, std::size_t count) const {
  if (count == 0) return;
  const std::size_t start = at & mask_;
  const std::size_t first = std::min(count, memory_.size() - start);
  std::memcpy(to, memory_.data() + start, first);
  std::memcpy(static_cast<std::uint8_t*>(to) + first, memory_.data(), count - first);
}

bool ReportRing::append(RecordKind kind, std::int64_t time_us, base::Bytes bytes) {
  const std::uint64_t written = written_.load(std::memory_order_relaxed);
  const std::uint64_t used = written - read_.load(std::memory_order_acquire);
  if (sizeof(Header) + bytes.size() > memory_.size() - used) return false;
  const Header header{time_us, static_cast<std::uint32_t>(bytes.size()), kind};
  copy_in(written, &header, sizeof header);
  copy_in(written + sizeof header, bytes.data(), bytes.size());
  written_.store(written + sizeof header + bytes.size(), std::memory_order_release);
  return true;
}

bool ReportRing::push(RecordKind kind, std::int64_t time_us, base::Bytes bytes) {
  bool fits = true;
  if (untold_ > 0) {
    std::uint8_t count[sizeof untold_];
    std::memcpy(count, &untold_, sizeof untold_);
    fits = append(RecordKind::lost, time_us, count);
    if (fits) untold_ = 0;
  }
  if (fits && append(kind, time_us, bytes)) return true;
  if (kind == RecordKind::report) {
    ++untold_;
    overruns_.fetch_add(1, std::memory_order_relaxed);
  }
  return false;
}

bool ReportRing::empty() const {
  return written_.load(std::memory_order_acquire) == read_.load(std::memory_order_relaxed);
}

bool ReportRing::pop(Record& into) {
  const std::uint64_t read = read_.load(std::memory_order_relaxed);
  if (written_.load(std::memory_order_acquire) == read) return false;
  Header header{};
  copy_out(read, &header, sizeof header);
  into.kind = header.kind;
  into.time_us = header.time_us;
  into.lost = 0;
  into.bytes.resize(header.length);
  copy_out(read + sizeof header, into.bytes.data(), header.length);
  if (into.kind == RecordKind::lost) {
    std::memcpy(&into.lost, into.bytes.data(), std::min(sizeof into.lost, into.bytes.size()));
    into.bytes.clear();
  }
  read_.store(read + sizeof header + header.length, std::memory_order_release);
  return true;
}

}  // namespace penpose::device
