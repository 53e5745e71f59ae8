#pragma once

#include <string>
#include <vector>

#include "ui/app/controls/control_parts.h"
#include "ui/app/controls/controls.h"
#include "ui/app/playback/keys.h"

namespace penpose::app {

/// Some controls, and what they are called together.
struct MeantControls {
  std::vector<std::string> names;  ///< empty: none are meant
  std::string words;
};

/// Finds the controls that are selected: those with selected keys, else the sketched one that is shown, else those that
/// the last line moved.
[[nodiscard]] MeantControls meant_controls(EditingSession& editing, Keys& keys, const Controls& controls);

/// Finds the controls of a part of the face: "the mouth".
[[nodiscard]] MeantControls controls_of_part(EditingSession& editing, ControlParts& parts, FacePart part);
/// The part's words: "the brows"; empty: of all.
[[nodiscard]] std::string words_of_part(FacePart part);

}  // namespace penpose::app
