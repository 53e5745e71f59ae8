#pragma once

#include <span>

#include "tests/judges/drawing/faces/mood.h"
#include "tests/judges/drawing/faces/sheet.h"
#include "tests/judges/rigs/rig.h"

namespace penpose::judges::drawn {

/// Somebody who draws faces: with conventions of his own for each feature, and with a pen that moves in its own way.
struct Artist {
  const char* name;
  Stroke stroke;
  void (*draw)(Sheet& sheet, const Mood& mood);
};

struct GroupedArtist {
  Artist artist;
  Group group;
};
/// Those of hands/seen, then those of hands/held_out, which nobody may set anything by.
[[nodiscard]] std::span<const GroupedArtist> all_artists();
/// Those that draw on rigs of a group: of the same group, and all of them on shared rigs.
[[nodiscard]] std::vector<Artist> artists_for(Group group);

/// A face on a sheet of any size, somewhere on it. The same seed gives the same lines.
[[nodiscard]] portrait::Drawing drawn_face(const Artist& artist, Expression expression, std::optional<Side> side,
                                           std::uint64_t seed);

}  // namespace penpose::judges::drawn
