#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/camera.h"
#include "replay/session/by_today/redrawn_session.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/hands/binding.h"
#include "ui/app/key_stroke.h"
#include "ui/app/view/area.h"

// What dialogs keep that others fill or look at.

namespace penpose::app {

/// A number being typed for a parameter.
struct NumberEntry {
  enum class Field : std::uint8_t { value, least, most };
  std::string parameter;
  std::string text;
  Field field = Field::value;
};

/// A name being typed for the key at the timeline's cursor.
struct KeyNameEntry {
  std::string text;
};

/// In the search, and in the list of shortcuts.
struct SearchEntry {
  std::string text;
  std::size_t chosen = 0;  ///< of what was found
};

/// A dialog that waits for a key, whichever it is: `Interface` gives it that in place of what it does else.
struct KeyAsked {
  bool waits = false;
  KeyStroke pressed;  ///< a key of 0: none yet
  int held = -1;      ///< the scancode of the key that was given, until it is let go: it types nothing
};

/// Whose keys are shown, and which of them something is chosen for.
struct PadChoice {
  std::pair<std::string, std::string> tablet;  ///< by key and unit; empty: the first
  PadControl control;
  float height = 0;   ///< px of the picture of its keys in the last frame
  bool once = false;  ///< actions are offered, else what holds while a key is held
};

/// What was drawn in the test area of the tablet's settings.
struct PenTrial {
  std::vector<PxPoint> line;
  std::vector<double> pressure;
  Area area{};
};

/// Adds to the line in the test area, where the dialog is open.
void try_pen(Dialogs& dialogs, PxPoint at, double pressure, bool begins);

/// What waits for the answer to the question about unsaved work.
struct UnsavedWork {
  std::string then_opens;    ///< empty: the program ends
  bool saves_first = false;  ///< that was the answer: it is done once something was saved
};

/// A session of an older edition that waits for the answer whether it is to be drawn again.
struct OlderSession {
  std::string path;
  std::uint32_t edition = 0;
};

/// How one came out.
struct DrawnAgain {
  std::string name;
  replay::RedrawnSession redrawn;
};

}  // namespace penpose::app
