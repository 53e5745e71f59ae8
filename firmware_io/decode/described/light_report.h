#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pad_sample.h"

namespace penpose::decode {

/// The light that is on at each side, from 0, as in PadSample::mode.
using Lights = std::array<std::int8_t, k_pad_sides>;

/// The feature report that sets a tablet's lights; nothing if it switches them itself (ExpressKey Remote), has none, or
/// does not declare such a report. The interface is the one with its keys; behind a wireless receiver that is the
/// receiver's second one, whatever it declares. Source: Linux, wacom_sys.c (wacom_led_control), with the initial
/// brightness of its driver.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> light_report(const DeviceIdentity& identity,
                                                                    const Lights& lights);

/// The only byte of that report to change, where the others belong to the tablet and must be read first. Nothing if all
/// bytes are ours.
[[nodiscard]] std::optional<std::size_t> only_light_byte(const DeviceIdentity& identity);

/// The side of Linux's group of lights: of two groups, the first is at the right.
[[nodiscard]] std::size_t side_of_light_group(const DeviceIdentity& identity, std::size_t group);

}  // namespace penpose::decode
