#pragma once

#include <optional>

#include "replay/session/live_session.h"
#include "ui/app/hands/hand_desk.h"
#include "ui/app/hands/known_tablets.h"
#include "ui/app/hands/panel_turn.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What keys, dials and pens of tablets do, and how their pens draw.
class Bindings {
 public:
  Bindings(EditingSession& editing, Preferences& preferences, const HandDesk& desk, const KnownTablets& tablets,
           const PanelTurn& panel = {});

  /// What a key, a dial or a button of a pen does.
  [[nodiscard]] Binding bound(const DeskTablet& tablet, const PadControl& control) const;
  /// Binds it to something else; nullopt restores the default.
  void bind(const DeskTablet& tablet, const PadControl& control, std::optional<Binding> binding);
  /// What a tablet's dial does now.
  [[nodiscard]] std::int8_t dial_mode(const DeskTablet& tablet, std::uint8_t side) const;
  /// The buttons of a pen that act while it draws: bit i for button i.
  [[nodiscard]] std::uint32_t drawing_buttons(int device) const;
  /// What the user chose, with the turn of the panel that the pen is built into.
  [[nodiscard]] replay::TabletSetting setting_of(int device) const;
  /// Saves the settings and applies them to every tablet in use.
  void setting_changed();

 private:
  EditingSession& editing_;
  Preferences& preferences_;
  const HandDesk& desk_;
  const KnownTablets& tablets_;
  PanelTurn panel_;
};

}  // namespace penpose::app
