#pragma once

#include <initializer_list>
#include <vector>

#include "tests/support/hands/pen_reports.h"

// Writes descriptors of keys and fingers, item by item, for the decoders that read them.
namespace penpose::tests {

inline void append(Report& to, const Report& bytes) { to.insert(to.end(), bytes.begin(), bytes.end()); }

/// An Input item of `count` controls of `bits` with these usages (page and id), from 0 to `maximum`; `flags` as in HID
/// 1.11, 6.2.2.5.
inline Report input(const std::vector<std::uint32_t>& usages, std::uint8_t bits, std::uint8_t count,
                    std::uint32_t maximum = 1, std::uint8_t flags = 0x02) {
  Report items;
  for (const std::uint32_t usage : usages) {
    items.push_back(0x0b);
    for (int i = 0; i < 4; ++i) items.push_back(static_cast<std::uint8_t>(usage >> (8 * i)));
  }
  append(items, {0x15, 0x00, 0x27});
  for (int i = 0; i < 4; ++i) items.push_back(static_cast<std::uint8_t>(maximum >> (8 * i)));
  append(items, {0x75, bits, 0x95, count, 0x81, flags});
  return items;
}
/// A message of a finger in Wacom's reports of 64 bytes: its number, whether it is down, twelve bits of each place.
struct FingerMessage {
  std::uint8_t id = 0;
  bool down = true;
  int x = 0, y = 0;
};
inline Report wacom_touch64(const std::vector<FingerMessage>& messages) {
  Report report(64);
  report[0] = 0x02;
  report[1] = static_cast<std::uint8_t>(messages.size());
  std::size_t at = 2;
  for (const FingerMessage& one : messages) {
    report[at] = one.id;
    report[at + 1] = one.down ? 0x80 : 0;
    report[at + 2] = static_cast<std::uint8_t>(one.x >> 4);
    report[at + 3] = static_cast<std::uint8_t>(one.y >> 4);
    report[at + 4] = static_cast<std::uint8_t>((one.x & 15) << 4 | (one.y & 15));
    at += 8;
  }
  return report;
}

inline Report padding(std::uint8_t bits) { return {0x75, bits, 0x95, 0x01, 0x81, 0x03}; }

/// Fingers of six bytes each: tip, in range and confidence, a number, two places of sixteen bits.
inline Report finger() {
  Report items{0x05, 0x0d, 0x09, 0x22, 0xa1, 0x02};
  append(items, input({0xd0042, 0xd0032, 0xd0047}, 1, 3));
  append(items, padding(5));
  append(items, input({0xd0051}, 8, 1, 255));
  append(items, input({0x10030}, 16, 1, 9600));
  append(items, input({0x10031}, 16, 1, 7200));
  items.push_back(0xc0);
  return items;
}

/// A touch screen of report 1 with `fingers` fingers and their count.
inline Report touch_descriptor(int fingers, bool counted = true, bool certified = false) {
  Report items{0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01, 0x85, 0x01};
  for (int i = 0; i < fingers; ++i) append(items, finger());
  if (counted) append(items, input({0xd0054}, 8, 1, 255));
  append(items, {0x85, 0x02, 0x0b, 0x55, 0x00, 0x0d, 0x00, 0x25, 0x0a, 0x75, 0x08, 0x95, 0x01, 0xb1, 0x02});
  if (certified)
    append(items,
           {0x85, 0x03, 0x06, 0x00, 0xff, 0x09, 0xc5, 0x26, 0xff, 0x00, 0x75, 0x08, 0x96, 0x00, 0x01, 0xb1, 0x02});
  items.push_back(0xc0);
  return items;
}

struct FingerBytes {
  std::uint8_t flags;  ///< 1 tip, 2 in range, 4 confident
  std::uint8_t id;
  std::int32_t x;
  std::int32_t y;
};
inline Report touch_report(const std::vector<FingerBytes>& fingers, int count = -1) {
  Report report{0x01};
  for (const FingerBytes& one : fingers)
    append(report, {one.flags, one.id, low(one.x), high(one.x), low(one.y), high(one.y)});
  if (count >= 0) report.push_back(static_cast<std::uint8_t>(count));
  return report;
}

/// A Wacom pad as report 17: eight keys, a middle key, a slide that turns touch on, the ring's status and place, and
/// the battery.
inline Report wacom_pad_descriptor() {
  constexpr std::uint32_t k_page = 0xff0d0000;
  Report items{0x06, 0x0d, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x11, 0x06, 0x0d, 0xff, 0x09, 0x39, 0xa1, 0x00};
  std::vector<std::uint32_t> keys;
  for (std::uint32_t i = 0; i < 8; ++i) keys.push_back(k_page | (0x910 + i));
  append(items, input(keys, 1, 8));
  append(items, input({k_page | 0x995}, 1, 1));
  append(items, input({k_page | 0x454}, 1, 1));
  append(items, padding(6));
  append(items, input({k_page | 0x139}, 1, 1));
  append(items, input({k_page | 0x138}, 7, 1, 71));
  append(items, input({k_page | 0x43b}, 7, 1, 100));
  append(items, input({k_page | 0x404}, 1, 1));
  append(items, {0xc0, 0xc0});
  return items;
}

/// An Input item of one control of eight bits with this usage, which counts steps from -`most` to `most`.
inline Report steps(std::uint32_t usage, std::uint8_t most = 1) {
  Report items{0x0b};
  for (int i = 0; i < 4; ++i) items.push_back(static_cast<std::uint8_t>(usage >> (8 * i)));
  append(items, {0x15, static_cast<std::uint8_t>(-most), 0x25, most, 0x75, 0x08, 0x95, 0x01, 0x81, 0x06});
  return items;
}

/// The usages of the first `count` buttons.
inline std::vector<std::uint32_t> buttons(std::uint32_t count) {
  std::vector<std::uint32_t> usages;
  for (std::uint32_t i = 1; i <= count; ++i) usages.push_back(0x90000 | i);
  return usages;
}

/// The beginning of a Keypad's report with Tablet Function Keys.
inline Report function_keys(std::uint8_t id) {
  return {0x05, 0x01, 0x09, 0x07, 0xa1, 0x01, 0x85, id, 0x05, 0x0d, 0x09, 0x39, 0xa1, 0x00};
}

/// A pad as Linux's hid-uclogic describes it, in reports of twelve bytes: 0xf7 with ten keys and three of a game pad
/// from byte 4 on, 0xf8 with a ring of twelve places and 0xf9 with a dial, both in byte 5 with a sign of the finger
/// before it. What makes desktops take it for a pad is in byte 1.
inline Report uclogic_pad_descriptor() {
  Report items = function_keys(0xf7);
  append(items, input({0xd0044}, 1, 1));
  append(items, input({0x10030, 0x10031}, 1, 2));
  append(items, padding(21));
  append(items, input(buttons(10), 1, 10));
  append(items, {0xc0, 0x05, 0x01, 0x09, 0x05, 0xa1, 0x00});
  append(items, input(buttons(3), 1, 3));
  append(items, padding(51));
  append(items, {0xc0, 0xc0});
  for (const std::uint8_t id : {std::uint8_t{0xf8}, std::uint8_t{0xf9}}) {
    append(items, function_keys(id));
    append(items, input(buttons(1), 1, 1));
    append(items, padding(23));
    append(items, input({0xdffff}, 8, 1, 255));
    append(items, id == 0xf8 ? input({0x10038}, 8, 1, 11) : steps(0x10038));
    append(items, padding(48));
    append(items, {0xc0, 0xc0});
  }
  return items;
}

}  // namespace penpose::tests
