#pragma once

#include <string>
#include <variant>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/view/reference_picture.h"

// Commands of the picture or film that one animates after.

namespace penpose::document {

/// Puts a reference behind the model or beside it, in place of one that is there. Errors: no name of a file, a number
/// out of its range (reference_picture.h).
struct SetReference {
  static constexpr Called k_called{"set_reference", "Place a reference"};
  ReferencePicture picture;
  static auto members(auto& self) {
    auto& one = self.picture;
    return base::named("file", one.file, "content", one.content, "offset_s", one.offset_s, "opacity", one.opacity,
                       "beside", one.beside, "middle", one.middle, "height", one.height, "card", one.card,
                       "card_height", one.card_height);
  }
};
Changed run(const Document&, const SetReference&, ApplyParts&);

/// Errors: there is none.
using RemoveReference = Plain<NoMembers, "remove_reference", "Take the reference away">;
Changed run(const Document&, const RemoveReference&, ApplyParts&);

using ReferenceCommands = std::variant<SetReference, RemoveReference>;

}  // namespace penpose::document
