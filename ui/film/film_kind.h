#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace penpose::film {

/// What a film is written as.
enum class FilmKind : std::uint8_t { mp4, webm, gif, pictures, sheet };

struct FilmKindRow {
  FilmKind kind;
  std::string_view name;       ///< as the window calls it
  std::string_view extension;  ///< of its files: ".mp4"
  std::string_view detail;     ///< what it is good for
  bool sounds;                 ///< it holds sound
  bool needs_ffmpeg;
};

/// All of them, in the order in which they are offered.
[[nodiscard]] std::span<const FilmKindRow> film_kinds();
[[nodiscard]] const FilmKindRow& row_of(FilmKind kind);
/// The kind that a file's ending names, in letters of any size; .png: pictures. Nothing: another ending.
[[nodiscard]] std::optional<FilmKind> kind_of_name(std::string_view path);

}  // namespace penpose::film
