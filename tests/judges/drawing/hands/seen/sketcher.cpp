#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/seen/seen_artists.h"

namespace penpose::judges::drawn {
namespace {

/// A woman near to life: lids and irises, lips of three lines, a long fringe, neck and shoulders; strokes go past their
/// ends, and half of them are drawn twice.
void draw_sketcher(Sheet& sheet, const Mood& mood) {
  const double apart = sheet.about(92, 0.05);
  const double chin = 700 + 40 * mood.open;
  sheet.line({{208, 330}, {220, 480}, {290, 630}, {400, chin}, {510, 630}, {580, 480}, {592, 330}});
  sheet.line({{190, 420}, {150, 240}, {260, 70}, {400, 30}, {540, 70}, {650, 240}, {610, 420}});
  sheet.line({{230, 300}, {300, 190}, {430, 150}, {560, 300}});
  sheet.line({{330, 660}, {325, 760}, {220, 810}});
  sheet.line({{470, 660}, {475, 760}, {580, 810}});
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const double x = 400 + k_way[s] * apart;
    lidded_eye(sheet, {{x, 365}, sheet.about(50, 0.05), sheet.about(22, 0.1)}, mood.lid[s], k_way[s]);
    brow(sheet, {{x + k_way[s] * 6, 300}, 58, 26}, mood, s, 14);
  }
  sheet.line({{412, 400}, {388, 490}, {380, 506}, {402, 516}, {424, 506}});
  lipped_mouth(sheet, {{400, 590}, sheet.about(74, 0.06), sheet.about(30, 0.1)}, mood);
}

}  // namespace

Artist sketcher() {
  return {"sketcher",
          {.hand = {.name = "", .tremor_px = 1.5, .ends = 0.06}, .doubled = 0.5, .in_pieces = 0.2},
          draw_sketcher};
}

}  // namespace penpose::judges::drawn
