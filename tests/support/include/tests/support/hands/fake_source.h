#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "firmware_io/device/clock.h"
#include "firmware_io/device/report_source.h"

namespace penpose::tests {

/// What a test and its fake tablet share: the test puts reports in and looks at what was asked of the tablet.
struct FakeTablet {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::vector<std::uint8_t>> reports;
  bool unplugged = false;
  std::vector<std::string> asked;  ///< "string 200", "feature 0202", "output 02b004"
  std::atomic<bool> closed{false};
  bool refuses = false;
  bool queue_was_full = false;  ///< what it says with every report
  std::atomic<bool> exclusive{false};
  std::atomic<bool> taken{false};     ///< whether it says that another program has it
  std::vector<std::uint8_t> feature;  ///< what it says when it is asked for a feature report; empty: nothing

  void send(std::vector<std::uint8_t> report) {
    const std::lock_guard lock(mutex);
    reports.push_back(std::move(report));
    changed.notify_all();
  }
  void unplug() {
    const std::lock_guard lock(mutex);
    unplugged = true;
    changed.notify_all();
  }
  [[nodiscard]] std::vector<std::string> all_asked() {
    const std::lock_guard lock(mutex);
    return asked;
  }
};

/// A tablet in memory, in the place of hardware.
class FakeSource final : public device::ReportSource {
 public:
  explicit FakeSource(std::shared_ptr<FakeTablet> tablet) : tablet_(std::move(tablet)) {}
  ~FakeSource() override { tablet_->closed = true; }

  device::ReadOutcome read(std::span<std::uint8_t> into, int timeout_ms) override {
    std::unique_lock lock(tablet_->mutex);
    tablet_->changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                              [&] { return !tablet_->reports.empty() || tablet_->unplugged; });
    if (!tablet_->reports.empty()) {
      const auto report = std::move(tablet_->reports.front());
      tablet_->reports.pop_front();
      const std::size_t length = std::min(report.size(), into.size());
      std::copy_n(report.begin(), length, into.begin());
      return {device::ReadState::report, length, device::monotonic_us(), tablet_->queue_was_full};
    }
    return {tablet_->unplugged ? device::ReadState::gone : device::ReadState::nothing, 0, 0};
  }
  base::Status send_feature(base::Bytes report) override { return ask("feature " + hex(report)); }
  base::Status send_output(base::Bytes report) override { return ask("output " + hex(report)); }
  base::Result<std::vector<std::uint8_t>> get_feature(std::uint8_t id, std::size_t) override {
    if (const auto asked = ask("get feature " + std::to_string(id)); !asked) return asked.error();
    if (tablet_->feature.empty()) return base::Error{"stalled", "", ""};
    return tablet_->feature;
  }
  base::Result<std::string> read_string(std::uint8_t index) override {
    if (const auto asked = ask("string " + std::to_string(index)); !asked) return asked.error();
    return std::string("answer");
  }
  void set_exclusive(bool wanted) override { tablet_->exclusive = wanted; }
  [[nodiscard]] bool is_taken() const override { return tablet_->taken; }

 private:
  base::Status ask(std::string what) {
    const std::lock_guard lock(tablet_->mutex);
    tablet_->asked.push_back(std::move(what));
    if (tablet_->refuses) return base::Error{"stalled", "", ""};
    return base::Done{};
  }
  static std::string hex(base::Bytes bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
      text += "0123456789abcdef"[byte >> 4];
      text += "0123456789abcdef"[byte & 0xf];
    }
    return text;
  }

  std::shared_ptr<FakeTablet> tablet_;
};

}  // namespace penpose::tests
