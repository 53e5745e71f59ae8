#pragma once

#include <string>

#include "core/base/state_hash.h"

namespace penpose::document {

/// The sound that a timeline goes with. The document knows of it where it lies and which it is; whoever plays it has
/// its samples.
struct SoundReference {
  std::string file;       ///< relative to the project where it lies beside or below it
  base::Hash128 content;  ///< of the bytes of the file, base::hash_bytes
  double offset_s = 0;    ///< the moment of the timeline at which it begins, -k_latest_key_s..k_latest_key_s
  friend bool operator==(const SoundReference&, const SoundReference&) = default;
};

/// The longest path, bytes.
inline constexpr std::size_t k_longest_sound_path = 4096;

}  // namespace penpose::document
