#include "firmware_io/device/report_pump.h"

#include <algorithm>
#include <chrono>
#include <poll.h>
#include <string>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

#include "firmware_io/device/clock.h"

namespace penpose::device {
namespace {

/// How long a read waits; bounds the time that stopping takes and that a sleep of the system goes unnoticed.
constexpr int k_read_ms = 50;
/// A sleep shorter than this leaves a tablet as it was.
constexpr std::int64_t k_sleep_us = 200'000;

constexpr int k_priority = -10;

}  // namespace

ReportPump::ReportPump(std::unique_ptr<ReportSource> source, Options options)
    : source_(std::move(source)),
      options_(std::move(options)),
      ring_(options_.ring_bytes),
      event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      exclusive_(options_.exclusive) {
  if (!options_.slept_us) options_.slept_us = slept_us;
  if (!options_.wait) options_.wait = [](int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
  thread_ = std::thread([this] { run(); });
}

ReportPump::~ReportPump() {
  stop();
  if (event_ >= 0) ::close(event_);
}

void ReportPump::stop() {
  if (!thread_.joinable()) return;
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
  source_.reset();
}

void ReportPump::signal() {
  const std::uint64_t one = 1;
  // Fails only when it is readable already.
  [[maybe_unused]] const auto written = ::write(event_, &one, sizeof one);
}

void ReportPump::note(std::string_view text) {
  ring_.push(RecordKind::note, monotonic_us(), base::as_bytes(text));
  signal();
}

void ReportPump::send_feature(std::vector<std::uint8_t> report, std::optional<std::size_t> only) {
  const std::scoped_lock lock(to_send_mutex_);
  to_send_ = std::move(report);
  only_byte_ = only;
  has_to_send_.store(true, std::memory_order_release);
}

void ReportPump::send_waiting() {
  if (!has_to_send_.load(std::memory_order_acquire)) return;
  std::vector<std::uint8_t> report;
  std::optional<std::size_t> only;
  {
    const std::scoped_lock lock(to_send_mutex_);
    report.swap(to_send_);
    only = only_byte_;
    has_to_send_.store(false, std::memory_order_relaxed);
  }
  if (only && *only < report.size()) {
    // One that does not answer gets the report as it is.
    auto now = source_->get_feature(report[0], report.size());
    if (now && now->size() == report.size() && now->front() == report[0]) {
      (*now)[*only] = report[*only];
      report = std::move(now).value();
    }
  }
  if (!source_->send_feature(report)) refused_.fetch_add(1, std::memory_order_relaxed);
}

void ReportPump::wake_tablet() {
  if (options_.wake_up.empty()) return;
  const int refused = wake(
      *source_, options_.wake_up, [this](std::string_view step) { note(step); }, options_.wait);
  refused_.fetch_add(refused, std::memory_order_relaxed);
}

void ReportPump::look_who_has_it() {
  const bool taken = source_->is_taken();
  if (taken == is_taken()) return;
  taken_.store(taken, std::memory_order_relaxed);
  note(taken ? "another program has the device for itself" : "the other program let go of the device");
}

void ReportPump::run() {
  // The system keeps 64 reports at most: ask to be run before others. Where that is not permitted, as before.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), k_priority);
  std::vector<std::uint8_t> buffer(k_longest_report);
  std::int64_t slept = options_.slept_us();
  wake_tablet();
  while (!stop_.load(std::memory_order_relaxed)) {
    send_waiting();
    source_->set_exclusive(exclusive_.load(std::memory_order_relaxed));
    const ReadOutcome outcome = source_->read(buffer, k_read_ms);
    look_who_has_it();
    if (const std::int64_t now = options_.slept_us(); now - slept > k_sleep_us) {
      note("the system slept for " + std::to_string((now - slept) / 1000) + " ms");
      slept = now;
      wake_tablet();
    }
    if (outcome.state == ReadState::gone) {
      note("the device is gone");
      gone_.store(true, std::memory_order_release);
      signal();
      return;
    }
    if (outcome.state == ReadState::nothing) continue;
    received_.fetch_add(1, std::memory_order_relaxed);
    if (outcome.queue_was_full) {
      full_queues_.fetch_add(1, std::memory_order_relaxed);
      note("the system's queue was full, reports may be missing around here");
    }
    ring_.push(RecordKind::report, outcome.time_us, base::Bytes(buffer).first(std::min(outcome.length, buffer.size())));
    signal();
  }
}

bool ReportPump::wait(int timeout_ms) {
  const std::int64_t until_us = monotonic_us() + std::int64_t{timeout_ms} * 1000;
  for (;;) {
    // Read before looking: what comes after makes it readable again.
    std::uint64_t count = 0;
    [[maybe_unused]] const auto got = ::read(event_, &count, sizeof count);
    if (!ring_.empty() || gone()) return true;
    const std::int64_t left_us = until_us - monotonic_us();
    if (left_us <= 0) return false;
    pollfd waiting{event_, POLLIN, 0};
    ::poll(&waiting, 1, static_cast<int>((left_us + 999) / 1000));
  }
}

}  // namespace penpose::device
