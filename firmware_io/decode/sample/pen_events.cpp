#include "firmware_io/decode/sample/pen_events.h"

namespace penpose::decode {

bool PenEvents::touches(const PenSample& sample) const {
  if (sample.tool == Tool::mouse) return false;
  if (!rule_.by_pressure) return sample.tip;
  return sample.pressure >= (in_stroke_ ? rule_.release_below : rule_.press_at);
}

void PenEvents::set_buttons(const PenSample& sample, std::uint32_t buttons, std::int64_t time_us,
                            std::vector<PenEvent>& out) {
  const std::uint32_t changed = buttons ^ buttons_;
  for (std::uint8_t i = 0; i < 32; ++i) {
    const std::uint32_t mask = 1u << i;
    if ((changed & mask) == 0) continue;
    const auto kind = (buttons & mask) != 0 ? PenEventKind::button_down : PenEventKind::button_up;
    out.push_back({kind, tool_, i, time_us, sample});
  }
  buttons_ = buttons;
}

void PenEvents::leave(const PenSample& sample, std::int64_t time_us, std::vector<PenEvent>& out) {
  if (tool_ == Tool::none) return;
  if (in_stroke_) out.push_back({PenEventKind::stroke_end, tool_, 0, time_us, sample});
  in_stroke_ = false;
  set_buttons(sample, 0, time_us, out);
  out.push_back({PenEventKind::away, tool_, 0, time_us, sample});
  tool_ = Tool::none;
}

void PenEvents::add(const PenSample& sample, std::int64_t time_us, std::vector<PenEvent>& out) {
  const Tool tool = sample.tool == Tool::none ? Tool::pen : sample.tool;
  // Some pens say who they are only after a while, which makes them no other pen.
  const bool another = tool != tool_ || (sample.serial != serial_ && sample.serial != 0 && serial_ != 0);
  // The last sample in range is what an ending event shows: after leaving, devices send zeros.
  if (!sample.in_range || another) leave(last_, time_us, out);
  if (!sample.in_range) return;
  if (tool_ == Tool::none) {
    tool_ = tool;
    serial_ = sample.serial;
    out.push_back({PenEventKind::near, tool_, 0, time_us, sample});
  }
  if (sample.serial != 0) serial_ = sample.serial;
  const bool contact = touches(sample);
  if (in_stroke_ && !contact) {
    out.push_back({PenEventKind::stroke_end, tool_, 0, time_us, last_});
  }
  set_buttons(sample, sample.buttons, time_us, out);
  PenEventKind kind = PenEventKind::hover;
  if (contact) kind = in_stroke_ ? PenEventKind::stroke_point : PenEventKind::stroke_begin;
  out.push_back({kind, tool_, 0, time_us, sample});
  in_stroke_ = contact;
  last_ = sample;
}

void PenEvents::finish(std::int64_t time_us, std::vector<PenEvent>& out) { leave(last_, time_us, out); }

}  // namespace penpose::decode
