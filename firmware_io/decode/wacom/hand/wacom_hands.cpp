#include "firmware_io/decode/wacom/hand/wacom_hands.h"

#include <algorithm>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::decode {
namespace {

using P = WacomPad;
using T = WacomTouch;

// clang-format off
constexpr WacomHand k_hands[] = {
    {0x0015, P::graphire4, 0, T::none, 0, false},
    {0x0016, P::graphire4, 0, T::none, 0, false},
    {0x0017, P::bamboo_first, 0, T::none, 0, false},
    {0x0018, P::bamboo_first, 0, T::none, 0, false},
    {0x0026, P::intuos5, 7, T::intuos, 16, false},
    {0x0027, P::intuos5, 9, T::intuos, 16, false},
    {0x0028, P::intuos5, 9, T::intuos, 16, false},
    {0x0029, P::intuos5, 7, T::none, 0, false},
    {0x002a, P::intuos5, 9, T::none, 0, false},
    {0x003f, P::intuos3, 8, T::none, 0, false},
    {0x0057, P::dtk, 6, T::none, 0, false},
    {0x0059, P::dtk, 6, T::none, 0, true},
    {0x005b, P::cintiq_22hd, 18, T::none, 0, true},
    {0x005d, P::none, 0, T::display, 10, true},
    {0x005e, P::none, 0, T::display, 10, true},
    {0x0065, P::bamboo_first, 0, T::none, 0, false},
    {0x0081, P::graphire_bluetooth, 2, T::none, 0, false},
    {0x0090, P::none, 0, T::tablet_pc, 0, false},
    {0x0093, P::none, 0, T::tablet_pc, 1, false},
    {0x0097, P::none, 0, T::tablet_pc, 0, false},
    {0x009a, P::none, 0, T::tablet_pc, 1, false},
    {0x009f, P::none, 0, T::tablet_pc, 1, false},
    {0x00b0, P::intuos3_small, 4, T::none, 0, false},
    {0x00b1, P::intuos3, 8, T::none, 0, false},
    {0x00b2, P::intuos3, 8, T::none, 0, false},
    {0x00b3, P::intuos3, 8, T::none, 0, false},
    {0x00b4, P::intuos3, 8, T::none, 0, false},
    {0x00b5, P::intuos3, 8, T::none, 0, false},
    {0x00b7, P::intuos3_small, 4, T::none, 0, false},
    {0x00b8, P::intuos4, 7, T::none, 0, false},
    {0x00b9, P::intuos4, 9, T::none, 0, false},
    {0x00ba, P::intuos4, 9, T::none, 0, false},
    {0x00bb, P::intuos4, 9, T::none, 0, false},
    {0x00bc, P::intuos4, 9, T::none, 0, false},
    {0x00bd, P::intuos4_bluetooth, 9, T::none, 0, false},
    {0x00c5, P::intuos3, 10, T::none, 0, false},
    {0x00c6, P::intuos3, 10, T::none, 0, false},
    {0x00cc, P::cintiq_21ux2, 18, T::none, 0, false},
    {0x00d0, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d1, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d2, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d3, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d6, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d7, P::bamboo, 0, T::bamboo, 2, false},
    {0x00d8, P::bamboo, 0, T::bamboo, 2, false},
    {0x00da, P::bamboo, 0, T::bamboo, 2, false},
    {0x00db, P::bamboo, 0, T::bamboo, 2, false},
    {0x00dd, P::bamboo, 0, T::none, 0, false},
    {0x00de, P::bamboo, 0, T::bamboo, 16, false},
    {0x00df, P::bamboo, 0, T::bamboo, 16, false},
    {0x00e2, P::none, 0, T::tablet_pc, 2, false},
    {0x00e3, P::none, 0, T::tablet_pc, 2, false},
    {0x00e5, P::none, 0, T::tablet_pc_many, 0, false},
    {0x00e6, P::none, 0, T::tablet_pc, 2, false},
    {0x00ec, P::none, 0, T::tablet_pc, 0, false},
    {0x00ed, P::none, 0, T::tablet_pc, 1, false},
    {0x00ef, P::none, 0, T::tablet_pc, 0, false},
    {0x00f4, P::cintiq_24hd, 16, T::none, 0, false},
    {0x00f6, P::none, 0, T::display, 10, true},
    {0x00f8, P::cintiq_24hd, 16, T::none, 0, true},
    {0x00fa, P::cintiq_22hd, 18, T::none, 0, false},
    {0x00fb, P::dtus, 4, T::none, 0, false},
    {0x0100, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x0101, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x010d, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x010e, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x010f, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x0116, P::none, 0, T::tablet_pc, 1, false},
    {0x012c, P::none, 0, T::tablet_pc, 0, false},
    {0x0302, P::intuos_ht, 0, T::bamboo, 16, false},
    {0x0303, P::intuos_ht, 0, T::bamboo, 16, false},
    {0x0304, P::cintiq_13hd, 9, T::none, 0, false},
    {0x0307, P::cintiq_hybrid, 9, T::none, 0, true},
    {0x0309, P::none, 0, T::display, 10, true},
    {0x030a, P::cintiq_hybrid, 9, T::none, 0, true},
    {0x030c, P::none, 0, T::display, 10, true},
    {0x030e, P::intuos_ht, 0, T::none, 0, false},
    {0x0314, P::intuos5, 7, T::intuos, 16, false},
    {0x0315, P::intuos5, 9, T::intuos, 16, false},
    {0x0317, P::intuos5, 9, T::intuos, 16, false},
    {0x0318, P::none, 0, T::bamboo_pad, 4, false},
    {0x0319, P::none, 0, T::bamboo_pad, 4, false},
    {0x0323, P::intuos_ht, 0, T::none, 0, false},
    {0x0325, P::cintiq_companion2, 11, T::none, 0, true},
    {0x032a, P::cintiq_27qhd, 0, T::none, 0, false},
    {0x032b, P::cintiq_27qhd, 0, T::none, 0, true},
    {0x032c, P::none, 0, T::display_27qhd, 10, true},
    {0x0331, P::remote, 18, T::none, 0, false},
    {0x0333, P::cintiq_13hd, 9, T::none, 0, true},
    {0x0335, P::none, 0, T::display, 10, true},
    {0x0336, P::dtus, 4, T::none, 0, false},
    {0x033b, P::intuos_ht, 0, T::none, 0, false},
    {0x033c, P::intuos_ht, 0, T::bamboo, 16, false},
    {0x033d, P::intuos_ht, 0, T::none, 0, false},
    {0x033e, P::intuos_ht, 0, T::bamboo, 16, false},
    {0x0343, P::dtus, 4, T::none, 0, false},
    {0x0360, P::intuos_pro_bluetooth, 9, T::intuos_pro_bluetooth, 10, false},
    {0x0361, P::intuos_pro_bluetooth, 9, T::intuos_pro_bluetooth, 10, false},
    {0x0377, P::intuos_2018_bluetooth, 4, T::none, 0, false},
    {0x0379, P::intuos_2018_bluetooth, 4, T::none, 0, false},
    {0x0393, P::intuos_pro_bluetooth, 7, T::intuos_pro_bluetooth, 10, false},
    {0x03c6, P::intuos_2018_bluetooth, 4, T::none, 0, false},
    {0x03c8, P::intuos_2018_bluetooth, 4, T::none, 0, false},
    {0x03dd, P::intuos_pro_bluetooth, 7, T::intuos_pro_bluetooth, 10, false},
    {0x4001, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x4004, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x5000, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x5002, P::none, 0, T::tablet_pc_many_bare, 0, false},
    {0x6004, P::none, 0, T::tablet_pc, 0, false},
};
// clang-format on

constexpr std::uint16_t k_lenovo_isdv4 = 0x6004;

bool is_bluetooth_only(WacomPad pad) {
  return pad == P::graphire_bluetooth || pad == P::intuos4_bluetooth || pad == P::intuos_pro_bluetooth ||
         pad == P::intuos_2018_bluetooth;
}

}  // namespace

std::span<const WacomHand> wacom_hands() { return k_hands; }

const WacomHand* find_wacom_hand(std::uint16_t bus, std::uint16_t vendor, std::uint16_t product) {
  const bool lenovo = vendor == k_vendor_lenovo && product == k_lenovo_isdv4;
  if (vendor != k_vendor_wacom && !lenovo) return nullptr;
  const auto* const end = std::end(k_hands);
  const auto* const found = std::lower_bound(std::begin(k_hands), end, product,
                                             [](const WacomHand& hand, std::uint16_t id) { return hand.product < id; });
  if (found == end || found->product != product) return nullptr;
  const std::uint16_t wanted = is_bluetooth_only(found->pad) ? k_bus_bluetooth : k_bus_usb;
  if (bus != wanted || (product == k_lenovo_isdv4) != lenovo) return nullptr;
  return found;
}

}  // namespace penpose::decode
