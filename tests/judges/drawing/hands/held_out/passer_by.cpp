#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/held_out/held_out_artists.h"

namespace penpose::judges::drawn {
namespace {

/// A long crooked face by somebody in a hurry: lids, a big nose with wings, lips of two borders, hair of three strokes;
/// many lines are in pieces and stop too early.
void draw_passer_by(Sheet& sheet, const Mood& mood) {
  const double lean = sheet.random()(-25, 25), drop = 50 * mood.open;
  sheet.line({{230, 180}, {215, 420}, {270, 680}, {400 + lean, 770 + drop}, {530, 680}, {585, 420}, {570, 180}});
  sheet.line({{225, 220}, {280, 110}, {330, 90}});
  sheet.line({{300, 130}, {400, 60}, {500, 120}});
  sheet.line({{470, 90}, {560, 130}, {575, 220}});
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const PxPoint at{400 + 0.3 * lean + k_way[s] * 88, 330 + k_way[s] * 0.3 * lean};
    lidded_eye(sheet, {at, sheet.about(42, 0.1), sheet.about(24, 0.15)}, mood.lid[s], k_way[s]);
    brow(sheet, {at - PxPoint{0, 62}, 52, 30}, mood, s, 6);
    sheet.line(
        {{400 + lean + k_way[s] * 28, 490}, {400 + lean + k_way[s] * 50, 520}, {400 + lean + k_way[s] * 22, 536}});
  }
  sheet.line({{380, 340}, {372 + 0.7 * lean, 450}, {400 + lean, 545}});
  lipped_mouth(sheet, {{400 + lean, 640}, sheet.about(88, 0.1), sheet.about(36, 0.1)}, mood);
}

}  // namespace

Artist passer_by() {
  return {"passer_by",
          {.hand = {.name = "", .tremor_px = 2, .uneven = 0.5, .ends = 0.1}, .in_pieces = 0.35},
          draw_passer_by};
}

}  // namespace penpose::judges::drawn
