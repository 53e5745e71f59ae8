#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/document/sound/sound_reference.h"
#include "core/sound/sound.h"

namespace penpose::files {

inline constexpr std::uint64_t k_most_sound_bytes = std::uint64_t{1} << 30;

/// A sound and how a document names it.
struct LoadedSound {
  sound::Sound sound;
  document::SoundReference reference;
  bool changed = false;  ///< it is not the one that the document was made with
};

/// Opens a sound that the user names. `project`: the project's path, beside or below whose folder the sound is named
/// relative; empty: it is named by its whole path. Errors of the file system and of read_sound.
[[nodiscard]] base::Result<LoadedSound> load_sound(const std::string& path, const std::string& project);

/// Opens the sound of a document whose project lies at a path. Only a plain file is opened. Errors: as above.
[[nodiscard]] base::Result<LoadedSound> load_sound_of(const document::SoundReference& reference,
                                                      const std::string& project);

/// How a project that is saved at `project` names a sound, of which the document of `before` (a path; empty: none)
/// knows as `file`: relative where it lies beside or below it, else by its whole path.
[[nodiscard]] std::string sound_named_from(const std::string& file, const std::string& before,
                                           const std::string& project);

}  // namespace penpose::files
