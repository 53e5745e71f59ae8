#pragma once

#include <cstdint>

namespace penpose::app {

/// How loud a button is. A panel or a dialog has one that is primary: what is to be done now.
enum class ButtonWeight : std::uint8_t {
  quiet,     ///< without a ground until the pen is over it: locks, resets, what stands in rows
  ordinary,  ///< on a ground
  primary,   ///< on the accent
};

}  // namespace penpose::app
