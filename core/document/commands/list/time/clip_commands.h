#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands of clips: timelines of one document beside each other, one of which is shown.

namespace penpose::document {

/// Opens an animation of the model as a clip and shows it. The timeline that was shown is a clip then, if it has keys.
/// Errors: no such animation, one that is open already, those of keys_of, too many clips.
struct OpenClip {
  static constexpr Called k_called{"open_clip", "Open an animation"};
  std::uint32_t animation = 0;  ///< of the model, from 0
  static auto members(auto& self) { return base::named("animation", self.animation); }
};
Changed run(const Document&, const OpenClip&, ApplyParts&);

/// Shows another clip, and the pose that it has at the present moment. Errors: no such clip.
struct ShowClip {
  static constexpr Called k_called{"show_clip", "Show a clip"};
  std::uint32_t clip = 0;  ///< from 0
  static auto members(auto& self) { return base::named("clip", self.clip); }
};
Changed run(const Document&, const ShowClip&, ApplyParts&);

/// Adds a clip behind the shown one and shows it: an empty one, or one with the same keys. Errors: no name or one that
/// another clip or animation has, too many clips.
struct AddClip {
  static constexpr Called k_called{"add_clip", "Add a clip"};
  std::string name;
  bool copies = false;  ///< the keys of the clip that is shown
  static auto members(auto& self) { return base::named("name", self.name, "copies", self.copies); }
};
Changed run(const Document&, const AddClip&, ApplyParts&);

/// Calls the shown clip otherwise. Errors: as AddClip.
using NameClip = Plain<OfName, "name_clip", "Name a clip">;
Changed run(const Document&, const NameClip&, ApplyParts&);

/// Takes the shown clip away, with its animation of the model, and shows the one before. Errors: there is one clip
/// only.
using DeleteClip = Plain<NoMembers, "delete_clip", "Delete a clip">;
Changed run(const Document&, const DeleteClip&, ApplyParts&);

/// Cuts the shown clip to a span of time and lets it begin at 0; its curves stay as they are. Errors: no span, moments
/// off the timeline.
struct TrimClip {
  static constexpr Called k_called{"trim_clip", "Trim a clip"};
  double from_s = 0;
  double to_s = 0;
  static auto members(auto& self) { return base::named("from_s", self.from_s, "to_s", self.to_s); }
};
Changed run(const Document&, const TrimClip&, ApplyParts&);

using ClipCommands = std::variant<OpenClip, ShowClip, AddClip, NameClip, DeleteClip, TrimClip>;

}  // namespace penpose::document
