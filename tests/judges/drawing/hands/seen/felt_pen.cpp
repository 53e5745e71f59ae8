#include "tests/judges/drawing/faces/conventions.h"
#include "tests/judges/drawing/hands/seen/seen_artists.h"

namespace penpose::judges::drawn {
namespace {

/// As few lines as will do: brows only where they say something, and a nose on every other face.
void draw_felt_pen(Sheet& sheet, const Mood& mood) {
  const bool rounded = sheet.random()(0, 1) < 0.5, nose = sheet.random()(0, 1) < 0.6;
  if (rounded) sheet.oval({400, 400}, sheet.about(330, 0.05), sheet.about(340, 0.05));
  for (const std::size_t s : {std::size_t{0}, std::size_t{1}}) {
    const double x = 400 + k_way[s] * sheet.about(125, 0.06);
    dot_eye(sheet, {{x, 310}, 17, 22}, mood.lid[s]);
    if (mood.brow_in[s] != 0 || mood.brow_out[s] != 0) brow(sheet, {{x, 225}, 58, 42}, mood, s, 2);
  }
  if (nose) sheet.line({{405, 370}, {380, 450}, {412, 455}});
  one_line_mouth(sheet, {{400, 565}, sheet.about(135, 0.1), sheet.about(60, 0.1)}, mood);
}

}  // namespace

Artist felt_pen() { return {"felt_pen", {.hand = {.name = "", .tremor_px = 2, .ends = 0.1}}, draw_felt_pen}; }

}  // namespace penpose::judges::drawn
