#pragma once

#include <string>

namespace penpose::app {

/// What the X server of the display that the environment names says of sizes.
struct XDisplaySays {
  std::string resources;  ///< that a desktop has given it (RESOURCE_MANAGER); empty: none
  double dpi = 0;         ///< its own, by px and millimetres of the whole screen; 0: it says none
};

/// Asks it, by an X library that is looked for as the program runs: nothing is linked to it. Nothing is said where
/// there is none.
[[nodiscard]] XDisplaySays ask_x_display();

}  // namespace penpose::app
