#include "ui/film/film_kind.h"

#include <algorithm>
#include <array>

#include "core/base/text/letters.h"

namespace penpose::film {
namespace {

constexpr std::array k_kinds{
    FilmKindRow{FilmKind::mp4, "Film (.mp4)", ".mp4", "H.264 with sound; plays anywhere", true, true},
    FilmKindRow{FilmKind::webm, "Film (.webm)", ".webm", "VP9 with sound; plays in browsers", true, true},
    FilmKindRow{FilmKind::gif, "GIF (.gif)", ".gif", "Plays in any page and message, without sound", false, true},
    FilmKindRow{FilmKind::pictures, "Pictures (.png)", ".png", "One file a frame, for other programs", false, false},
    FilmKindRow{FilmKind::sheet, "Sheet (.png)", ".png", "One picture with many frames and their numbers", false,
                false},
};

}  // namespace

std::span<const FilmKindRow> film_kinds() { return k_kinds; }

const FilmKindRow& row_of(FilmKind kind) {
  return *std::find_if(k_kinds.begin(), k_kinds.end(), [&](const FilmKindRow& row) { return row.kind == kind; });
}

std::optional<FilmKind> kind_of_name(std::string_view path) {
  const std::string name = base::lower_case(std::string(path));
  for (const FilmKindRow& row : k_kinds) {
    if (name.ends_with(row.extension)) return row.kind;
  }
  return std::nullopt;
}

}  // namespace penpose::film
