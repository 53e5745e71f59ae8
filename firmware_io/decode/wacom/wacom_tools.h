#pragma once

#include <cstdint>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::decode {

/// The kinds of tool that Wacom's tool numbers distinguish and whose reports differ.
enum class WacomTool : std::uint8_t { none, pen, eraser, airbrush, mouse, lens };

/// The kind of a tool number as the device sends it (20 bits, the upper ones in bits 12 to 19). Mice, lenses and
/// airbrushes are known by number; of all others bit 3 marks the eraser end.
[[nodiscard]] WacomTool wacom_tool(std::uint32_t number);

/// Whether pens of this number sense their rotation about their own axis.
[[nodiscard]] bool is_art_pen(std::uint32_t number);

/// The tool of a sample: art pens and airbrushes are pens, lens cursors are mice.
[[nodiscard]] Tool tool_of(WacomTool tool);

/// The tool number as Linux and its libraries print it: the upper bits moved up by four.
[[nodiscard]] constexpr std::uint32_t wacom_tool_id(std::uint32_t number) {
  return ((number & ~0xfffu) << 4) | (number & 0xfffu);
}

}  // namespace penpose::decode
