#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/held_out/held_out_artists.h"

namespace penpose::judges::drawn {
namespace {

/// Huge low eyes with heavy upper lids under a jagged fringe, a pointed chin, a nose of one tick, a tiny mouth.
void draw_storyteller(Sheet& sheet, const Mood& mood) {
  const double chin = 715 + 25 * mood.open;
  sheet.corners({{175, 330}, {200, 500}, {300, 640}, {400, chin}, {500, 640}, {600, 500}, {625, 330}});
  sheet.corners(
      {{190, 300}, {250, 150}, {290, 260}, {350, 130}, {400, 250}, {470, 130}, {510, 260}, {570, 160}, {612, 300}});
  sheet.arc({400, 330}, 250, 280, 5, 175);
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const PxPoint at{400 + k_way[s] * sheet.about(115, 0.04), 430};
    const double lid = mood.lid[s], w = sheet.about(62, 0.06), h = sheet.about(66, 0.06);
    if (lid < 0.3) {
      sheet.line({at + PxPoint{-w, 0.2 * h}, at + PxPoint{0, 0.55 * h}, at + PxPoint{w, 0.2 * h}});
    } else {
      sheet.line(
          {at + PxPoint{-w, 0}, at + PxPoint{-0.5 * w, -h * lid}, at + PxPoint{0.5 * w, -h * lid}, at + PxPoint{w, 0}});
      sheet.line({at + PxPoint{-0.5 * w, h}, at + PxPoint{0.5 * w, h}});
      sheet.oval(at + PxPoint{0, 0.5 * h * (1 - lid)}, 0.5 * w, 0.8 * h * (lid < 1 ? lid : 1));
    }
    brow(sheet, {{at.x, 322}, 56, 30}, mood, s, 10);
  }
  sheet.corners({{404, 520}, {394, 540}, {408, 542}});
  one_line_mouth(sheet, {{400, 610}, sheet.about(48, 0.1), sheet.about(24, 0.1)}, mood);
}

}  // namespace

Artist storyteller() {
  return {"storyteller",
          {.hand = {.name = "", .tremor_px = 0.8, .uneven = 0.4, .ends = 0.03}, .doubled = 0.1},
          draw_storyteller};
}

}  // namespace penpose::judges::drawn
