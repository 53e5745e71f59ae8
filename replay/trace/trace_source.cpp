#include "replay/trace/trace_source.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <thread>

#include "firmware_io/decode/decoder_factory.h"

namespace penpose::replay {
namespace {

constexpr std::size_t k_most_problems = 10;
/// More devices than that are not in any recording; a hostile one must not fill the memory.
constexpr std::size_t k_most_devices = 4096;

TraceSource::Wait wait_on_steady_clock() {
  using Clock = std::chrono::steady_clock;
  return [start = std::optional<Clock::time_point>()](std::int64_t after_us) mutable {
    if (!start) start = Clock::now();
    std::this_thread::sleep_until(*start + std::chrono::microseconds(after_us));
  };
}

/// The interface number that the last part of a physical path names: "usb-.../input1".
std::optional<int> interface_of(std::string_view path) {
  constexpr std::string_view k_mark = "/input";
  const std::size_t at = path.rfind(k_mark);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view digits = path.substr(at + k_mark.size());
  if (digits.size() != 1 || digits[0] < '0' || digits[0] > '9') return std::nullopt;
  return digits[0] - '0';
}

}  // namespace

TraceSource::TraceSource(ReadBytes read, Pace pace, Wait wait)
    : reader_(std::move(read)), pace_(pace), wait_(wait ? std::move(wait) : wait_on_steady_clock()) {}

void TraceSource::note_problem(const TraceLine& line) {
  ++unread_lines_;
  if (problems_.size() < k_most_problems) {
    problems_.push_back({"the line " + std::string(line.problem) + " and was left out",
                         "line " + std::to_string(line.number), "record it again or mend the line"});
  } else if (problems_.size() == k_most_problems) {
    problems_.push_back({"more lines could not be read", "line " + std::to_string(line.number), ""});
  }
}

base::Result<std::optional<TraceReport>> TraceSource::read_on() {
  if (finished_) return std::optional<TraceReport>();
  for (;;) {
    const auto read = reader_.next();
    if (!read) return read.error();
    if (!read->has_value()) {
      finished_ = true;
      if (reader_.cut()) problems_.push_back(*reader_.cut());
      return std::optional<TraceReport>();
    }
    const TraceLine& line = **read;
    if (!line.problem.empty()) {
      // A cut at the end of the file is told by the reader, with better words.
      if (!line.end.empty()) note_problem(line);
      if (line.text.starts_with("E:")) ++next_index_;
      continue;
    }
    switch (line.kind) {
      case TraceLineKind::other:
        is_session_ = is_session_ || line.text.starts_with("# penpose session ");
        if (on_line_) on_line_(line);
        break;
      case TraceLineKind::device:
        device_ = line.device;
        break;
      case TraceLineKind::report:
        if (announced_.size() < k_most_devices && announced_.insert(device_).second && on_device_) {
          on_device_(device_, devices_[device_]);
        }
        return std::optional(TraceReport{next_index_++, device_, run_on(line.time_us), line.bytes, line.number});
      default: {
        if (devices_.size() >= k_most_devices && !devices_.contains(device_)) break;
        decode::DeviceIdentity& device = devices_[device_];
        const bool anew = announced_.erase(device_) > 0 && line.kind == TraceLineKind::descriptor;
        if (anew) device = {};
        if (line.kind == TraceLineKind::descriptor) {
          begun_anew_ = begun_anew_ || anew;
          device.report_descriptor.assign(line.bytes.begin(), line.bytes.end());
          device.input_report_length.reset();
          device.output_report_length.reset();
          device.feature_report_length.reset();
          decode::complete_identity(device);
        } else if (line.kind == TraceLineKind::name) {
          device.name = line.value;
        } else if (line.kind == TraceLineKind::physical) {
          device.interface_number = interface_of(line.value);
          device.unit = decode::unit_of_path(line.value);
        } else {
          device.bus = line.bus;
          device.vendor = line.vendor;
          device.product = line.product;
        }
        break;
      }
    }
  }
}

/// A recording that was put behind another one counts from 0 again. Sessions are replayed with the times that they had.
std::int64_t TraceSource::run_on(std::int64_t time_us) {
  if (begun_anew_ && !is_session_) shift_us_ = std::max(shift_us_, last_us_ - time_us);
  begun_anew_ = false;
  last_us_ = time_us + std::min(shift_us_, std::numeric_limits<std::int64_t>::max() - time_us);
  return last_us_;
}

void TraceSource::listen(OnLine on_line, OnDevice on_device) {
  on_line_ = std::move(on_line);
  on_device_ = std::move(on_device);
}

base::Status TraceSource::read_header() {
  if (held_) return base::Done{};
  auto report = read_on();
  if (!report) return report.error();
  held_ = *report;
  return base::Done{};
}

base::Result<std::optional<TraceReport>> TraceSource::next() {
  auto report = held_ ? base::Result<std::optional<TraceReport>>(held_) : read_on();
  held_.reset();
  if (!report || !report->has_value()) return report;
  if (pace_ == Pace::real_time) {
    const std::int64_t time = (*report)->time_us;
    if (!first_time_us_) first_time_us_ = time;
    if (time > *first_time_us_) wait_(time - *first_time_us_);
  }
  return report;
}

}  // namespace penpose::replay
