#pragma once

#include <cstdint>
#include <vector>

#include "firmware_io/decode/sample/pen_events.h"

namespace penpose::tests {

struct StrokePoint {
  std::int64_t time_us = 0;
  decode::PenSample sample;  ///< raw
};

/// What a tip drew between touching and lifting.
struct PenStroke {
  decode::Tool tool = decode::Tool::none;
  std::uint64_t serial = 0;
  std::vector<StrokePoint> points;
};

/// Records samples as strokes and as events. Nothing is smoothed, thinned out or repeated: the points of all strokes
/// and the hover events together are the samples in range, each once.
class StrokeRecorder {
 public:
  explicit StrokeRecorder(decode::ContactRule rule = {}) : events_of_(rule) {}

  void add(const decode::PenSample& sample, std::int64_t time_us) {
    events_of_.add(sample, time_us, new_events_);
    take_new();
  }
  /// Ends an open stroke when the device goes away or the recording ends.
  void finish(std::int64_t time_us) {
    events_of_.finish(time_us, new_events_);
    take_new();
  }

  /// Completed strokes and, last, the one that is being drawn.
  [[nodiscard]] const std::vector<PenStroke>& strokes() const { return strokes_; }
  [[nodiscard]] bool is_drawing() const { return drawing_; }
  /// Everything but the points within strokes, in order.
  [[nodiscard]] const std::vector<decode::PenEvent>& events() const { return events_; }

 private:
  void take_new() {
    for (const decode::PenEvent& event : new_events_) {
      switch (event.kind) {
        case decode::PenEventKind::stroke_begin:
          strokes_.push_back({event.tool, event.sample.serial, {{event.time_us, event.sample}}});
          drawing_ = true;
          events_.push_back(event);
          break;
        case decode::PenEventKind::stroke_point:
          strokes_.back().points.push_back({event.time_us, event.sample});
          break;
        case decode::PenEventKind::stroke_end:
          drawing_ = false;
          events_.push_back(event);
          break;
        default:
          events_.push_back(event);
          break;
      }
    }
    new_events_.clear();
  }

  decode::PenEvents events_of_;
  std::vector<decode::PenEvent> new_events_;
  std::vector<decode::PenEvent> events_;
  std::vector<PenStroke> strokes_;
  bool drawing_ = false;
};

}  // namespace penpose::tests
