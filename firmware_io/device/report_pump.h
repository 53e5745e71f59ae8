#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "firmware_io/device/report_ring.h"
#include "firmware_io/device/report_source.h"
#include "firmware_io/device/source/wake_up.h"

namespace penpose::device {

/// Reads a tablet in a thread of its own, from construction until it is stopped: wakes it, also after every sleep of
/// the system, and puts its reports with their times of receipt into a ring, whether or not they are taken out.
class ReportPump {
 public:
  struct Options {
    WakeUp wake_up;
    bool exclusive = false;                         ///< as `set_exclusive`
    std::size_t ring_bytes = std::size_t{1} << 20;  ///< half a minute of a pen of 1000 reports a second
    std::function<std::int64_t()> slept_us = {};    ///< replaced in tests; the system's by default
    WaitMs wait = {};                               ///< replaced in tests
  };

  ReportPump(std::unique_ptr<ReportSource> source, Options options);
  /// As `stop`.
  ~ReportPump();
  ReportPump(const ReportPump&) = delete;
  ReportPump& operator=(const ReportPump&) = delete;

  /// Reads no more and closes the source; takes at most one waking step or 50 ms. What came can still be taken.
  void stop();
  /// Takes the oldest record; false if there is none. Only one thread may take.
  bool take(Record& into) { return ring_.pop(into); }
  /// Waits until there is a record, the tablet is gone or the time is over. False if the time is over.
  bool wait(int timeout_ms);
  /// Sends a feature report from the thread within 50 ms; of several pending ones, only the last. With `only`, the
  /// report is read from the tablet first, and only that byte is changed.
  void send_feature(std::vector<std::uint8_t> report, std::optional<std::size_t> only = {});
  /// Whether nobody else is to get what the tablet sends, where it can be kept from them (ReportSource::set_exclusive);
  /// takes effect within 50 ms once nothing is near or held.
  void set_exclusive(bool wanted) { exclusive_.store(wanted, std::memory_order_relaxed); }
  /// Becomes readable when a record comes; `wait(0)` makes it unreadable again.
  [[nodiscard]] int wake_fd() const { return event_; }

  [[nodiscard]] std::uint64_t received() const { return received_.load(std::memory_order_relaxed); }
  /// Reports that were received and did not fit into the ring.
  [[nodiscard]] std::uint64_t overruns() const { return ring_.overruns(); }
  /// How often the system's own queue was full because this program did not run for long; the number of dropped reports
  /// is unknown.
  [[nodiscard]] std::uint64_t full_queues() const { return full_queues_.load(std::memory_order_relaxed); }
  /// The tablet is gone; earlier reports may still be in the ring.
  [[nodiscard]] bool gone() const { return gone_.load(std::memory_order_acquire); }
  /// Another program has the tablet for itself, so that nothing comes until it lets go; a note says so, too.
  [[nodiscard]] bool is_taken() const { return taken_.load(std::memory_order_relaxed); }
  /// Number of reports for waking and lights that the tablet refused.
  [[nodiscard]] int refused() const { return refused_.load(std::memory_order_relaxed); }

 private:
  void run();
  void wake_tablet();
  void note(std::string_view text);
  void signal();
  void send_waiting();
  void look_who_has_it();

  std::unique_ptr<ReportSource> source_;
  Options options_;
  ReportRing ring_;
  int event_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> gone_{false};
  std::atomic<bool> exclusive_;
  std::atomic<bool> taken_{false};
  std::atomic<std::uint64_t> received_{0};
  std::atomic<std::uint64_t> full_queues_{0};
  std::atomic<int> refused_{0};
  std::mutex to_send_mutex_;
  std::vector<std::uint8_t> to_send_;
  std::optional<std::size_t> only_byte_;
  std::atomic<bool> has_to_send_{false};
  std::thread thread_;
};

}  // namespace penpose::device
