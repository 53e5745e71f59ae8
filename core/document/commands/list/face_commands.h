#pragma once

#include <string>
#include <variant>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands for a face that is drawn as it should be: each line is a target at once.

namespace penpose::document {

/// Draws a line of the face as it should be. All lines of the drawing are read together: what each is, and which pose
/// they ask for. A line in a view of another side, at another time, or after the last drawing was kept as neutral
/// begins a new drawing; what was drawn before goes. On a model without features the line is a reference, or the target
/// of one that waits. A line that is read as the feature of an older one, and runs along it again, takes its place.
/// Errors: too many lines, a line without length; those of FaceReader.
using DrawFaceLine = Plain<DrawnLine, "draw_face_line", "Draw a line of the face">;
Changed run(const Document&, const DrawFaceLine&, ApplyParts&);

/// Says what a line of the face is, and reads the drawing again. Errors: no such line, no such feature; by its form: a
/// feature that the drawing's view does not see.
struct NameFaceLine {
  static constexpr Called k_called{"name_face_line", "Say what a line is"};
  CurveId curve;
  std::string feature;   ///< by name; empty: it is found again
  bool nothing = false;  ///< it is no feature of the face
  bool form = false;     ///< only its form counts: it is moved to where the feature was before the drawing
  static auto members(auto& self) {
    return base::named("curve", self.curve, "feature", self.feature, "nothing", self.nothing, "form", self.form);
  }
};
Changed run(const Document&, const NameFaceLine&, ApplyParts&);

/// The drawing shows the face at rest as this hand draws it: its proportions count for all drawings to come. The pose
/// goes back to what it was before the drawing, and its lines go. Off: it is forgotten. Errors: nothing is drawn.
struct SetNeutral {
  static constexpr Called k_called{"set_neutral", "This is my neutral face"};
  bool on = true;
  static auto members(auto& self) { return base::named("on", self.on); }
};
Changed run(const Document&, const SetNeutral&, ApplyParts&);

using FaceCommands = std::variant<DrawFaceLine, NameFaceLine, SetNeutral>;

}  // namespace penpose::document
