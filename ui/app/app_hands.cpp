#include <algorithm>
#include <utility>

#include "ui/app/app.h"

// What the hand does that holds no pen: keys and fingers of tablets, and what is bound to them.

namespace penpose::app {
namespace {

using decode::PadEventKind;
using Kind = Binding::Kind;

/// So long the desktop's own idea of the same fingers is ignored.
constexpr std::int64_t k_gesture_quiet_us = 250'000;
constexpr std::int8_t k_low_battery = 15;
constexpr std::int8_t k_charged_again = 25;

}  // namespace

Binding App::bound(const DeskTablet& tablet, const PadControl& control) const {
  const auto chosen = preferences_.settings().pads.find(tablet.key);
  if (chosen != preferences_.settings().pads.end()) {
    const auto found = chosen->second.find(name_of(control));
    if (found != chosen->second.end()) return found->second;
  }
  return default_binding(control, tablet.features);
}

void App::bind(const DeskTablet& tablet, const PadControl& control, std::optional<Binding> binding) {
  if (binding) {
    preferences_.settings().pads[tablet.key][name_of(control)] = *binding;
  } else {
    preferences_.settings().pads[tablet.key].erase(name_of(control));
  }
  if (preferences_.settings().pads[tablet.key].empty()) preferences_.settings().pads.erase(tablet.key);
  if (control.kind == PadControl::Kind::pen_button) {
    tablet_setting_changed();
  } else {
    preferences_.changed();
  }
}

std::uint32_t App::drawing_buttons(int device) const {
  constexpr std::uint8_t k_buttons = 8;
  const DeskTablet* tablet = desk_.find(device);
  std::uint32_t buttons = 0;
  for (std::uint8_t i = 0; tablet != nullptr && i < k_buttons; ++i) {
    const Binding::Kind kind = bound(*tablet, pen_button_control(i)).kind;
    if (kind == Kind::tool || kind == Kind::action) buttons |= 1U << i;
  }
  return buttons;
}

replay::TabletSetting App::setting_of(int device) const {
  replay::TabletSetting setting = preferences_.settings().tablet;
  setting.drawing_buttons = drawing_buttons(device);
  return setting;
}

std::int8_t App::dial_mode(const DeskTablet& tablet, std::uint8_t side) const {
  const decode::PadDecoder* pad = editing_.session().hands().pad(tablet.pad);
  if (tablet.features.modes == 0 || pad == nullptr) return tablet.next_mode[side];
  // Where there is one light for two dials it is the light of both.
  return pad->sample().mode[std::min<std::size_t>(side, tablet.features.modes - 1)];
}

const ViewHold* App::held_view() const {
  const Binding* held = desk_.held(Kind::view);
  return held == nullptr ? nullptr : &held->view;
}

void App::place_pen() {
  if (!editing_.pen_is_drawing()) editing_.place_pen(canvas_.hits().on_canvas(at_) && held_view() == nullptr);
}

void App::hold_tools() {
  const Binding* held = desk_.held(Kind::tool);
  const auto wanted = held != nullptr ? std::optional(held->tool) : std::nullopt;
  // A stroke ends as what it began.
  if (wanted == tool_held_ || editing_.pen_is_drawing()) return;
  if (wanted) {
    if (!tool_before_) tool_before_ = editing_.editor().tool();
    drawing::Tool tool;
    tool.kind = *wanted;
    editing_.set_tool(tool);
  } else if (tool_before_) {
    // Somebody who chose another tool meanwhile keeps it.
    if (editing_.editor().tool().kind == *tool_held_) editing_.set_tool(*tool_before_);
    tool_before_.reset();
  }
  tool_held_ = wanted;
}

void App::press(DeskTablet& tablet, int device, const PadControl& control) {
  if (dialogs_.open() == Dialog::pad) {
    // Whoever presses a key there means to choose for it.
    dialogs_.state<PadChoice>().tablet = {tablet.key, tablet.unit};
    dialogs_.state<PadChoice>().control = control;
    return;
  }
  const Binding binding = bound(tablet, control);
  const bool open = !canvas_.hits().all && dialogs_.open() == Dialog::none;
  switch (binding.kind) {
    case Kind::none:
    case Kind::dial:
    case Kind::pen_menu:
      break;
    case Kind::action:
      if (open || binding.action == Action::cancel) do_action(binding.action);
      break;
    case Kind::view:
    case Kind::tool:
      desk_.press({device, control, binding});
      place_pen();
      hold_tools();
      break;
    case Kind::next_mode:
      for (std::int8_t& mode : tablet.next_mode)
        mode = static_cast<std::int8_t>((mode + 1) % modes_of(tablet.features));
      notices_.tell("Ring, strip and wheel: " +
                    label_of(bound(tablet, dial_control(decode::PadDial::ring, 0, tablet.next_mode[0]))));
      break;
  }
}

void App::let_go(int device, const PadControl& control) {
  if (!desk_.release(device, control)) return;
  place_pen();
  hold_tools();
}

void App::take_pen_button(int device, const replay::PenMoment& moment) {
  const PadControl control = pen_button_control(moment.button);
  DeskTablet* tablet = desk_.find(device);
  const Binding binding = tablet != nullptr ? bound(*tablet, control) : default_binding(control, {});
  const bool free = canvas_.hits().on_canvas(at_) && !editing_.pen_is_drawing() && !barrel_ && !pen_view_;
  if (moment.kind == decode::PenEventKind::button_down) {
    const bool chooses = dialogs_.open() == Dialog::pad;
    if (!chooses && binding.kind == Kind::pen_menu && free) {
      barrel_ = true;
      begin_drag(at_);
    } else if (!chooses && binding.kind == Kind::view && free) {
      pen_view_ = binding.view;
      begin_drag(at_);
    } else if (tablet != nullptr && (chooses || binding.kind != Kind::view)) {
      press(*tablet, device, control);
    }
    return;
  }
  if (binding.kind == Kind::pen_menu && barrel_) end_barrel(at_);
  if (binding.kind == Kind::view && std::exchange(pen_view_, std::nullopt)) drag_.reset();
  let_go(device, control);
}

void App::take_hand(std::span<const replay::HandMoment> moments) {
  bool changed = false;
  for (const replay::HandMoment& moment : moments) {
    DeskTablet* tablet = desk_.find(moment.device);
    if (tablet == nullptr) continue;
    switch (moment.kind) {
      case replay::HandMoment::Kind::pad:
        take_pad_event(*tablet, moment.device, moment.event);
        break;
      case replay::HandMoment::Kind::fingers:
        take_fingers(moment.device);
        break;
      case replay::HandMoment::Kind::battery:
        tell_battery(*tablet, moment.device);
        break;
      case replay::HandMoment::Kind::tablet:
        if (!std::exchange(changed, true)) change_tablets(moments);
        break;
    }
  }
}

void App::take_pad_event(DeskTablet& tablet, int device, const decode::PadEvent& event) {
  switch (event.kind) {
    case PadEventKind::key_down:
      press(tablet, device, key_control(event.key));
      if (const auto light = mode_key(event.key, tablet.features); light && dialogs_.open() != Dialog::pad) {
        // The light says which, and not what it means.
        const auto dial = tablet.features.rings > 0 ? decode::PadDial::ring : decode::PadDial::strip;
        const PadControl control = dial_control(dial, light->side, dial_mode(tablet, light->side));
        notices_.tell(title_of(control, tablet.features) + ": " + label_of(bound(tablet, control)));
      }
      break;
    case PadEventKind::key_up:
      let_go(device, key_control(event.key));
      break;
    case PadEventKind::touched:
      desk_.forget_rest(device);
      if (dialogs_.open() == Dialog::pad) {
        dialogs_.state<PadChoice>().tablet = {tablet.key, tablet.unit};
        dialogs_.state<PadChoice>().control = dial_control(event.dial, event.side, dial_mode(tablet, event.side));
      }
      break;
    case PadEventKind::turned: {
      const PadControl control = dial_control(event.dial, event.side, dial_mode(tablet, event.side));
      const Binding binding = bound(tablet, control);
      if (binding.kind == Kind::dial) turn_dial(binding.dial, device, control, event.steps);
      break;
    }
    case PadEventKind::let_go:
      if (dial_touched_) end_dial();
      break;
  }
}

bool App::fingers_move_view() const {
  return raw_gesture_us_ >= 0 && options_.clock() - raw_gesture_us_ < k_gesture_quiet_us;
}

PxPoint App::place_of_finger(int device, const decode::TouchContact& contact) const {
  const decode::TouchAxes& axes = editing_.session().hands().touch(device)->axes();
  const auto share = [](const decode::Axis& axis, std::int32_t at) {
    const double range = static_cast<double>(axis.maximum) - axis.minimum;
    return range > 0 ? (static_cast<double>(at) - axis.minimum) / range : 0.0;
  };
  double x = share(axes.x, contact.x);
  double y = share(axes.y, contact.y);
  if (preferences_.settings().tablet.left_handed) {
    x = 1 - x;
    y = 1 - y;
  }
  const double width = canvas_.window().width;
  // As far in both directions for the same way of the fingers, whatever shape the window has.
  const double across = (axes.x.maximum - axes.x.minimum) / std::max(axes.x.units_per_mm, 1e-9);
  const double down = (axes.y.maximum - axes.y.minimum) / std::max(axes.y.units_per_mm, 1e-9);
  const bool known = axes.x.units_per_mm > 0 && axes.y.units_per_mm > 0;
  return {x * width, y * (known ? width * down / across : static_cast<double>(canvas_.window().height))};
}

void App::take_fingers(int device) {
  if (editing_.session().hands().touch(device) == nullptr) return;
  TouchGestures& gestures = raw_touch_.try_emplace(device, TouchGestures(4 * canvas_.scale())).first->second;
  for (const auto& finger : desk_.fingers_changed(device, editing_.session().hands().fingers(device))) {
    for (const TouchAct& act : gestures.add(finger.kind, finger.id, place_of_finger(device, finger.contact))) {
      using ActKind = TouchAct::Kind;
      // One finger is the desktop's: on a tablet it moves the pointer, on a display it draws.
      if (act.kind == ActKind::pen_down || act.kind == ActKind::pen_move || act.kind == ActKind::pen_up) continue;
      raw_gesture_us_ = options_.clock();
      do_gesture(act);
    }
  }
}

void App::tell_battery(DeskTablet& tablet, int device) {
  const auto* pad = editing_.session().hands().pad(device);
  if (pad == nullptr) return;
  tablet.battery = pad->battery();
  const std::int8_t percent = tablet.battery.percent;
  // 0 comes before it has been measured.
  const bool low = percent > 0 && percent <= k_low_battery && !tablet.battery.charging;
  if (low && !tablet.low_told)
    notices_.tell(tablet.name + ": its battery is at " + std::to_string(percent) + " %", true);
  if (low || percent > k_charged_again || tablet.battery.charging) tablet.low_told = low;
}

std::string App::held_until_now(int device, std::span<const replay::HandMoment> let_go) const {
  std::string text;
  const DeskTablet* tablet = desk_.find(device);
  for (const replay::HandMoment& moment : let_go) {
    if (tablet == nullptr || moment.device != device || moment.kind != replay::HandMoment::Kind::pad) continue;
    if (moment.event.kind != PadEventKind::key_up) continue;
    const PadControl control = key_control(moment.event.key);
    text += "; " + title_of(control, tablet->features) + " (" + label_of(bound(*tablet, control)) +
            ") was held and is let go";
  }
  return text;
}

void App::change_tablets(std::span<const replay::HandMoment> moments) {
  std::string gone;
  std::string held;
  std::string ready;
  const auto changed = [](const replay::HandMoment& one) { return one.kind == replay::HandMoment::Kind::tablet; };
  for (const replay::HandMoment& moment : moments) {
    const DeskTablet* before = changed(moment) ? desk_.find(moment.device) : nullptr;
    if (before == nullptr) continue;
    if (before->has_anything()) gone = before->name;
    held += held_until_now(moment.device, moments);
  }
  tablet_near_ = false;
  barrel_ = false;
  for (const replay::HandMoment& moment : moments) {
    if (!changed(moment) || desk_.find(moment.device) == nullptr) continue;
    const int device = moment.device;
    on_gone(device);
    on_device(device, *editing_.session().identity_of(device));
    if (!editing_.session().pens().decodes(device)) continue;
    ready = editing_.session().identity_of(device)->name;
    if (tablets_.contains(device)) editing_.set_tablet(device, setting_of(device));
  }
  if (!gone.empty()) notices_.tell(gone + " is out of reach" + held, true);
  if (!ready.empty()) notices_.tell(ready + " is ready");
}

void App::forget_tablet(int device, const std::string& name, std::span<const replay::HandMoment> let_go) {
  const std::string held = held_until_now(device, let_go);
  std::string text = name + " was unplugged" + held;
  on_gone(device);
  // A receiver's other interfaces come and go with the tablet that it hears.
  const auto identity = tablets_.find(device);
  if (held.empty() && identity != tablets_.end() && decode::is_wacom_receiver(identity->second) &&
      !decode::is_receiver_monitor(identity->second))
    return;
  // Its other interface may have told more.
  const bool told = std::any_of(notices_.all().begin(), notices_.all().end(),
                                [&](const Notice& one) { return one.text != text && one.text.starts_with(text); });
  if (!told) notices_.tell(std::move(text), true);
}

void App::on_device(int device, const decode::DeviceIdentity& identity) {
  const decode::DeviceIdentity* shown = editing_.session().identity_of(device);
  desk_.add(device, shown != nullptr ? *shown : identity, editing_.session().hands(),
            editing_.session().pens().axes_of(device), options_.own_tablets);
  // A trace is drawn as it is, but for what its pen's buttons are bound to.
  if (tablets_.contains(device) || !player_.trace || player_.trace->is_session() || drawing_buttons(device) == 0)
    return;
  replay::TabletSetting setting;
  setting.drawing_buttons = drawing_buttons(device);
  editing_.set_tablet(device, setting);
}

void App::on_moments(int device, std::span<const replay::PenMoment> pen, std::span<const replay::HandMoment> hand) {
  // What a session's keys did is in its lines, in px of the window that it was drawn in.
  if (player_.trace->is_session()) return;
  canvas_.commit();
  take_hand(hand);
  take_moments(device, pen);
}

void App::on_gone(int device) {
  desk_.remove(device);
  raw_touch_.erase(device);
  pen_view_.reset();
  if (dial_) end_dial();
  place_pen();
  hold_tools();
}

}  // namespace penpose::app
