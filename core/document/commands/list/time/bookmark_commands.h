#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands of bookmarks: moments of the shown timeline that have a name.

namespace penpose::document {

/// Sets a bookmark at a moment, in place of one that is there. Errors: a moment off the timeline, a name of more than
/// 200 bytes, no such colour, too many bookmarks.
struct SetBookmark {
  static constexpr Called k_called{"set_bookmark", "Set a bookmark"};
  double time_s = 0;
  std::string name;
  std::uint32_t color = 0;
  static auto members(auto& self) { return base::named("time_s", self.time_s, "name", self.name, "color", self.color); }
};
Changed run(const Document&, const SetBookmark&, ApplyParts&);

/// Moves a bookmark to another moment, in place of one that is there. Errors: there is none at `time_s`, a moment off
/// the timeline.
struct MoveBookmark {
  static constexpr Called k_called{"move_bookmark", "Move a bookmark"};
  double time_s = 0;
  double to_s = 0;
  static auto members(auto& self) { return base::named("time_s", self.time_s, "to_s", self.to_s); }
};
Changed run(const Document&, const MoveBookmark&, ApplyParts&);

/// Errors: there is no bookmark at that moment.
using DeleteBookmark = Plain<AtTime, "delete_bookmark", "Delete a bookmark">;
Changed run(const Document&, const DeleteBookmark&, ApplyParts&);

using BookmarkCommands = std::variant<SetBookmark, MoveBookmark, DeleteBookmark>;

}  // namespace penpose::document
