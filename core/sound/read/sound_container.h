#pragma once

#include <optional>
#include <string_view>

#include "core/base/byte_reader.h"

namespace penpose::sound {

/// Names the container of a sound file.
struct SoundContainer {
  std::string_view name;  ///< "WAV", "MP4"
  bool is_read = false;   ///< read_sound reads it
};

/// The container of a sound; a tag of ID3 in front is passed over. Nothing: bytes do not begin like a sound.
/// Sources: RFC 9639 (FLAC), RFC 3533 (Ogg), EBU Tech 3306 (RF64), Apple's AIFF-C and CAF, ISO 11172-3 (MP3),
/// ISO 14496-12 (MP4), id3.org (ID3v2.4).
[[nodiscard]] std::optional<SoundContainer> sound_container(base::Bytes bytes);

/// The bytes behind a tag of ID3; all of them where there is none.
[[nodiscard]] base::Bytes without_id3(base::Bytes bytes);

}  // namespace penpose::sound
