#include "tests/judges/drawing/faces/artist.h"

#include <array>

#include "tests/judges/drawing/hands/held_out/held_out_artists.h"
#include "tests/judges/drawing/hands/seen/seen_artists.h"

namespace penpose::judges::drawn {

std::span<const GroupedArtist> all_artists() {
  static const std::array<GroupedArtist, 6> k_artists{{{cartoonist(), Group::seen},
                                                       {felt_pen(), Group::seen},
                                                       {sketcher(), Group::seen},
                                                       {paper_cutter(), Group::seen},
                                                       {storyteller(), Group::held_out},
                                                       {passer_by(), Group::held_out}}};
  return k_artists;
}

std::vector<Artist> artists_for(Group group) {
  std::vector<Artist> out;
  for (const GroupedArtist& one : all_artists()) {
    if (group == Group::shared || group == one.group) out.push_back(one.artist);
  }
  return out;
}

portrait::Drawing drawn_face(const Artist& artist, Expression expression, std::optional<Side> side,
                             std::uint64_t seed) {
  Sheet sheet(artist.stroke, seed);
  const double strength = sheet.about(1, 0.2);
  artist.draw(sheet, mood_of(expression, side, strength));
  const double size = sheet.about(0.7, 0.6);
  const PxPoint corner{sheet.random()(0, 200), sheet.random()(0, 200)};
  portrait::Drawing drawing{sheet.lines()};
  for (auto& line : drawing.lines) {
    for (PxPoint& p : line) p = corner + p * size;
  }
  return drawing;
}

}  // namespace penpose::judges::drawn
