#include "firmware_io/decode/hand/stroke_recorder.h"

namespace penpose::decode {

void StrokeRecorder::add(const PenSample& sample, std::int64_t time_us) {
  events_of_.add(sample, time_us, new_events_);
  take_new();
}

void StrokeRecorder::finish(std::int64_t time_us) {
  events_of_.finish(time_us, new_events_);
  take_new();
}

void StrokeRecorder::take_new() {
  for (const PenEvent& event : new_events_) {
    switch (event.kind) {
      case PenEventKind::stroke_begin:
        strokes_.push_back({event.tool, event.sample.serial, {{event.time_us, event.sample}}});
        drawing_ = true;
        events_.push_back(event);
        break;
      case PenEventKind::stroke_point:
        strokes_.back().points.push_back({event.time_us, event.sample});
        break;
      case PenEventKind::stroke_end:
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

}  // namespace penpose::decode
