#pragma once

#include <cstdint>
#include <string>

namespace penpose::app {

/// What is chosen and typed for a first pass (FirstPass).
struct FirstPassEntry {
  enum class Way : std::uint8_t { text, ear, cues };
  Way way = Way::text;
  std::string text;             ///< what is said
  std::string wrapped;          ///< the same as it was last broken into lines
  std::string told;             ///< why it did not work; empty: it did, or was not tried
  std::string cannot;           ///< why this program cannot listen; empty: it can
  bool looks_for_text = false;  ///< a file is being chosen
  bool wants_sound = false;     ///< a sound is being opened for it
  bool began = false;           ///< the dialog waits for what is being listened to
};

}  // namespace penpose::app
