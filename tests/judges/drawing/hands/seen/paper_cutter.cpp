#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/seen/seen_artists.h"

namespace penpose::judges::drawn {
namespace {

/// A badge: a circle, large round eyes that laugh as roofs, a mouth of a closed shape, no nose.
void draw_paper_cutter(Sheet& sheet, const Mood& mood) {
  sheet.oval({400, 400}, 350, 350);
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const double x = 400 + k_way[s] * sheet.about(130, 0.05);
    oval_eye(sheet, {{x, 330}, sheet.about(66, 0.08), sheet.about(72, 0.08)}, mood.lid[s],
             mood.smile[0] + mood.smile[1] > 0.3);
    if (mood.brow_in[s] != 0 || mood.brow_out[s] != 0) brow(sheet, {{x, 205}, 74, 46}, mood, s, 0);
  }
  shaped_mouth(sheet, {{400, 550}, sheet.about(150, 0.08), sheet.about(56, 0.1)}, mood);
}

}  // namespace

Artist paper_cutter() {
  return {"paper_cutter", {.hand = {.name = "", .tremor_px = 0.5, .ends = 0.01}, .in_pieces = 0.15}, draw_paper_cutter};
}

}  // namespace penpose::judges::drawn
