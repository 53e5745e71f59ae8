#pragma once

#include <cstdint>
#include <vector>

#include "firmware_io/decode/sample/pen_events.h"

namespace penpose::decode {

struct StrokePoint {
  std::int64_t time_us = 0;
  PenSample sample;  ///< raw
};

/// What a tip drew between touching and lifting.
struct PenStroke {
  Tool tool = Tool::none;
  std::uint64_t serial = 0;
  std::vector<StrokePoint> points;
};

/// Records samples as strokes and as events. Nothing is smoothed, thinned out or repeated: the points of all strokes
/// and the hover events together are the samples in range, each once.
class StrokeRecorder {
 public:
  explicit StrokeRecorder(ContactRule rule = {}) : events_of_(rule) {}

  void add(const PenSample& sample, std::int64_t time_us);
  /// Ends an open stroke when the device goes away or the recording ends.
  void finish(std::int64_t time_us);

  /// Completed strokes and, last, the one that is being drawn.
  [[nodiscard]] const std::vector<PenStroke>& strokes() const { return strokes_; }
  [[nodiscard]] bool is_drawing() const { return drawing_; }
  /// Everything but the points within strokes, in order.
  [[nodiscard]] const std::vector<PenEvent>& events() const { return events_; }

 private:
  void take_new();

  PenEvents events_of_;
  std::vector<PenEvent> new_events_;
  std::vector<PenEvent> events_;
  std::vector<PenStroke> strokes_;
  bool drawing_ = false;
};

}  // namespace penpose::decode
