#include "ui/app/hands/bindings.h"

#include <algorithm>

namespace penpose::app {

namespace {

using Kind = Binding::Kind;

}  // namespace

Bindings::Bindings(EditingSession& editing, Preferences& preferences, const HandDesk& desk, const KnownTablets& tablets,
                   const PanelTurn& panel)
    : editing_(editing), preferences_(preferences), desk_(desk), tablets_(tablets), panel_(panel) {}

Binding Bindings::bound(const DeskTablet& tablet, const PadControl& control) const {
  const auto& pads = preferences_.settings().pads;
  if (const auto chosen = pads.find(tablet.key); chosen != pads.end()) {
    const auto found = chosen->second.find(name_of(control));
    if (found != chosen->second.end()) return found->second;
  }
  return default_binding(control, tablet.features);
}

void Bindings::bind(const DeskTablet& tablet, const PadControl& control, std::optional<Binding> binding) {
  auto& pads = preferences_.settings().pads;
  if (binding) {
    pads[tablet.key][name_of(control)] = *binding;
  } else {
    pads[tablet.key].erase(name_of(control));
  }
  if (pads[tablet.key].empty()) pads.erase(tablet.key);
  if (control.kind == PadControl::Kind::pen_button) {
    setting_changed();
  } else {
    preferences_.changed();
  }
}

std::uint32_t Bindings::drawing_buttons(int device) const {
  constexpr std::uint8_t k_buttons = 8;
  const DeskTablet* tablet = desk_.find(device);
  std::uint32_t buttons = 0;
  for (std::uint8_t i = 0; tablet != nullptr && i < k_buttons; ++i) {
    const Binding::Kind kind = bound(*tablet, pen_button_control(i)).kind;
    if (kind == Kind::tool || kind == Kind::action) buttons |= 1U << i;
  }
  return buttons;
}

replay::TabletSetting Bindings::setting_of(int device) const {
  replay::TabletSetting setting = preferences_.settings().tablet;
  setting.drawing_buttons = drawing_buttons(device);
  if (const auto seen = tablets_.seen.find(device); seen != tablets_.seen.end()) {
    setting.quarter_turns = (setting.quarter_turns + panel_.quarter_turns_of(seen->second)) % 4;
  }
  return setting;
}

std::int8_t Bindings::dial_mode(const DeskTablet& tablet, std::uint8_t side) const {
  const decode::PadDecoder* pad = editing_.session().hands().pad(tablet.pad);
  if (tablet.features.modes == 0 || pad == nullptr) return tablet.next_mode[side];
  // Where there is one light for two dials it is the light of both.
  return pad->sample().mode[std::min<std::size_t>(side, tablet.features.modes - 1)];
}

void Bindings::setting_changed() {
  preferences_.changed();
  for (const auto& [device, name] : tablets_.seen) {
    if (editing_.session().pens().decodes(device)) editing_.input().set_tablet(device, setting_of(device));
  }
}

}  // namespace penpose::app
