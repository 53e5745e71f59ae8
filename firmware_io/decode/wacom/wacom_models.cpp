#include "firmware_io/decode/wacom/wacom_models.h"

#include <algorithm>

#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::decode {
namespace {

using F = WacomFamily;

// clang-format off
constexpr WacomModel k_models[] = {
    {0x0000, F::penpartner, "PenPartner", 5040, 3780, 255, 0, 40, 0},
    {0x0003, F::ptu, "Cintiq Partner", 20480, 15360, 511, 0, 20, 0},
    {0x0010, F::graphire, "Graphire", 10206, 7422, 511, 63, 80, 0},
    {0x0011, F::graphire, "Graphire2 4x5", 10206, 7422, 511, 63, 80, 0},
    {0x0012, F::graphire, "Graphire2 5x7", 13918, 10206, 511, 63, 80, 0},
    {0x0013, F::graphire, "Graphire3", 10208, 7424, 511, 63, 80, 0},
    {0x0014, F::graphire, "Graphire3 6x8", 16704, 12064, 511, 63, 80, 0},
    {0x0015, F::graphire4, "Graphire4 4x5", 10208, 7424, 511, 63, 80, 0},
    {0x0016, F::graphire4, "Graphire4 6x8", 16704, 12064, 511, 63, 80, 0},
    {0x0017, F::bamboo_first, "Bamboo Fun 4x5", 14760, 9225, 511, 63, 100, 0},
    {0x0018, F::bamboo_first, "Bamboo Fun 6x8", 21648, 13530, 511, 63, 100, 0},
    {0x0019, F::graphire, "Bamboo1 Medium", 16704, 12064, 511, 63, 80, 0},
    {0x0020, F::intuos, "Intuos 4x5", 12700, 10600, 1023, 31, 100, 0},
    {0x0021, F::intuos, "Intuos 6x8", 20320, 16240, 1023, 31, 100, 0},
    {0x0022, F::intuos, "Intuos 9x12", 30480, 24060, 1023, 31, 100, 0},
    {0x0023, F::intuos, "Intuos 12x12", 30480, 31680, 1023, 31, 100, 0},
    {0x0024, F::intuos, "Intuos 12x18", 45720, 31680, 1023, 31, 100, 0},
    {0x0026, F::intuos5, "Intuos5 touch S", 31496, 19685, 2047, 63, 200, 0},
    {0x0027, F::intuos5, "Intuos5 touch M", 44704, 27940, 2047, 63, 200, 0},
    {0x0028, F::intuos5_large, "Intuos5 touch L", 65024, 40640, 2047, 63, 200, 0},
    {0x0029, F::intuos5, "Intuos5 S", 31496, 19685, 2047, 63, 200, 0},
    {0x002a, F::intuos5, "Intuos5 M", 44704, 27940, 2047, 63, 200, 0},
    {0x0030, F::pl, "PL400", 5408, 4056, 255, 0, 20, 0},
    {0x0031, F::pl, "PL500", 6144, 4608, 255, 0, 20, 0},
    {0x0032, F::pl, "PL600", 6126, 4604, 255, 0, 20, 0},
    {0x0033, F::pl, "PL600SX", 6260, 5016, 255, 0, 20, 0},
    {0x0034, F::pl, "PL550", 6144, 4608, 511, 0, 20, 0},
    {0x0035, F::pl, "PL800", 7220, 5780, 511, 0, 20, 0},
    {0x0037, F::pl, "PL700", 6758, 5406, 511, 0, 20, 0},
    {0x0038, F::pl, "PL510", 6282, 4762, 511, 0, 20, 0},
    {0x0039, F::pl, "DTU710", 34080, 27660, 511, 0, 20, 0},
    {0x003f, F::cintiq, "Cintiq 21UX", 87200, 65600, 1023, 63, 200, 0},
    {0x0041, F::intuos, "Intuos2 4x5", 12700, 10600, 1023, 31, 100, 0},
    {0x0042, F::intuos, "Intuos2 6x8", 20320, 16240, 1023, 31, 100, 0},
    {0x0043, F::intuos, "Intuos2 9x12", 30480, 24060, 1023, 31, 100, 0},
    {0x0044, F::intuos, "Intuos2 12x12", 30480, 31680, 1023, 31, 100, 0},
    {0x0045, F::intuos, "Intuos2 12x18", 45720, 31680, 1023, 31, 100, 0},
    {0x0047, F::intuos, "Intuos2 6x8", 20320, 16240, 1023, 31, 100, 0},
    {0x0057, F::cintiq_hd, "DTK2241", 95840, 54260, 2047, 63, 200, 400},
    {0x0059, F::cintiq_hd, "DTH2242", 95840, 54260, 2047, 63, 200, 400},
    {0x005b, F::cintiq_hd, "Cintiq 22HD touch", 95840, 54260, 2047, 63, 200, 400},
    {0x005d, F::touch_only, "DTH2242 touch", 0, 0, 0, 0, 0, 0},
    {0x005e, F::touch_only, "Cintiq 22HD touch", 0, 0, 0, 0, 0, 0},
    {0x0060, F::graphire, "Volito", 5104, 3712, 511, 63, 50, 0},
    {0x0061, F::graphire, "PenStation2", 3250, 2320, 255, 63, 50, 0},
    {0x0062, F::graphire, "Volito2 4x5", 5104, 3712, 511, 63, 50, 0},
    {0x0063, F::graphire, "Volito2 2x3", 3248, 2320, 511, 63, 50, 0},
    {0x0064, F::graphire, "PenPartner2", 3250, 2320, 511, 63, 50, 0},
    {0x0065, F::bamboo_first, "Bamboo", 14760, 9225, 511, 63, 100, 0},
    {0x0069, F::graphire, "Bamboo1", 5104, 3712, 511, 63, 40, 0},
    {0x006a, F::graphire, "Bamboo1 4x6", 14760, 9225, 1023, 63, 100, 0},
    {0x006b, F::graphire, "Bamboo1 5x8", 21648, 13530, 1023, 63, 100, 0},
    {0x0081, F::graphire_bluetooth, "Graphire Bluetooth", 16704, 12064, 511, 32, 80, 0},
    {0x0090, F::tablet_pc, "ISDv4 90", 26202, 16325, 255, 0, 100, 0},
    {0x0093, F::tablet_pc, "ISDv4 93", 26202, 16325, 255, 0, 100, 0},
    {0x0097, F::tablet_pc, "ISDv4 97", 26202, 16325, 511, 0, 100, 0},
    {0x009a, F::tablet_pc, "ISDv4 9A", 26202, 16325, 255, 0, 100, 0},
    {0x009f, F::tablet_pc, "ISDv4 9F", 26202, 16325, 255, 0, 100, 0},
    {0x00b0, F::intuos3, "Intuos3 4x5", 25400, 20320, 1023, 63, 200, 0},
    {0x00b1, F::intuos3, "Intuos3 6x8", 40640, 30480, 1023, 63, 200, 0},
    {0x00b2, F::intuos3, "Intuos3 9x12", 60960, 45720, 1023, 63, 200, 0},
    {0x00b3, F::intuos3_large, "Intuos3 12x12", 60960, 60960, 1023, 63, 200, 0},
    {0x00b4, F::intuos3_large, "Intuos3 12x19", 97536, 60960, 1023, 63, 200, 0},
    {0x00b5, F::intuos3, "Intuos3 6x11", 54204, 31750, 1023, 63, 200, 0},
    {0x00b7, F::intuos3, "Intuos3 4x6", 31496, 19685, 1023, 63, 200, 0},
    {0x00b8, F::intuos4, "Intuos4 4x6", 31496, 19685, 2047, 63, 200, 0},
    {0x00b9, F::intuos4, "Intuos4 6x9", 44704, 27940, 2047, 63, 200, 0},
    {0x00ba, F::intuos4_large, "Intuos4 8x13", 65024, 40640, 2047, 63, 200, 0},
    {0x00bb, F::intuos4_large, "Intuos4 12x19", 97536, 60960, 2047, 63, 200, 0},
    {0x00bc, F::intuos4, "Intuos4 Wireless", 40640, 25400, 2047, 63, 200, 0},
    {0x00bd, F::intuos4_bluetooth, "Intuos4 Wireless", 40640, 25400, 2047, 63, 200, 0},
    {0x00c0, F::pl, "DTF720", 6858, 5506, 511, 0, 20, 0},
    {0x00c2, F::pl, "DTF720a", 6858, 5506, 511, 0, 20, 0},
    {0x00c4, F::pl, "DTF521", 6282, 4762, 511, 0, 20, 0},
    {0x00c5, F::cintiq_wide, "Cintiq 20WSX", 86680, 54180, 1023, 63, 200, 0},
    {0x00c6, F::cintiq_wide, "Cintiq 12WX", 53020, 33440, 1023, 63, 200, 0},
    {0x00c7, F::pl, "DTU1931", 37832, 30305, 511, 0, 100, 0},
    {0x00cc, F::cintiq_21ux2, "Cintiq 21UX2", 87200, 65600, 2047, 63, 200, 400},
    {0x00ce, F::dtu, "DTU2231", 47864, 27011, 511, 0, 100, 0},
    {0x00d0, F::touch_only, "Bamboo Touch", 0, 0, 0, 0, 0, 0},
    {0x00d1, F::bamboo, "Bamboo Pen & Touch 4x5", 14720, 9200, 1023, 31, 100, 0},
    {0x00d2, F::bamboo, "Bamboo Craft", 14720, 9200, 1023, 31, 100, 0},
    {0x00d3, F::bamboo, "Bamboo Pen & Touch 6x8", 21648, 13700, 1023, 31, 100, 0},
    {0x00d4, F::bamboo, "Bamboo Pen", 14720, 9200, 1023, 31, 100, 0},
    {0x00d5, F::bamboo, "Bamboo Pen 6x8", 21648, 13700, 1023, 31, 100, 0},
    {0x00d6, F::bamboo, "Bamboo Pen & Touch 4x5", 14720, 9200, 1023, 31, 100, 0},
    {0x00d7, F::bamboo, "Bamboo Pen & Touch Small", 14720, 9200, 1023, 31, 100, 0},
    {0x00d8, F::bamboo, "Bamboo Comic", 21648, 13700, 1023, 31, 100, 0},
    {0x00da, F::bamboo, "Bamboo Pen & Touch 4x5 SE", 14720, 9200, 1023, 31, 100, 0},
    {0x00db, F::bamboo, "Bamboo Pen & Touch 6x8 SE", 21648, 13700, 1023, 31, 100, 0},
    {0x00dd, F::bamboo, "Bamboo Connect", 14720, 9200, 1023, 31, 100, 0},
    {0x00de, F::bamboo, "Bamboo Capture", 14720, 9200, 1023, 31, 100, 0},
    {0x00df, F::bamboo, "Bamboo Create", 21648, 13700, 1023, 31, 100, 0},
    {0x00e2, F::tablet_pc, "ISDv4 E2", 26202, 16325, 255, 0, 100, 0},
    {0x00e3, F::tablet_pc, "ISDv4 E3", 26202, 16325, 255, 0, 100, 0},
    {0x00e5, F::tablet_pc, "ISDv4 E5", 26202, 16325, 255, 0, 100, 0},
    {0x00e6, F::tablet_pc, "ISDv4 E6", 27760, 15694, 255, 0, 100, 0},
    {0x00ec, F::tablet_pc, "ISDv4 EC", 25710, 14500, 255, 0, 100, 0},
    {0x00ed, F::tablet_pc, "ISDv4 ED", 26202, 16325, 255, 0, 100, 0},
    {0x00ef, F::tablet_pc, "ISDv4 EF", 26202, 16325, 255, 0, 100, 0},
    {0x00f0, F::dtu, "DTU1631", 34623, 19553, 511, 0, 100, 0},
    {0x00f4, F::cintiq_hd, "Cintiq 24HD", 104480, 65600, 2047, 63, 200, 400},
    {0x00f6, F::touch_only, "Cintiq 24HD touch", 0, 0, 0, 0, 0, 0},
    {0x00f8, F::cintiq_hd, "Cintiq 24HD touch", 104480, 65600, 2047, 63, 200, 400},
    {0x00fa, F::cintiq_hd, "Cintiq 22HD", 95840, 54260, 2047, 63, 200, 400},
    {0x00fb, F::dtus, "DTU1031", 22096, 13960, 511, 0, 100, 200},
    {0x0100, F::tablet_pc, "ISDv4 100", 26202, 16325, 255, 0, 100, 0},
    {0x0101, F::tablet_pc, "ISDv4 101", 26202, 16325, 255, 0, 100, 0},
    {0x010d, F::tablet_pc, "ISDv4 10D", 26202, 16325, 255, 0, 100, 0},
    {0x010e, F::tablet_pc, "ISDv4 10E", 27760, 15694, 255, 0, 100, 0},
    {0x010f, F::tablet_pc, "ISDv4 10F", 27760, 15694, 255, 0, 100, 0},
    {0x0116, F::tablet_pc, "ISDv4 116", 26202, 16325, 255, 0, 100, 0},
    {0x012c, F::tablet_pc, "ISDv4 12C", 27848, 15752, 2047, 0, 100, 0},
    {0x0300, F::bamboo, "Bamboo One S", 14720, 9225, 1023, 31, 100, 0},
    {0x0301, F::bamboo, "Bamboo One M", 21648, 13530, 1023, 31, 100, 0},
    {0x0302, F::bamboo, "Intuos PT S", 15200, 9500, 1023, 31, 100, 0},
    {0x0303, F::bamboo, "Intuos PT M", 21600, 13500, 1023, 31, 100, 0},
    {0x0304, F::cintiq_hd, "Cintiq 13HD", 59552, 33848, 1023, 63, 200, 400},
    {0x0307, F::cintiq_hd, "Cintiq Companion Hybrid", 59552, 33848, 2047, 63, 200, 400},
    {0x0309, F::touch_only, "Cintiq Companion Hybrid touch", 0, 0, 0, 0, 0, 0},
    {0x030a, F::cintiq_hd, "Cintiq Companion Hybrid", 59552, 33848, 2047, 63, 200, 400},
    {0x030c, F::touch_only, "Cintiq Companion Hybrid touch", 0, 0, 0, 0, 0, 0},
    {0x030e, F::bamboo, "Intuos S", 15200, 9500, 1023, 31, 100, 0},
    {0x0314, F::intuos5, "Intuos Pro S", 31496, 19685, 2047, 63, 200, 0},
    {0x0315, F::intuos5, "Intuos Pro M", 44704, 27940, 2047, 63, 200, 0},
    {0x0317, F::intuos5_large, "Intuos Pro L", 65024, 40640, 2047, 63, 200, 0},
    {0x0323, F::bamboo, "Intuos P M", 21600, 13500, 1023, 31, 100, 0},
    {0x0325, F::cintiq_hd, "Cintiq Companion 2", 59552, 33848, 2047, 63, 200, 400},
    {0x032a, F::cintiq_hd, "Cintiq 27QHD", 120140, 67920, 2047, 63, 200, 400},
    {0x032b, F::cintiq_hd, "Cintiq 27QHD touch", 120140, 67920, 2047, 63, 200, 400},
    {0x032c, F::touch_only, "Cintiq 27QHD touch", 0, 0, 0, 0, 0, 0},
    {0x032f, F::dtus, "DTU1031X", 22672, 12928, 511, 0, 100, 200},
    {0x0331, F::touch_only, "ExpressKey Remote", 0, 0, 0, 0, 0, 0},
    {0x0333, F::cintiq_hd, "Cintiq 13HD touch", 59552, 33848, 2047, 63, 200, 400},
    {0x0335, F::touch_only, "Cintiq 13HD touch", 0, 0, 0, 0, 0, 0},
    {0x0336, F::dtus, "DTU1141", 23672, 13403, 1023, 0, 100, 200},
    {0x033b, F::intuos_2015, "Intuos S 2", 15200, 9500, 2047, 63, 100, 0},
    {0x033c, F::intuos_2015, "Intuos PT S 2", 15200, 9500, 2047, 63, 100, 0},
    {0x033d, F::intuos_2015, "Intuos P M 2", 21600, 13500, 2047, 63, 100, 0},
    {0x033e, F::intuos_2015, "Intuos PT M 2", 21600, 13500, 2047, 63, 100, 0},
    {0x0343, F::dtus, "DTK1651", 34816, 19759, 1023, 0, 100, 200},
    {0x0360, F::intuos_pro_bluetooth, "Intuos Pro M", 44800, 29600, 8191, 63, 200, 0},
    {0x0361, F::intuos_pro_bluetooth, "Intuos Pro L", 62200, 43200, 8191, 63, 200, 0},
    {0x0377, F::intuos_2018_bluetooth, "Intuos BT S", 15200, 9500, 4095, 63, 100, 0},
    {0x0379, F::intuos_2018_bluetooth, "Intuos BT M", 21600, 13500, 4095, 63, 100, 0},
    {0x037a, F::bamboo, "One by Wacom S", 15200, 9500, 2047, 63, 100, 0},
    {0x037b, F::bamboo, "One by Wacom M", 21600, 13500, 2047, 63, 100, 0},
    {0x0393, F::intuos_pro_bluetooth, "Intuos Pro S", 31920, 19950, 8191, 63, 200, 0},
    {0x03c6, F::intuos_2018_bluetooth, "Intuos BT S", 15200, 9500, 4095, 63, 100, 0},
    {0x03c8, F::intuos_2018_bluetooth, "Intuos BT M", 21600, 13500, 4095, 63, 100, 0},
    {0x03dd, F::intuos_pro_bluetooth, "Intuos Pro S", 31920, 19950, 8191, 63, 200, 0},
    {0x4001, F::tablet_pc, "ISDv4 4001", 26202, 16325, 255, 0, 100, 0},
    {0x4004, F::tablet_pc, "ISDv4 4004", 11060, 6220, 255, 0, 100, 0},
    {0x5000, F::tablet_pc, "ISDv4 5000", 27848, 15752, 1023, 0, 100, 0},
    {0x5002, F::tablet_pc, "ISDv4 5002", 29576, 16724, 1023, 0, 100, 0},
    {0x6004, F::tablet_pc, "ISD-V4", 12800, 8000, 255, 0, 100, 0},
};
// clang-format on

constexpr std::uint16_t k_lenovo_isdv4 = 0x6004;

bool is_bluetooth_only(WacomFamily family) {
  return family == F::graphire_bluetooth || family == F::intuos4_bluetooth || family == F::intuos_pro_bluetooth ||
         family == F::intuos_2018_bluetooth;
}

}  // namespace

std::span<const WacomModel> wacom_models() { return k_models; }

const WacomModel* find_wacom_model(std::uint16_t bus, std::uint16_t vendor, std::uint16_t product) {
  const bool lenovo = vendor == k_vendor_lenovo && product == k_lenovo_isdv4;
  if (vendor != k_vendor_wacom && !lenovo) return nullptr;
  const auto end = std::end(k_models);
  const auto* const found = std::lower_bound(
      std::begin(k_models), end, product, [](const WacomModel& model, std::uint16_t id) { return model.product < id; });
  if (found == end || found->product != product) return nullptr;
  // Product ids on other buses (I2C) are numbered independently of these.
  const std::uint16_t wanted = is_bluetooth_only(found->family) ? k_bus_bluetooth : k_bus_usb;
  if (bus != wanted || (product == k_lenovo_isdv4) != lenovo) return nullptr;
  return found;
}

}  // namespace penpose::decode
