#pragma once

#include <cstdint>
#include <string_view>

#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::app {

/// Which pens and fingers report places of the unturned panel, where the picture is turned for one that is mounted
/// turned: fingers and the pens that are built in; fingers and all pens, such as a pen display's; none, where the
/// system turns them itself.
enum class TurnedInput : std::uint8_t { built_in, all, none };
/// Of `built-in`, `all` and `none`; anything else is built in.
[[nodiscard]] inline TurnedInput turned_input(std::string_view name) {
  return name == "all" ? TurnedInput::all : name == "none" ? TurnedInput::none : TurnedInput::built_in;
}

/// Whether a device is part of the machine as far as its bus tells: on I2C, SPI or a serial line. Built-in devices on
/// USB cannot be told from others.
[[nodiscard]] inline bool is_built_in(const decode::DeviceIdentity& device) {
  return device.bus != decode::k_bus_usb && device.bus != decode::k_bus_bluetooth &&
         device.bus != decode::k_bus_virtual;
}

/// How the panel is mounted.
struct PanelTurn {
  int degrees = 0;  ///< clockwise, by which the picture is turned: 0, 90, 180, 270
  TurnedInput input = TurnedInput::built_in;

  /// Quarter turns clockwise by which a pen's tablet is turned as one sees the picture: against those of the picture.
  [[nodiscard]] std::uint32_t quarter_turns_of(const decode::DeviceIdentity& pen) const {
    const bool turned = input == TurnedInput::all || (input == TurnedInput::built_in && is_built_in(pen));
    return turned ? static_cast<std::uint32_t>(4 - degrees / 90) % 4 : 0;
  }
};

}  // namespace penpose::app
