#pragma once

#include <string>

namespace penpose::app {

/// The resources that a desktop has given the X server (RESOURCE_MANAGER), of the display that the environment names.
/// Empty where there are none, or no X library, which is looked for as the program runs: nothing is linked to it.
[[nodiscard]] std::string x_resources();

}  // namespace penpose::app
