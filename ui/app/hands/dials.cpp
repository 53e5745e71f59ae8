#include "ui/app/hands/dials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

constexpr double k_zoom_per_dial_notch = 0.95, k_degrees_per_notch = 5;
/// A control goes from end to end with one and a half turns of a ring.
constexpr double k_control_notches = 54;
/// Steps back and forth shall not come by accident, and a ring's notches are close together.
constexpr std::int32_t k_ring_notches_per_undo = 3;
/// A wheel that rested for so long was meant to be where it is.
constexpr std::int64_t k_dial_rest_us = 400'000;

}  // namespace

void Dials::turn(DialUse use, int device, const PadControl& control, std::int32_t steps) {
  if (parts_.hits.all || parts_.dialogs.open() != Dialog::none) return;
  const replay::DrawnStroke* stroke = parts_.editing.session().pens().current();
  if (stroke != nullptr && stroke->on_canvas) return;
  if (use_ && *use_ != use) end();
  use_ = use;
  turned_us_ = parts_.clock();
  touched_ = control.kind == PadControl::Kind::ring || control.kind == PadControl::Kind::strip;
  const double notches = static_cast<double>(steps) / decode::k_notch;
  const auto whole = [&](std::int32_t notches_each) {
    return parts_.desk.whole_steps(device, control, steps, notches_each * decode::k_notch);
  };
  const std::int32_t each = control.kind == PadControl::Kind::ring ? k_ring_notches_per_undo : 1;
  switch (use) {
    case DialUse::time:
      if (const int frames = whole(1); frames != 0) {
        parts_.playback.stop();
        parts_.playback.scrub(on_frame(parts_.playback.time_s(), parts_.playback.rate()) +
                              time_of_frame(frames, parts_.playback.rate()));
      }
      break;
    case DialUse::zoom:
      parts_.canvas.zoom(std::pow(k_zoom_per_dial_notch, std::clamp(notches, -20.0, 20.0)),
                         parts_.place.tablet_is_near() ? parts_.place.at() : parts_.canvas.free_area().middle());
      break;
    case DialUse::turn:
      parts_.canvas.turn(k_degrees_per_notch * notches, 0);
      break;
    case DialUse::control:
      turn_control(notches);
      break;
    case DialUse::undo:
      for (int n = whole(each); n != 0; n -= n > 0 ? 1 : -1) parts_.actions.run(n > 0 ? Action::redo : Action::undo);
      break;
    case DialUse::keys:
      for (int n = whole(each); n != 0; n -= n > 0 ? 1 : -1) parts_.playback.step_key(n > 0 ? 1 : -1);
      break;
  }
}

void Dials::turn_control(double notches) {
  const auto parameters = parts_.editing.document().model->rig->parameters();
  if (control_.empty()) {
    // The control that is selected, else the one that the last stroke moved most.
    std::string name = parts_.controls.shown();
    if (!rig::find_parameter(parameters, name)) {
      name = parts_.editing.last_stroke().movements().empty() ? std::string()
                                                              : parts_.editing.last_stroke().movements().front().name;
    }
    const auto index = rig::find_parameter(parameters, name);
    if (!index) {
      parts_.notices.tell("no control is selected: draw a pose, or select a control in the panel");
      return;
    }
    control_ = name;
    value_ = parts_.editing.document().pose[*index];
  }
  const auto index = rig::find_parameter(parameters, control_);
  if (!index) return;
  const rig::Parameter& one = parameters[*index];
  value_ = std::clamp(value_ + notches * (one.maximum - one.minimum) / k_control_notches, one.minimum, one.maximum);
  parts_.controls.preview_parameter(*index, value_);
  char value[32];
  std::snprintf(value, sizeof value, "%.2f", value_);
  const std::string words = parts_.editing.words_of(control_);
  parts_.notices.take_away([&](const Notice& notice) { return notice.text.starts_with(words + " at "); });
  parts_.notices.tell(words + " at " + value);
}

void Dials::end() {
  const auto use = std::exchange(use_, std::nullopt);
  if (use == DialUse::time) parts_.playback.end_scrub();
  const std::string name = std::exchange(control_, {});
  if (use != DialUse::control || name.empty()) return;
  const auto index = rig::find_parameter(parts_.editing.document().model->rig->parameters(), name);
  if (!index) {
    parts_.editing.shown().preview(std::nullopt);
  } else if (parts_.editing.document().pose[*index] != value_) {
    parts_.controls.set_parameter(*index, value_);
  }
}

void Dials::let_go() {
  if (touched_) end();
}

void Dials::follow() {
  if (waits() && parts_.clock() - turned_us_ > k_dial_rest_us) end();
}

void Dials::forget() {
  use_.reset();
  control_.clear();
}

}  // namespace penpose::app
