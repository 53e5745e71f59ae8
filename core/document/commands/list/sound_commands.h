#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/sound/mouths.h"
#include "core/document/sound/sound_reference.h"

// Commands of the sound and of the mouths that speak it.

namespace penpose::document {

/// Lays a sound beside the timeline, in place of one that is there. Errors: no name of a file, an offset beyond the
/// timeline.
struct SetSound {
  static constexpr Called k_called{"set_sound", "Lay a sound beside"};
  std::string file;
  base::Hash128 content;
  double offset_s = 0;
  static auto members(auto& self) {
    return base::named("file", self.file, "content", self.content, "offset_s", self.offset_s);
  }
};
Changed run(const Document&, const SetSound&, ApplyParts&);

/// Errors: there is no sound.
using RemoveSound = Plain<NoMembers, "remove_sound", "Take the sound away">;
Changed run(const Document&, const RemoveSound&, ApplyParts&);

/// Lets the sound begin at another moment of the timeline; a negative one cuts its beginning. Errors: there is no
/// sound, an offset beyond the timeline.
struct MoveSound {
  static constexpr Called k_called{"move_sound", "Move the sound"};
  double offset_s = 0;
  static auto members(auto& self) { return base::named("offset_s", self.offset_s); }
};
Changed run(const Document&, const MoveSound&, ApplyParts&);

/// Keeps a mouth under a name, in place of one of that name: then the keys that KeyMouths made of it follow, where they
/// are as it made them. Errors: no name, no such parameter or one named twice, a value out of range, too many mouths.
struct SetMouth {
  static constexpr Called k_called{"set_mouth", "Keep a mouth"};
  std::string name;
  std::vector<NamedValue> values;
  static auto members(auto& self) { return base::named("name", self.name, "values", self.values); }
};
Changed run(const Document&, const SetMouth&, ApplyParts&);

/// Forgets a mouth; keys that were made of it stay. Errors: no such mouth.
using DeleteMouth = Plain<OfName, "delete_mouth", "Delete a mouth">;
Changed run(const Document&, const DeleteMouth&, ApplyParts&);

/// Keys mouths at moments as KeyPoses does, with the controls that these mouths move and no others. Which mouth is
/// where is remembered in place of what was before (Document::spoken). Errors: no such mouth, moments that do not
/// ascend, another number of mouths, mouths that move nothing.
struct KeyMouths {
  static constexpr Called k_called{"key_mouths", "Let it speak"};
  std::vector<double> times_s;
  std::vector<std::string> mouths;  ///< one a moment
  static auto members(auto& self) { return base::named("times_s", self.times_s, "mouths", self.mouths); }
};
Changed run(const Document&, const KeyMouths&, ApplyParts&);

/// Remembers which words are said in the sound, and when, in place of those that were known. No words: they are not
/// known. Errors: there is no sound, moments before it or that do not ascend, another number of words, a word of no or
/// more than 200 bytes.
struct SetWords {
  static constexpr Called k_called{"set_words", "Take down the words"};
  std::vector<double> times_s;  ///< of the sound, each that of the beginning of a word
  std::vector<std::string> words;
  static auto members(auto& self) { return base::named("times_s", self.times_s, "words", self.words); }
};
Changed run(const Document&, const SetWords&, ApplyParts&);

using SoundCommands = std::variant<SetSound, RemoveSound, MoveSound, SetMouth, DeleteMouth, KeyMouths, SetWords>;

}  // namespace penpose::document
