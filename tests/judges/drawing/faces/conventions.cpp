#include "tests/judges/drawing/faces/conventions.h"

#include <algorithm>

namespace penpose::judges::drawn {
namespace {

/// Corners and middles of a mouth.
struct MouthPoints {
  PxPoint right, left;  ///< of the character: at the left and at the right of the picture
  PxPoint upper, lower;
  double half_width = 0;
};

MouthPoints points_of(const Place& at, const Mood& mood, double drop) {
  MouthPoints out;
  out.half_width = at.half_width * (mood.wide < 0 ? 1 + 0.6 * mood.wide : 1 + 0.3 * mood.wide);
  const double smile = (mood.smile[0] + mood.smile[1]) / 2;
  const auto corner = [&](std::size_t s) {
    return at.middle + PxPoint{k_way[s] * out.half_width, -mood.smile[s] * at.half_height};
  };
  out.left = corner(0);
  out.right = corner(1);
  const double sag = smile * at.half_height * 0.6;
  out.upper = at.middle + PxPoint{0, sag * (mood.open > 0.05 ? 0.2 : 1.0)};
  out.lower = out.upper + PxPoint{0, mood.open * drop};
  if (mood.open > 0.05) out.lower.y += std::max(sag, 0.0);
  return out;
}

PxPoint between(PxPoint a, PxPoint b, double share) { return a + (b - a) * share; }
/// Halfway from a corner to the middle of a lip, bowed towards the lip.
PxPoint bowed(PxPoint corner, PxPoint middle, double bow) {
  return {corner.x + (middle.x - corner.x) * 0.5, corner.y + (middle.y - corner.y) * bow};
}

}  // namespace

void one_line_mouth(Sheet& sheet, const Place& at, const Mood& mood) {
  if (mood.open > 0.05) return shaped_mouth(sheet, at, mood);
  const MouthPoints m = points_of(at, mood, 0);
  sheet.line({m.right, bowed(m.right, m.upper, 0.75), m.upper, bowed(m.left, m.upper, 0.75), m.left});
}

void shaped_mouth(Sheet& sheet, const Place& at, const Mood& mood) {
  // A shut mouth of paper is as thin as the corners are high.
  const double thick = mood.open > 0.05 ? 0.0 : 0.35 * at.half_height;
  MouthPoints m = points_of(at, mood, 2.4 * at.half_height);
  m.lower.y += thick;
  if (mood.wide < -0.2 && mood.open > 0.05) {
    sheet.oval(between(m.upper, m.lower, 0.5), m.half_width, (m.lower.y - m.upper.y) / 2);
    return;
  }
  sheet.loop({m.right, bowed(m.right, m.upper, 0.8), m.upper, bowed(m.left, m.upper, 0.8), m.left,
              bowed(m.left, m.lower, 0.85), m.lower, bowed(m.right, m.lower, 0.85)});
}

void lipped_mouth(Sheet& sheet, const Place& at, const Mood& mood) {
  const MouthPoints m = points_of(at, mood, 2.0 * at.half_height);
  const double lip = 0.4 * at.half_height * (mood.wide < -0.5 ? 1.6 : 1.0);
  const PxPoint dip = m.upper - PxPoint{0, 0.7 * lip}, below = m.lower + PxPoint{0, 1.2 * lip};
  const PxPoint peak{0.22 * m.half_width, -0.3 * lip};
  sheet.line({m.right, bowed(m.right, dip, 0.75), dip + PxPoint{-peak.x, peak.y}, dip, dip + peak,
              bowed(m.left, dip, 0.75), m.left});
  sheet.line({m.right, bowed(m.right, below, 0.85), below, bowed(m.left, below, 0.85), m.left});
  sheet.line({m.right, bowed(m.right, m.upper, 0.8), m.upper, bowed(m.left, m.upper, 0.8), m.left});
  if (mood.open > 0.05)
    sheet.line({m.right, bowed(m.right, m.lower, 0.85), m.lower, bowed(m.left, m.lower, 0.85), m.left});
}

void dot_eye(Sheet& sheet, const Place& at, double lid) {
  const double w = at.half_width, h = at.half_height;
  if (lid < 0.1)
    return sheet.line(
        {at.middle + PxPoint{-1.8 * w, 0}, at.middle + PxPoint{0, 0.9 * h}, at.middle + PxPoint{1.8 * w, 0}});
  if (lid < 0.6) return sheet.line({at.middle + PxPoint{-1.5 * w, 0}, at.middle, at.middle + PxPoint{1.5 * w, 0}});
  if (lid > 1.15) sheet.oval(at.middle, 2.2 * w, 2.2 * h * lid / 1.3);
  sheet.oval(at.middle, w, h);
}

void oval_eye(Sheet& sheet, const Place& at, double lid, bool smiles) {
  const double w = at.half_width, h = at.half_height;
  if (lid < 0.1 || (smiles && lid < 0.6)) {
    const double bow = smiles ? -0.6 * h : 0.35 * h;
    return sheet.line({at.middle + PxPoint{-w, 0}, at.middle + PxPoint{0, bow}, at.middle + PxPoint{w, 0}});
  }
  if (lid < 0.9) {
    // The upper lid is a straight cut through the oval, as high as the eye is still open.
    const double cut = h * (1 - 2 * lid);
    const PxPoint right = at.middle + PxPoint{-0.95 * w, cut}, left = at.middle + PxPoint{0.95 * w, cut};
    sheet.loop({right, between(right, left, 0.5), left, at.middle + PxPoint{0.6 * w, 0.75 * h},
                at.middle + PxPoint{0, h}, at.middle + PxPoint{-0.6 * w, 0.75 * h}});
    sheet.oval(at.middle + PxPoint{0, 0.5 * (h + cut)}, 0.3 * w, std::min(0.3 * h, 0.4 * (h - cut)));
    return;
  }
  sheet.oval(at.middle, w * (lid > 1 ? 0.5 + 0.5 * lid : 1), h * lid);
  sheet.oval(at.middle, 0.32 * w, 0.32 * h);
}

void lidded_eye(Sheet& sheet, const Place& at, double lid, double outwards) {
  const double w = at.half_width, h = at.half_height;
  const PxPoint inner = at.middle + PxPoint{-outwards * w, 0.25 * h}, outer = at.middle + PxPoint{outwards * w, 0};
  const double top = 0.5 * h - 1.5 * h * lid;
  if (lid < 0.1) {
    sheet.line({inner, at.middle + PxPoint{0, 0.7 * h}, outer});
    sheet.line({outer, outer + PxPoint{outwards * 0.25 * w, 0.3 * h}});
    return;
  }
  sheet.line({inner, at.middle + PxPoint{-outwards * 0.4 * w, top * 0.8}, at.middle + PxPoint{outwards * 0.2 * w, top},
              outer});
  sheet.line({inner, at.middle + PxPoint{-outwards * 0.2 * w, 0.6 * h},
              at.middle + PxPoint{outwards * 0.4 * w, 0.55 * h}, outer});
  if (lid > 0.45)
    sheet.oval(at.middle + PxPoint{0, (top + 0.5 * h) / 2}, 0.38 * w, std::min(0.7 * h, 0.5 * (0.6 * h - top)));
}

void brow(Sheet& sheet, const Place& at, const Mood& mood, std::size_t side, double arch) {
  const double way = k_way[side];
  const PxPoint inner = at.middle + PxPoint{-way * at.half_width, -mood.brow_in[side] * at.half_height};
  const PxPoint outer = at.middle + PxPoint{way * at.half_width, -mood.brow_out[side] * at.half_height};
  sheet.line({inner, between(inner, outer, 0.55) - PxPoint{0, arch}, outer});
}

}  // namespace penpose::judges::drawn
