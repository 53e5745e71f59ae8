#pragma once

#include <memory>

#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"

// Wacom pens with fixed report layouts.

namespace penpose::decode {

/// Bamboo of 2009 and later and the consumer Intuos of 2013: reports 02 of nine or ten bytes whose bits distinguish a
/// pen that is near, one with a position and one with data. Touch comes in reports of 20 and 64 bytes with the same id.
[[nodiscard]] std::unique_ptr<PenDecoder> make_wacom_bamboo(const WacomModel& model);

/// Graphire, Volito, PenStation2 and the first Bamboos: little-endian reports of eight or nine bytes in which bits 5
/// and 6 of byte 1 distinguish pen, eraser and mouse.
[[nodiscard]] std::unique_ptr<PenDecoder> make_wacom_graphire(const WacomModel& model);

/// PenPartner: report 1 with proximity, report 2 (of the serial tablet's successors and emulated ones) always near.
[[nodiscard]] std::unique_ptr<PenDecoder> make_wacom_penpartner(const WacomModel& model);

/// Intuos Pro (2017) and Intuos (2018) over Bluetooth: reports 80 and 81 that hold up to seven or four pen frames and
/// one tool number and serial for all of them. The sample after a report is that of its last frame.
[[nodiscard]] std::unique_ptr<PenDecoder> make_wacom_bluetooth(const WacomModel& model);

}  // namespace penpose::decode
