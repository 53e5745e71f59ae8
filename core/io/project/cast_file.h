#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/geometry/placement.h"

namespace penpose::io {

/// The number of the form of a cast; others are refused by it.
inline constexpr int k_cast_format = 1;
inline constexpr std::size_t k_most_characters = 32;
inline constexpr std::size_t k_longest_character_name = 100;

/// A character of a project.
struct CastMember {
  std::string name;  ///< 1 to k_longest_character_name bytes
  geometry::Placement placement;
  bool shown = true;
  std::string session{};  ///< in a note: the file that records the work on it; empty: nothing is recorded
  std::string model{};    ///< in a note: what it was opened from
};

/// The characters of a project of several.
struct Cast {
  std::size_t active = 0;                        ///< the one that is worked on
  std::vector<CastMember> members;               ///< at least two, at most k_most_characters
  std::vector<std::vector<std::uint8_t>> files;  ///< one each: binary glTF; in a note none
};

/// Whether a file is a project of several characters. Looks at its chunks alone.
[[nodiscard]] bool holds_cast(base::Bytes bytes);

/// Reads a project of several characters: the binary glTF file of the first one with another chunk behind the usual
/// two, which other programs skip. The chunk holds the length of a JSON text, the text, which fills up a multiple of 4
/// bytes, and the files of the others: {"penpose_cast": 1, "active": NUMBER, "characters": [{"name", "at": [x, y, z],
/// "turn_degrees", "scale", "shown", "bytes"}, ...]}. Errors (place: byte offset or JSON pointer): no such file,
/// another format, a member of another form, files that do not fill the chunk.
[[nodiscard]] base::Result<Cast> read_cast(base::Bytes bytes);

/// The file, which reads back as the same. Errors: more than binary glTF has room for, 4 GB. Precondition: as Cast
/// says.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_cast(const Cast& cast);

/// Reads a note of which characters are worked on, the JSON text alone, whose characters also have "session" and
/// "model". Errors (place: JSON pointer): as read_cast.
[[nodiscard]] base::Result<Cast> read_cast_note(base::Bytes bytes);
[[nodiscard]] std::string write_cast_note(const Cast& cast);

}  // namespace penpose::io
