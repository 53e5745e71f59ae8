#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/app.h"
#include "ui/app/input/navigation.h"

// What rings, strips and wheels of tablets do, and what turns on a pen.

namespace penpose::app {
namespace {

using Kind = Binding::Kind;

constexpr double k_zoom_per_notch = 0.95;
constexpr double k_degrees_per_notch = 5;
/// A control goes from end to end with one and a half turns of a ring.
constexpr double k_control_notches = 54;
/// Steps back and forth shall not come by accident, and a ring's notches are close together.
constexpr std::int32_t k_ring_notches_per_undo = 3;

}  // namespace

void App::turn_pen_dials(int device, const replay::PenMoment& moment) {
  DeskTablet* tablet = desk_.find(device);
  const decode::PenAxes* axes = editing_.session().pens().axes_of(device);
  if (tablet == nullptr || axes == nullptr || moment.kind == decode::PenEventKind::away) return;
  for (const bool rotation : {false, true}) {
    const PadControl control{rotation ? PadControl::Kind::pen_rotation : PadControl::Kind::pen_wheel, 0, 0};
    const decode::Axis& axis = rotation ? axes->rotation : axes->wheel;
    const auto steps = desk_.pen_turned(device, rotation, rotation ? moment.rotation : moment.wheel, axis);
    if (steps == 0) continue;
    if (const Binding binding = bound(*tablet, control); binding.kind == Kind::dial) {
      turn_dial(binding.dial, device, control, steps);
    }
  }
}

void App::turn_dial(DialUse use, int device, const PadControl& control, std::int32_t steps) {
  if (canvas_.hits().all || dialogs_.open() != Dialog::none) return;
  const replay::DrawnStroke* stroke = editing_.session().pens().current();
  if (stroke != nullptr && stroke->on_canvas) return;
  if (dial_ && *dial_ != use) end_dial();
  dial_ = use;
  dial_us_ = options_.clock();
  dial_touched_ = control.kind == PadControl::Kind::ring || control.kind == PadControl::Kind::strip;
  const double notches = static_cast<double>(steps) / decode::k_notch;
  const auto whole = [&](std::int32_t notches_each) {
    return desk_.whole_steps(device, control, steps, notches_each * decode::k_notch);
  };
  const std::int32_t each = control.kind == PadControl::Kind::ring ? k_ring_notches_per_undo : 1;
  switch (use) {
    case DialUse::time:
      if (const int frames = whole(1); frames != 0) {
        playback_.stop();
        playback_.scrub(on_frame(playback_.time_s(), playback_.rate()) + time_of_frame(frames, playback_.rate()));
      }
      break;
    case DialUse::zoom:
      canvas_.zoom(std::pow(k_zoom_per_notch, std::clamp(notches, -20.0, 20.0)),
                   tablet_is_near() ? at_ : canvas_.free_area().middle());
      break;
    case DialUse::turn:
      canvas_.turn(k_degrees_per_notch * notches, 0);
      break;
    case DialUse::control:
      turn_control(notches);
      break;
    case DialUse::undo:
      for (int n = whole(each); n != 0; n -= n > 0 ? 1 : -1) do_action(n > 0 ? Action::redo : Action::undo);
      break;
    case DialUse::keys:
      for (int n = whole(each); n != 0; n -= n > 0 ? 1 : -1) playback_.step_key(n > 0 ? 1 : -1);
      break;
  }
}

void App::turn_control(double notches) {
  const auto parameters = editing_.document().model->rig->parameters();
  if (dial_control_.empty()) {
    // The control that is selected, else the one that the last stroke moved most.
    std::string name = panels_.controls_tab ? controls_.selected() : std::string();
    if (!rig::find_parameter(parameters, name)) {
      name = editing_.movements().empty() ? std::string() : editing_.movements().front().name;
    }
    const auto index = rig::find_parameter(parameters, name);
    if (!index) {
      notices_.tell("no control is in hand: draw a pose, or select a control in the panel");
      return;
    }
    dial_control_ = name;
    dial_value_ = editing_.document().pose[*index];
  }
  const auto index = rig::find_parameter(parameters, dial_control_);
  if (!index) return;
  const rig::Parameter& one = parameters[*index];
  dial_value_ =
      std::clamp(dial_value_ + notches * (one.maximum - one.minimum) / k_control_notches, one.minimum, one.maximum);
  controls_.preview_parameter(*index, dial_value_);
  char value[32];
  std::snprintf(value, sizeof value, "%.2f", dial_value_);
  notices_.take_away([&](const Notice& notice) { return notice.text.starts_with(dial_control_ + " at "); });
  notices_.tell(dial_control_ + " at " + value);
}

void App::end_dial() {
  const auto use = std::exchange(dial_, std::nullopt);
  if (use == DialUse::time) playback_.end_scrub();
  const std::string name = std::exchange(dial_control_, {});
  if (use != DialUse::control || name.empty()) return;
  const auto index = rig::find_parameter(editing_.document().model->rig->parameters(), name);
  if (!index) {
    editing_.preview(std::nullopt);
  } else if (editing_.document().pose[*index] != dial_value_) {
    controls_.set_parameter(*index, dial_value_);
  }
}

}  // namespace penpose::app
