#include "ui/app/hands/tablet_events.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/app/dialogs/entries.h"
#include "ui/files/own_tablets.h"

namespace penpose::app {
namespace {

using decode::PadEventKind;
using decode::PenEventKind;

constexpr std::int8_t k_low_battery = 15, k_charged_again = 25;

/// Kept, because what they do may make others.
std::vector<replay::HandMoment> hand_moments(const EditingSession& editing) {
  const auto hand = editing.session().hand_moments();
  return {hand.begin(), hand.end()};
}

}  // namespace

void TabletEvents::arrived(int device, const decode::DeviceIdentity& identity) {
  EditingSession& editing = parts_.editing;
  editing.input().connect(device, identity);
  on_device(device, identity);
  if (editing.session().pens().decodes(device)) editing.input().set_tablet(device, parts_.bindings.setting_of(device));
  const bool again = parts_.tablets.seen.contains(device);
  parts_.tablets.seen[device] = identity;
  parts_.tablets.plugged.insert(device);
  // Fingers alone are a part of a tablet that says so itself.
  const DeskTablet* tablet = parts_.desk.find(device);
  // Nor does a receiver say so: its tablet does once it is heard.
  const bool says = decode::is_wacom_receiver(identity) ? decode::is_receiver_monitor(identity)
                                                        : tablet == nullptr || tablet->has_anything();
  if (says) parts_.notices.tell(identity.name + (again ? " is back" : " is ready"));
}

void TabletEvents::lights_seen(int device, const decode::Lights& lights) {
  if (lights_of(device).value_or(lights) != lights) parts_.editing.input().see_lights(device, lights);
  parts_.tablets.lights[device] = lights;
}

std::optional<decode::Lights> TabletEvents::lights_of(int device) const {
  const decode::PadDecoder* pad = parts_.editing.session().hands().pad(device);
  if (pad == nullptr || pad->features().modes == 0) return std::nullopt;
  return pad->sample().mode;
}

void TabletEvents::left(int device, const std::string& name) {
  parts_.editing.input().disconnect(device);
  parts_.tablets.plugged.erase(device);
  parts_.tablets.receiver_status.erase(device);
  parts_.tablets.lights.erase(device);
  const auto let_go = hand_moments(parts_.editing);
  parts_.editing.shown().follow_pen();
  parts_.place.tablet_gone();
  parts_.pens.tablet_left();
  const std::string held = held_until_now(device, let_go);
  on_gone(device);
  tell_of_leaving(device, name, held);
}

void TabletEvents::report(int device, std::int64_t received_us, base::Bytes bytes) {
  const replay::Session& session = parts_.editing.session();
  parts_.canvas.commit();
  const auto moments = parts_.editing.input().report_at(device, received_us, bytes);
  take_hand(hand_moments(parts_.editing));
  if (const base::Bytes status = session.receiver_status(device); !status.empty())
    parts_.tablets.receiver_status[device].assign(status.begin(), status.end());
  if (const auto lights = lights_of(device)) parts_.tablets.lights[device] = *lights;
  if (moments.empty()) return;
  tell_guess(device);
  parts_.place.tablet_reported(moments.back().kind != PenEventKind::away);
  for (const auto& moment : moments) {
    const bool begins = moment.kind == PenEventKind::stroke_begin;
    if (begins || moment.kind == PenEventKind::stroke_point)
      try_pen(parts_.dialogs, moment.position, moment.pressure, begins);
  }
  parts_.pens.take(device, moments);
}

void TabletEvents::plug_in_anew() {
  EditingSession& editing = parts_.editing;
  editing.input().set_tablet(0, {});
  parts_.dials.forget();
  parts_.keys.forget();
  parts_.pens.forget();
  for (const int device : parts_.tablets.plugged) {
    const decode::DeviceIdentity& tablet = parts_.tablets.seen.at(device);
    parts_.desk.remove(device);
    parts_.fingers.forget(device);
    editing.input().connect(device, tablet);
    on_device(device, tablet);
    if (editing.session().pens().decodes(device))
      editing.input().set_tablet(device, parts_.bindings.setting_of(device));
    const auto on = parts_.tablets.lights.find(device);
    if (on != parts_.tablets.lights.end()) lights_seen(device, on->second);
  }
  // What a receiver hears is for this session to know from its reports, too.
  for (const auto& [device, status] : parts_.tablets.receiver_status) {
    editing.input().report(device, status);
    take_hand(hand_moments(editing));
  }
}

void TabletEvents::take_hand(std::span<const replay::HandMoment> moments) {
  bool changed = false;
  for (const replay::HandMoment& moment : moments) {
    DeskTablet* tablet = parts_.desk.find(moment.device);
    if (tablet == nullptr) continue;
    switch (moment.kind) {
      case replay::HandMoment::Kind::pad:
        take_pad_event(*tablet, moment.device, moment.event);
        break;
      case replay::HandMoment::Kind::fingers:
        parts_.fingers.take(moment.device);
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

void TabletEvents::take_pad_event(DeskTablet& tablet, int device, const decode::PadEvent& event) {
  const bool chooses = parts_.dialogs.open() == Dialog::pad;
  const auto dial = [&](decode::PadDial which, std::uint8_t side) {
    return dial_control(which, side, parts_.bindings.dial_mode(tablet, side));
  };
  switch (event.kind) {
    case PadEventKind::key_down:
      parts_.keys.press(tablet, device, key_control(event.key));
      if (const auto light = mode_key(event.key, tablet.features); light && parts_.dialogs.open() != Dialog::pad) {
        // The light says which, and not what it means.
        const auto which = tablet.features.rings > 0 ? decode::PadDial::ring : decode::PadDial::strip;
        const PadControl control = dial(which, light->side);
        parts_.notices.tell(title_of(control, tablet.features) + ": " +
                            label_of(parts_.bindings.bound(tablet, control)));
      }
      break;
    case PadEventKind::key_up:
      parts_.keys.let_go(device, key_control(event.key));
      break;
    case PadEventKind::touched:
      parts_.desk.forget_rest(device);
      if (chooses) {
        parts_.dialogs.state<PadChoice>().tablet = {tablet.key, tablet.unit};
        parts_.dialogs.state<PadChoice>().control = dial(event.dial, event.side);
      }
      break;
    case PadEventKind::turned: {
      const PadControl control = dial(event.dial, event.side);
      const Binding binding = parts_.bindings.bound(tablet, control);
      if (binding.kind == Binding::Kind::dial) parts_.dials.turn(binding.dial, device, control, event.steps);
      break;
    }
    case PadEventKind::let_go:
      parts_.dials.let_go();
      break;
  }
}

void TabletEvents::tell_battery(DeskTablet& tablet, int device) {
  const auto* pad = parts_.editing.session().hands().pad(device);
  if (pad == nullptr) return;
  tablet.battery = pad->battery();
  const std::int8_t percent = tablet.battery.percent;
  // 0 comes before it has been measured.
  const bool low = percent > 0 && percent <= k_low_battery && !tablet.battery.charging;
  if (low && !tablet.low_told)
    parts_.notices.tell(tablet.name + ": its battery is at " + std::to_string(percent) + " %", true);
  if (low || percent > k_charged_again || tablet.battery.charging) tablet.low_told = low;
}

void TabletEvents::tell_guess(int device) {
  DeskTablet* tablet = parts_.desk.find(device);
  if (tablet == nullptr || !tablet->guess.empty()) return;
  const std::string guess = parts_.editing.session().pens().guess_of(device);
  if (guess.empty()) return;
  tablet->guess = files::guess_note(guess);
  if (told_guesses_.insert(guess).second) parts_.notices.tell(tablet->name + ": " + tablet->guess, true);
}

std::string TabletEvents::held_until_now(int device, std::span<const replay::HandMoment> let_go) const {
  std::string text;
  const DeskTablet* tablet = parts_.desk.find(device);
  for (const replay::HandMoment& moment : let_go) {
    if (tablet == nullptr || moment.device != device || moment.kind != replay::HandMoment::Kind::pad) continue;
    if (moment.event.kind != PadEventKind::key_up) continue;
    const PadControl control = key_control(moment.event.key);
    text += "; " + title_of(control, tablet->features) + " (" + label_of(parts_.bindings.bound(*tablet, control)) +
            ") was held and is let go";
  }
  return text;
}

void TabletEvents::change_tablets(std::span<const replay::HandMoment> moments) {
  EditingSession& editing = parts_.editing;
  std::string gone;
  std::string held;
  std::string ready;
  const auto changed = [](const replay::HandMoment& one) { return one.kind == replay::HandMoment::Kind::tablet; };
  for (const replay::HandMoment& moment : moments) {
    const DeskTablet* before = changed(moment) ? parts_.desk.find(moment.device) : nullptr;
    if (before == nullptr) continue;
    if (before->has_anything()) gone = before->name;
    held += held_until_now(moment.device, moments);
  }
  parts_.place.tablet_gone();
  parts_.pens.end_menu();
  for (const replay::HandMoment& moment : moments) {
    if (!changed(moment) || parts_.desk.find(moment.device) == nullptr) continue;
    const int device = moment.device;
    on_gone(device);
    on_device(device, *editing.session().identity_of(device));
    if (!editing.session().pens().decodes(device)) continue;
    ready = editing.session().identity_of(device)->name;
    if (parts_.tablets.seen.contains(device)) editing.input().set_tablet(device, parts_.bindings.setting_of(device));
  }
  if (!gone.empty()) parts_.notices.tell(gone + " is out of reach" + held, true);
  if (!ready.empty()) parts_.notices.tell(ready + " is ready");
}

void TabletEvents::tell_of_leaving(int device, const std::string& name, const std::string& held) {
  std::string text = name + " was unplugged" + held;
  // A receiver's other interfaces come and go with the tablet that it hears.
  const auto identity = parts_.tablets.seen.find(device);
  if (held.empty() && identity != parts_.tablets.seen.end() && decode::is_wacom_receiver(identity->second) &&
      !decode::is_receiver_monitor(identity->second))
    return;
  // Its other interface may have told more.
  const auto& all = parts_.notices.all();
  const bool told = std::any_of(all.begin(), all.end(),
                                [&](const Notice& one) { return one.text != text && one.text.starts_with(text); });
  if (!told) parts_.notices.tell(std::move(text), true);
}

void TabletEvents::on_device(int device, const decode::DeviceIdentity& identity) {
  EditingSession& editing = parts_.editing;
  const decode::DeviceIdentity* shown = editing.session().identity_of(device);
  parts_.desk.add(device, shown != nullptr ? *shown : identity, editing.session().hands(),
                  editing.session().pens().axes_of(device), parts_.own_tablets);
  // A trace is drawn as it is, but for what its pen's buttons are bound to.
  const auto& trace = parts_.player.trace;
  const std::uint32_t buttons = parts_.bindings.drawing_buttons(device);
  if (parts_.tablets.seen.contains(device) || !trace || trace->is_session() || buttons == 0) return;
  replay::TabletSetting setting;
  setting.drawing_buttons = buttons;
  editing.input().set_tablet(device, setting);
}

void TabletEvents::on_moments(int device, std::span<const replay::PenMoment> pen,
                              std::span<const replay::HandMoment> hand) {
  if (!pen.empty()) tell_guess(device);
  // What a session's keys did is in its lines, in px of the window that it was drawn in.
  if (parts_.player.trace->is_session()) return;
  parts_.canvas.commit();
  take_hand(hand);
  parts_.pens.take(device, pen);
}

void TabletEvents::on_gone(int device) {
  parts_.desk.remove(device);
  parts_.fingers.forget(device);
  parts_.pens.button_gone();
  parts_.dials.end();
  parts_.keys.place_pen();
  parts_.keys.follow_tool();
}

}  // namespace penpose::app
