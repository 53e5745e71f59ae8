#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/seen/seen_artists.h"

namespace penpose::judges::drawn {
namespace {

/// A round head on the sheet's middle, high eyes close together, a nose that hangs like a drop.
void draw_cartoonist(Sheet& sheet, const Mood& mood) {
  const double apart = sheet.about(70, 0.08), eyes = sheet.about(300, 0.03), lips = sheet.about(560, 0.02);
  sheet.loop({{400, 60}, {620, 150}, {680, 380}, {590, 620}, {400, 720}, {210, 620}, {120, 380}, {180, 150}});
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const double x = 400 + k_way[s] * apart;
    sheet.line({{400 + k_way[s] * 284, 340}, {400 + k_way[s] * 330, 350}, {400 + k_way[s] * 280, 440}});
    oval_eye(sheet, {{x, eyes}, sheet.about(48, 0.1), sheet.about(62, 0.1)}, mood.lid[s], false);
    brow(sheet, {{x + k_way[s] * 6, eyes - 105}, 52, 38}, mood, s, 8);
  }
  sheet.line({{392, 360}, {366, 440}, {400, 466}, {434, 440}});
  one_line_mouth(sheet, {{400, lips}, sheet.about(120, 0.1), sheet.about(52, 0.1)}, mood);
}

}  // namespace

Artist cartoonist() { return {"cartoonist", {.hand = {.name = "", .tremor_px = 1, .ends = 0.02}}, draw_cartoonist}; }

}  // namespace penpose::judges::drawn
