#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "replay/trace/trace_reader.h"

namespace penpose::replay {

/// An input report as it came from a device.
struct TraceReport {
  std::uint64_t index = 0;  ///< of the report line over the whole file, from 0
  int device = 0;
  std::int64_t time_us = 0;  ///< since the recording's own start; of several in one file, the first's
  base::Bytes bytes;         ///< valid until the next report is read
  std::uint64_t line = 0;    ///< of the file, from 1
};

enum class Pace : std::uint8_t {
  full_speed,
  real_time,  ///< each report comes when it came in the recording, counted from the first
};

/// A trace in the place of hardware: its devices and their reports in order.
class TraceSource {
 public:
  /// Waits until a number of microseconds after the first report; replaced in tests.
  using Wait = std::function<void(std::int64_t)>;

  explicit TraceSource(ReadBytes read, Pace pace = Pace::full_speed, Wait wait = {});

  /// The next report, nothing at the end. Errors: those of reading the file.
  base::Result<std::optional<TraceReport>> next();

  /// Called in the order of the file with every line that is neither of a device nor a report.
  using OnLine = std::function<void(const TraceLine&)>;
  /// Called when reports of a device begin, and again when it has been declared anew since.
  using OnDevice = std::function<void(int device, const decode::DeviceIdentity&)>;
  /// What to call while reading; set them before the first report is read.
  void listen(OnLine on_line, OnDevice on_device);

  /// Reads on to the first report without giving it out, so that `devices` holds all that is declared before it.
  base::Status read_header();

  /// The devices declared so far, by their number in the trace: a descriptor behind reports begins a device anew, as it
  /// does where recordings were put into one file. Length of reports and descriptor are filled in.
  [[nodiscard]] const std::map<int, decode::DeviceIdentity>& devices() const { return devices_; }

  /// Lines that could not be read and were left out, and a cut at the end: a line each, at most a few.
  [[nodiscard]] const std::vector<base::Error>& problems() const { return problems_; }

 private:
  base::Result<std::optional<TraceReport>> read_on();
  void note_problem(const TraceLine& line);
  std::int64_t run_on(std::int64_t time_us);

  TraceReader reader_;
  Pace pace_;
  Wait wait_;
  std::map<int, decode::DeviceIdentity> devices_;
  std::vector<base::Error> problems_;
  std::uint64_t unread_lines_ = 0;
  std::uint64_t next_index_ = 0;
  int device_ = 0;
  OnLine on_line_;
  OnDevice on_device_;
  std::set<int> announced_;  ///< devices whose reports came since they were declared
  bool begun_anew_ = false;  ///< such a device has been declared again since the last report
  bool is_session_ = false;
  std::int64_t shift_us_ = 0;  ///< of the times in the file
  std::int64_t last_us_ = 0;
  std::optional<TraceReport> held_;  ///< read by `read_header`
  std::optional<std::int64_t> first_time_us_;
  bool finished_ = false;
};

}  // namespace penpose::replay
