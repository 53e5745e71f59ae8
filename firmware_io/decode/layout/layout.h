#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firmware_io/decode/sample/bit_field.h"

namespace penpose::decode {

/// The meaning of a report that fits a layout.
enum class Gives : std::uint8_t {
  ignored,    ///< nothing
  pen,        ///< position and state of the pen
  mouse,      ///< a puck or lens cursor on the tablet
  tool,       ///< the tool that has just come near; its position follows in other reports
  leave,      ///< the tool has left
  pad,        ///< keys and wheels of the tablet
  touch_pad,  ///< a 64-byte Wacom touch report: contacts, and pad keys among them
  touch,      ///< contacts
};

/// Signed steps of a wheel: a number, or one test for a step either way.
struct StepField {
  std::optional<BitNumber> steps;
  std::optional<BitTest> forward;  ///< looked at first
  std::optional<BitTest> backward;

  [[nodiscard]] std::int64_t read(base::Bytes report) const {
    if (steps) return steps->read_or(report, 0);
    if (forward && forward->holds(report)) return 1;
    return backward && backward->holds(report) ? -1 : 0;
  }
};

/// Pad keys that come as key codes of a keyboard. Key i is down while a report lists `keys[i].code`.
struct KeyCodes {
  enum class Modifiers : std::uint8_t { any, none, some };
  struct Key {
    std::uint8_t code = 0;
    Modifiers modifiers = Modifiers::any;
  };
  std::uint16_t first_byte = 0;  ///< the codes go from here to the end of the report
  std::uint16_t modifier_byte = 0;
  std::vector<Key> keys;
};

/// Consecutive entries of fingers. Fields count from the first byte of an entry.
struct ContactList {
  std::size_t from = 0;       ///< byte of the report where the first entry begins
  std::size_t size = 0;       ///< bytes of an entry
  std::size_t most = 0;       ///< entries to read; fewer if the report ends before
  std::int64_t first_id = 0;  ///< entries with numbers outside of this range are ignored
  std::int64_t last_id = 0;
  BitNumber id, x, y;
  BitTest down;
};

/// The layout of one kind of report. Missing fields are empty.
struct Layout {
  Gives gives = Gives::ignored;
  std::size_t shortest = 0;  ///< shorter reports are ignored; covers every field

  std::optional<BitNumber> x, y, pressure, tilt_x, tilt_y, distance, rotation, wheel;
  std::optional<BitNumber> buttons;  ///< bit i: button i
  std::optional<BitTest> tip;        ///< empty: by pressure
  std::optional<BitTest> eraser;
  std::optional<BitTest> near;  ///< empty: always near
  std::optional<StepField> scroll;
  bool last_pressure = false;  ///< pressure is that of the last report with one
  bool last_tilt = false;
  bool last_buttons = false;
  bool eraser_by_tool = false;      ///< as in the last tool report
  bool rotation_is_marker = false;  ///< the Wacom art pen's code rather than a number
  int eraser_button = 0;            ///< 1-based: this button's bit means the eraser if set when the tool came near

  std::optional<BitNumber> tool_id, serial;

  std::optional<BitNumber> keys;            ///< bit i: key i
  std::optional<BitNumber> changed_key;     ///< the highest bit set is the one key that changes...
  std::optional<BitTest> changed_key_down;  ///< ...to down if this holds, else to up
  std::optional<KeyCodes> key_codes;
  std::optional<BitNumber> ring, second_ring;    ///< position; absent while not touched
  std::optional<BitNumber> strip, second_strip;  ///< position; 0 while not touched
  std::optional<BitNumber> wheel_buttons;
  std::optional<StepField> dial, second_dial;

  std::optional<BitNumber> battery;  ///< of reports with nothing else
  std::int64_t battery_full = 100;

  std::optional<ContactList> contacts;
};

/// The reports of one family of tablets: the first rule whose test holds gives the layout of a report.
struct Protocol {
  struct Rule {
    BitTest when;
    std::shared_ptr<const Layout> layout;
  };
  std::string name;
  std::size_t skip = 0;        ///< leading bytes to drop; all byte numbers count after them
  std::size_t shortest = 0;    ///< shorter reports are ignored before any rule
  std::int64_t tip_above = 0;  ///< without a tip bit, the tip touches above this pressure
  std::vector<Rule> rules;     ///< a report that fits none is ignored

  /// Another order of the bytes that some firmware of the same tablet has.
  struct Variant {
    BitTest told_by;  ///< reports that only this one sends
    std::vector<Rule> rules;
  };
  /// Alternatives to `rules`, which hold until a report tells one of these; the last one told holds.
  std::vector<Variant> variants;
};

}  // namespace penpose::decode
