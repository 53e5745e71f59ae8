#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "ui/app/files/player.h"
#include "ui/app/hands/known_tablets.h"
#include "ui/app/hands/tablet_fingers.h"
#include "ui/app/input/pens.h"

namespace penpose::app {

/// Tablets that come and go, and what they report.
class TabletEvents : public TracePlayer::Listener {
 public:
  struct Parts {
    const decode::TabletTable* own_tablets;
    EditingSession& editing;
    Canvas& canvas;
    Dialogs& dialogs;
    Notices& notices;
    const Player& player;
    HandDesk& desk;
    KnownTablets& tablets;
    Bindings& bindings;
    PointerPlace& place;
    Dials& dials;
    HeldKeys& keys;
    TabletFingers& fingers;
    Pens& pens;
  };
  explicit TabletEvents(const Parts& parts) : parts_(parts) {}

  void arrived(int device, const decode::DeviceIdentity& identity);
  void left(int device, const std::string& name);
  void report(int device, std::int64_t received_us, base::Bytes bytes);
  /// The lights that are on beside the dials of a tablet that has arrived.
  void lights_seen(int device, const decode::Lights& lights);
  /// The lights that a device is to show, nothing where it has none.
  [[nodiscard]] std::optional<decode::Lights> lights_of(int device) const;
  /// The session is another: tablets are plugged in anew, and nothing is held or being turned.
  void plug_in_anew();

  // What a trace that is played in place of tablets does.
  void on_device(int device, const decode::DeviceIdentity& identity) override;
  void on_moments(int device, std::span<const replay::PenMoment> pen,
                  std::span<const replay::HandMoment> hand) override;
  void on_gone(int device) override;

 private:
  void take_hand(std::span<const replay::HandMoment> moments);
  void take_pad_event(DeskTablet& tablet, int device, const decode::PadEvent& event);
  void tell_battery(DeskTablet& tablet, int device);
  /// Says once in a run which of several models a tablet is taken for, and what tells.
  void tell_guess(int device);
  /// A wireless receiver hears another tablet, or none any more.
  void change_tablets(std::span<const replay::HandMoment> moments);
  /// What was held on a device that goes, for the message: "; Key 2 (Undo) was held and is let go".
  [[nodiscard]] std::string held_until_now(int device, std::span<const replay::HandMoment> let_go) const;
  void tell_of_leaving(int device, const std::string& name, const std::string& held);

  Parts parts_;
  std::set<std::string> told_guesses_;
};

}  // namespace penpose::app
