#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pad_sample.h"

namespace penpose::decode {

/// Which light is on at each side, from 0, as PadSample::mode has it.
using Lights = std::array<std::int8_t, k_pad_sides>;

/// The feature report that makes a tablet show these lights; nothing where it switches them by itself (ExpressKey
/// Remote), has none, or does not declare such a report. The interface is that of its keys, which behind a wireless
/// receiver is the receiver's second one, whatever it declares. Source: Linux, wacom_sys.c
/// (wacom_led_control), with the brightness that its driver begins with.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> light_report(const DeviceIdentity& identity,
                                                                    const Lights& lights);

/// The only byte of that report that says which light is on, where what the others say is the tablet's own affair: they
/// have to be asked for first. Nothing where all are ours.
[[nodiscard]] std::optional<std::size_t> only_light_byte(const DeviceIdentity& identity);

/// The side at which Linux's group of lights is: of two groups its first one is at the right.
[[nodiscard]] std::size_t side_of_light_group(const DeviceIdentity& identity, std::size_t group);

}  // namespace penpose::decode
