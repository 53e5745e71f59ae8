#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "firmware_io/decode/layout/layout_reader.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/table/text_pattern.h"

namespace penpose::decode {

/// One way to identify an interface of a tablet, and how to wake and read it. Absent means any.
struct TabletIdentifier {
  struct StringCheck {
    std::uint8_t index = 0;  ///< USB string descriptor
    TextPattern pattern;     ///< found somewhere in it
  };

  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::optional<std::uint16_t> input_report_length;  ///< longest report, report id included
  std::optional<std::uint16_t> output_report_length;
  std::optional<std::uint16_t> feature_report_length;
  std::optional<int> interface_number;
  std::vector<StringCheck> strings;  ///< all must hold
  std::shared_ptr<const Protocol> protocol;
  bool replaces_descriptor = false;  ///< what the interface describes of its pen is wrong

  // To wake it: read these strings, then send these feature reports, then these output reports (first byte: report
  // id).
  std::vector<std::uint8_t> read_strings;
  std::vector<std::vector<std::uint8_t>> send_features;
  std::vector<std::vector<std::uint8_t>> send_outputs;
};

/// A wheel on the tablet itself.
struct TabletWheel {
  bool is_ring = false;     ///< gives positions (touch ring) rather than steps (dial)
  double steps = 0;         ///< per turn
  double zero_degrees = 0;  ///< where position 0 is
  int buttons = 0;
};

/// The touch area of a tablet.
struct TabletTouch {
  double width_mm = 0;  ///< 0 if unknown
  double height_mm = 0;
  std::int32_t max_x = 0;  ///< largest raw values
  std::int32_t max_y = 0;
  int contacts = 0;  ///< the most at a time, 0 if unknown
};

struct Tablet {
  std::string vendor;
  std::string name;
  double width_mm = 0;  ///< active area
  double height_mm = 0;
  std::int32_t max_x = 0;  ///< largest raw values
  std::int32_t max_y = 0;
  std::int32_t max_pressure = 0;
  int pen_buttons = 0;
  int pad_keys = 0;
  int mouse_buttons = 0;
  std::vector<TabletWheel> wheels;
  int strips = 0;
  std::optional<TabletTouch> touch;
  bool hide_from_desktop = false;             ///< the system's own device would also move the pointer
  int feature_delay_ms = 0;                   ///< wait before each feature report
  std::vector<TabletIdentifier> identifiers;  ///< of the pen interface
  std::vector<TabletIdentifier> pads;         ///< further interfaces of the same tablet with keys or touch
  /// Report parsers of OpenTabletDriver that its configuration names and that have no protocol here; the identifiers
  /// with them are left out.
  std::vector<std::string> unread_parsers;
};

/// The result of `find`. Both pointers live as long as the table.
struct TabletMatch {
  const Tablet* tablet = nullptr;
  const TabletIdentifier* identifier = nullptr;
  bool is_pad = false;   ///< one of the tablet's `pads`
  bool certain = false;  ///< no condition of the identifier was unknown, and no other tablet fits as well
  /// Other tablets that it may be just as well, because what tells them apart (a USB string, the device's name) is not
  /// known. Above 0: a guess.
  std::size_t others = 0;
};

/// What a match with `others` takes the device for, in words; empty where there are none.
[[nodiscard]] std::string guess_of(const TabletMatch& match, const DeviceIdentity& device);

class TabletTable {
 public:
  TabletTable() = default;
  explicit TabletTable(std::vector<Tablet> tablets) : tablets_(std::move(tablets)) {}

  /// A table of one tablet of this one, known by name and asking for nothing but its ids. `name` is
  /// that of the tablet, alone or behind its vendor's; case does not count. Errors: no such tablet, or several.
  [[nodiscard]] base::Result<TabletTable> choose(std::string_view name) const;
  /// Whether it was made by `choose`: its tablet is what a device would be found to be, with the reports that the
  /// device describes itself.
  [[nodiscard]] bool is_choice() const { return is_choice_; }

  [[nodiscard]] std::span<const Tablet> tablets() const { return tablets_; }

  /// The tablet that the interface belongs to. An identifier fits if nothing known contradicts it; of several, the one
  /// with the most conditions met wins, then one with the protocol of most of the others, then the earlier. Nothing if
  /// none fits.
  [[nodiscard]] std::optional<TabletMatch> find(const DeviceIdentity& device) const;

  /// The only tablet with a device's ids, or of several the only one that its name holds, whatever else their
  /// identifiers ask for; null if there is none.
  [[nodiscard]] const Tablet* only_one(const DeviceIdentity& device) const;

 private:
  std::vector<Tablet> tablets_;
  bool is_choice_ = false;
};

/// The built-in tablets.
[[nodiscard]] const TabletTable& known_tablets();

/// Searches `own` first (a user's tablets; may be null), then the built-in ones.
[[nodiscard]] std::optional<TabletMatch> find_tablet(const DeviceIdentity& device, const TabletTable* own = nullptr);

/// A fresh decoder for the reports of that interface, with the tablet's ranges and resolution in its axes.
[[nodiscard]] std::unique_ptr<PenDecoder> make_tablet_decoder(const TabletMatch& match);

}  // namespace penpose::decode
