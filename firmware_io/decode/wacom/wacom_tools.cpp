#include "firmware_io/decode/wacom/wacom_tools.h"

namespace penpose::decode {

// Numbers of the Linux wacom driver's table of tools.
WacomTool wacom_tool(std::uint32_t number) {
  switch (number) {
    case 0x007:  // Intuos and Intuos2 2D and 4D mice
    case 0x094:
    case 0x09c:
    case 0x017:  // Intuos3 mouse
    case 0x806:  // Intuos4 mouse
      return WacomTool::mouse;
    case 0x096:  // Intuos and Intuos2 lens cursor
    case 0x097:  // Intuos3 lens cursor
    case 0x006:  // Intuos4 lens cursor
      return WacomTool::lens;
    case 0x112:  // Intuos and Intuos2 airbrushes
    case 0x912:
    case 0xd12:
    case 0x913:    // Intuos3 airbrush
    case 0x902:    // Intuos4 airbrush
    case 0x10902:  // the same on later tablets
      return WacomTool::airbrush;
    default:
      return (number & 0x8) != 0 ? WacomTool::eraser : WacomTool::pen;
  }
}

bool is_art_pen(std::uint32_t number) {
  switch (number) {
    case 0x204:    // Art Pen 2
    case 0x804:    // Intuos4
    case 0x885:    // Intuos3
    case 0x10804:  // the one of Intuos4 on later tablets
      return true;
    default:
      return false;
  }
}

Tool tool_of(WacomTool tool) {
  switch (tool) {
    case WacomTool::none:
      return Tool::none;
    case WacomTool::pen:
    case WacomTool::airbrush:
      return Tool::pen;
    case WacomTool::eraser:
      return Tool::eraser;
    case WacomTool::mouse:
    case WacomTool::lens:
      return Tool::mouse;
  }
  return Tool::none;
}

}  // namespace penpose::decode
