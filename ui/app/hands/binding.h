#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/tool.h"
#include "firmware_io/decode/sample/pad_events.h"
#include "ui/app/action.h"

namespace penpose::app {

/// What the pen does to the view while a key is held.
enum class ViewHold : std::uint8_t { turn, move, zoom };

/// What a ring, a strip or a wheel changes.
enum class DialUse : std::uint8_t {
  time,     ///< the timeline's cursor, frame by frame: a brush of time
  zoom,     ///< the distance, about the pen
  turn,     ///< the view, about the model
  control,  ///< the value of the control in hand
  undo,     ///< back and forth through what was done
  keys,     ///< from key to key of the timeline
};

/// What a key or a dial of a tablet, or a button of a pen does.
struct Binding {
  enum class Kind : std::uint8_t {
    none,
    action,     ///< once, when it is pressed
    view,       ///< while it is held
    tool,       ///< while it is held; then the tool is again the one that it was
    dial,       ///< by as much as it is turned
    pen_menu,   ///< turns the view while it is held; a click opens the menu around the pen
    next_mode,  ///< rings and their like do the next thing, on tablets that have no lights for that
  };
  Kind kind = Kind::none;
  Action action = Action::undo;
  ViewHold view = ViewHold::turn;
  drawing::ToolKind tool = drawing::ToolKind::erase;
  DialUse dial = DialUse::time;

  friend bool operator==(const Binding&, const Binding&) = default;
};

[[nodiscard]] Binding binding_of(Action action);
[[nodiscard]] Binding binding_of(ViewHold view);
[[nodiscard]] Binding binding_of(drawing::ToolKind tool);
[[nodiscard]] Binding binding_of(DialUse dial);

/// How settings write it: "action Undo", "hold turn", "tool Erase", "dial time", "menu", "mode", "none".
[[nodiscard]] std::string to_text(const Binding& binding);
/// Nothing where it is not known.
[[nodiscard]] std::optional<Binding> parse_binding(std::string_view text);
/// A word or two for a button.
[[nodiscard]] std::string label_of(const Binding& binding);

/// What it does, in a line; empty where the label says all.
[[nodiscard]] std::string tip_of(const Binding& binding);

/// What can be chosen for a key besides actions: what holds while it is held.
[[nodiscard]] std::span<const Binding> held_choices();
[[nodiscard]] std::span<const Binding> dial_choices();

/// One thing on a tablet or its pen that something can be bound to.
struct PadControl {
  enum class Kind : std::uint8_t { key, ring, strip, wheel, pen_button, pen_wheel, pen_rotation };
  Kind kind = Kind::key;
  std::uint8_t index = 0;  ///< PadKey, side, or button of the pen
  std::int8_t mode = 0;    ///< of dials: the light that is on

  friend bool operator==(const PadControl&, const PadControl&) = default;
};

[[nodiscard]] inline PadControl key_control(decode::PadKey key) {
  return {PadControl::Kind::key, static_cast<std::uint8_t>(key), 0};
}
[[nodiscard]] PadControl dial_control(decode::PadDial dial, std::uint8_t side, std::int8_t mode);
[[nodiscard]] inline PadControl pen_button_control(std::uint8_t button) {
  return {PadControl::Kind::pen_button, button, 0};
}
[[nodiscard]] bool is_dial(const PadControl& control);
[[nodiscard]] bool is_of_pen(const PadControl& control);

/// How settings name it: "BTN_0", "ring 1 light 2", "pen button 1".
[[nodiscard]] std::string name_of(const PadControl& control);
/// How it is shown: "Key 3", "Ring, light 2", "Pen's button 1".
[[nodiscard]] std::string title_of(const PadControl& control, const decode::PadFeatures& features);

/// Whether it is one of those that tablets only number.
[[nodiscard]] bool is_numbered(decode::PadKey key);
/// The keys of a pad in the order in which a hand counts them: the numbered ones, then those with a meaning of their
/// own.
[[nodiscard]] std::vector<decode::PadKey> keys_of(const decode::PadFeatures& features);
/// Where a key stands among those that turn on the lights: the dial that it is for, and which of its lights it chooses
/// where each has a key of its own. Nothing for any other key.
struct ModeKey {
  std::uint8_t side = 0;
  std::int8_t light = -1;  ///< -1: it goes on to the next
};
[[nodiscard]] std::optional<ModeKey> mode_key(decode::PadKey key, const decode::PadFeatures& features);
/// How many things each dial can do: its lights, or as many on a pad without lights, for Kind::next_mode.
[[nodiscard]] std::int8_t modes_of(const decode::PadFeatures& features);

/// What it does where nobody has chosen: by how many keys there are, the most wanted first.
[[nodiscard]] Binding default_binding(const PadControl& control, const decode::PadFeatures& features);

}  // namespace penpose::app
