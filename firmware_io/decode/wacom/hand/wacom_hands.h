#pragma once

#include <cstdint>
#include <span>

namespace penpose::decode {

/// The key formats of Wacom's tablets that do not describe themselves.
enum class WacomPad : std::uint8_t {
  none,
  graphire4,           ///< two keys and a wheel, in the pen's report
  graphire_bluetooth,  ///< two keys, in the pen's report
  bamboo_first,        ///< four keys and a ring, in the pen's report
  bamboo,              ///< four keys, in the report of the fingers
  intuos_ht,           ///< the same with two keys swapped
  dtus,
  intuos3_small,  ///< one strip
  intuos3,        ///< two strips, and the first Cintiqs
  intuos4,
  intuos4_bluetooth,
  intuos5,
  cintiq_21ux2,
  cintiq_22hd,
  cintiq_24hd,
  cintiq_27qhd,
  cintiq_13hd,
  cintiq_hybrid,  ///< the same without a ring
  cintiq_companion2,
  dtk,
  intuos_pro_bluetooth,
  intuos_2018_bluetooth,
  remote,  ///< ExpressKey Remote
};

/// Their formats of fingers.
enum class WacomTouch : std::uint8_t {
  none,
  bamboo,               ///< 20 bytes with two fingers, or 64 bytes with messages of eight bytes
  intuos,               ///< the 64 bytes alone
  display,              ///< up to four fingers a report
  display_27qhd,        ///< up to ten
  tablet_pc,            ///< one finger, or two in 14 bytes
  tablet_pc_many,       ///< up to five fingers a report, with sizes
  tablet_pc_many_bare,  ///< the same without sizes
  bamboo_pad,
  intuos_pro_bluetooth,
};

/// The keys and fingers of a tablet.
struct WacomHand {
  std::uint16_t product;
  WacomPad pad;
  std::uint8_t keys;  ///< numbered keys
  WacomTouch touch;
  std::uint8_t contacts;  ///< most fingers; 0 if the tablet must be asked
  bool has_partner;       ///< its fingers are a USB device of their own, and a key turns them off
};

/// All models, ordered by product id. Source of the figures: the device table of the Linux wacom driver.
[[nodiscard]] std::span<const WacomHand> wacom_hands();

/// The entry of a product on this bus, null if there is none or it describes itself.
[[nodiscard]] const WacomHand* find_wacom_hand(std::uint16_t bus, std::uint16_t vendor, std::uint16_t product);

}  // namespace penpose::decode
