#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/described_control.h"
#include "firmware_io/decode/sample/pad_sample.h"

namespace penpose::decode {

/// What a control of a described pad gives.
enum class DescribedPadRole : std::uint8_t {
  key,
  ring,    ///< an absolute position
  strip,   ///< the same along a line
  wheel,   ///< steps
  dial,    ///< steps of a wheel that Linux does not count among those that scroll
  finger,  ///< other than 0 while a finger is on the ring or strip of the same report
};

struct DescribedPadControl {
  DescribedPadRole role = DescribedPadRole::key;
  PadKey key = PadKey::button0;
  std::uint8_t side = 0;
  std::uint8_t report_id = 0;
  bool null_state = false;  ///< values outside of the range say nothing; without it they count as its nearest end
  /// In how many selectors of an array, `place` being the first, the key may be named, and by which number; 0: it has
  /// a place of its own.
  std::uint32_t selectors = 0;
  std::int64_t selected_by = 0;
  DescribedControl place;

  /// Its value in a report of its id; nothing where the report says nothing about it.
  [[nodiscard]] std::optional<std::int64_t> value(base::Bytes report) const;
};

/// The reports of a pad that describes itself.
struct DescribedPad {
  bool has_report_ids = false;
  std::array<std::uint32_t, 256> length{};    ///< bytes by id, the id included; 0 for reports of something else
  std::array<std::uint32_t, 256> needed{};    ///< bytes up to the last control
  std::vector<DescribedPadControl> controls;  ///< in order of the descriptor
  PadFeatures features;

  /// Whether it is a report of the pad that is long enough.
  [[nodiscard]] bool has(base::Bytes report) const;
};

/// The pad that an interface describes with the standard's pages: a Keypad with buttons, or Tablet Function Keys.
/// Makers describe few of them; those of Linux's hid-uclogic and HID-BPF programs are so, which rewrite descriptors and
/// reports of many tablets. Nothing when there is none, as with the numbers of a keyboard.
///
/// Keys and dials are those that Linux makes of the usages (6.1, hid-input.c). Of two usages in an application that
/// mean the same key, the first is it, and the other is nothing.
[[nodiscard]] std::optional<DescribedPad> find_described_pad(const hid::ReportDescriptor& descriptor);

}  // namespace penpose::decode
