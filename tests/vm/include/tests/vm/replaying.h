#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

namespace penpose::tests {

/// A quarter of what the kernel keeps of such frames, or reports, for a reader of an event device.
inline constexpr int k_at_once = 4;

/// When a device of a recording sends, and when it is unplugged.
struct Replaying {
  std::string go;    ///< sends once this file exists; empty: at once
  std::string keep;  ///< stays plugged in until this one does
  long pace_us = 1000;
  long unplug_after = -1;  ///< pulls the plug after so many; below 0: after all of them

  /// Whether the program's option is one of these.
  bool take(const std::string& name, const std::string& value) {
    if (name == "--go") {
      go = value;
    } else if (name == "--keep") {
      keep = value;
    } else if (name == "--pace-us") {
      pace_us = std::strtol(value.c_str(), nullptr, 10);
    } else if (name == "--unplug-after") {
      unplug_after = std::strtol(value.c_str(), nullptr, 10);
    } else {
      return false;
    }
    return true;
  }
};

/// Waits until the file exists; for none it does not wait.
inline void wait_for(const std::string& file) {
  while (!file.empty() && !std::filesystem::exists(file)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace penpose::tests
