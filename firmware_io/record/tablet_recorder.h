#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/sample/pad_events.h"
#include "firmware_io/decode/sample/pen_events.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "firmware_io/device/report_ring.h"
#include "replay/trace/trace_writer.h"

namespace penpose::record {

struct RecordingCounts {
  std::uint64_t reports = 0;
  std::uint64_t lost = 0;  ///< reports lost before they were recorded; comments mark where they are missing
  std::uint64_t strokes = 0;
  std::uint64_t keys = 0;    ///< presses of keys on tablets
  std::int64_t span_us = 0;  ///< from the first report to the last
};

/// Writes a trace of tablets' reports and counts the strokes in it. Opens no file: `take` gives the text.
class TabletRecorder {
 public:
  /// Declares a tablet and returns its number in the trace. Reports of interfaces without a known decoder are also
  /// recorded.
  int add_tablet(const decode::DeviceIdentity& identity, const std::string& physical,
                 const decode::TabletTable* own = nullptr);

  /// Adds records of that tablet, in order. Times count from the first report of all; one before the last report of
  /// another tablet counts as simultaneous with it, so that times in a trace never decrease.
  void add(int tablet, const device::Record& record);

  /// The tablet is gone: its open stroke ends, and its held keys are released. Returns the Linux names of those keys,
  /// or nothing.
  std::string end(int tablet);

  /// The text since the last call, in whole lines.
  [[nodiscard]] std::string take() { return writer_.take(); }
  /// Whether a stroke has ended since the last call, so that the file should be synced to disk.
  [[nodiscard]] bool take_pen_up();
  [[nodiscard]] const RecordingCounts& counts() const { return counts_; }

 private:
  struct Tablet {
    std::unique_ptr<decode::PenDecoder> decoder;  ///< null: no known decoder
    decode::PenEvents events;
    decode::HandDecoders hand;
    decode::PadEvents pad_events;
  };

  void read_as(Tablet& tablet, const decode::DeviceIdentity& identity);
  void count_strokes();
  void count_keys(Tablet& tablet, base::Bytes report);

  replay::TraceWriter writer_;
  const decode::TabletTable* own_ = nullptr;
  decode::WacomReceivers receivers_;
  std::map<int, Tablet> tablets_;
  std::vector<decode::PenEvent> new_events_;
  std::vector<decode::PadEvent> new_pad_events_;
  RecordingCounts counts_;
  std::int64_t first_us_ = 0;
  bool begun_ = false;
  bool pen_up_ = false;
};

}  // namespace penpose::record
