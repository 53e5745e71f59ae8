#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace penpose::decode {

/// The report formats of Wacom's tablets that do not describe themselves, with the differences between their models.
enum class WacomFamily : std::uint8_t {
  penpartner,
  graphire,
  graphire4,
  graphire_bluetooth,
  bamboo_first,  ///< 2007: Graphire reports with pad keys and ring
  bamboo,        ///< 2009 and later, Intuos 2013 to 2015
  intuos_2015,   ///< CTL-490 and its like: Intuos reports without tilt
  intuos,        ///< Intuos and Intuos2: two tools at a time
  intuos3,
  intuos3_large,  ///< supports the lens cursor
  intuos4,
  intuos4_large,
  intuos4_bluetooth,  ///< several reports in one
  intuos5,            ///< and Intuos Pro of 2013
  intuos5_large,
  intuos_pro_bluetooth,
  intuos_2018_bluetooth,
  cintiq,       ///< 21UX: data are valid only with the ready bit
  cintiq_wide,  ///< 12WX, 20WSX
  cintiq_21ux2,
  cintiq_hd,  ///< all later ones, DTK, Companion
  pl,
  ptu,
  dtu,
  dtus,
  tablet_pc,
  touch_only,
};

struct WacomModel {
  std::uint16_t product;
  WacomFamily family;
  std::string_view name;
  std::int32_t max_x;
  std::int32_t max_y;
  std::int32_t max_pressure;
  std::int32_t max_distance;
  std::int32_t units_per_mm;
  std::int32_t margin;              ///< units at each edge of a display tablet that lie beyond the picture
  std::int32_t units_per_mm_y = 0;  ///< where it is another one than along x; 0: the same
};

inline constexpr std::uint16_t k_vendor_wacom = 0x056a;
inline constexpr std::uint16_t k_vendor_lenovo = 0x17ef;

/// All models, ordered by product id. Source of the figures: the device table of the Linux wacom driver.
[[nodiscard]] std::span<const WacomModel> wacom_models();

/// The model with these ids on this bus (see k_bus_usb), null if the table has none: the report descriptors of most
/// later models are sufficient.
[[nodiscard]] const WacomModel* find_wacom_model(std::uint16_t bus, std::uint16_t vendor, std::uint16_t product);

}  // namespace penpose::decode
