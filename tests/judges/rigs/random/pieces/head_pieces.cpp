#include "tests/judges/rigs/random/pieces/head_pieces.h"

#include <functional>

#include "core/base/math.h"
#include "tests/judges/rigs/random/landmarks.h"

namespace penpose::judges {
namespace {

using Make = std::function<std::uint32_t(const ModelPoint&)>;

/// A row of teeth as one curved band.
void add_row(Pieces& pieces, const ModelPoint& middle, double width, double tall, std::size_t columns, std::size_t rows,
             const Make& make) {
  std::vector<std::uint32_t> below;
  for (std::size_t r = 0; r < rows; ++r) {
    const double y = tall * static_cast<double>(r) / static_cast<double>(rows - 1);
    std::vector<std::uint32_t> row;
    for (std::size_t c = 0; c < columns; ++c) {
      const double turn = base::k_pi * static_cast<double>(c) / static_cast<double>(columns - 1);
      row.push_back(make(middle + ModelVector{-width * base::cos(turn), y, 1.1 * width * (base::sin(turn) - 1)}));
    }
    if (r > 0) pieces.strip(below, row);
    below = std::move(row);
  }
}

}  // namespace

void add_mouth_inside(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double w = marks.mouth_w;
  const auto& lip = parts.line("lip_lower");
  const std::uint32_t low = lip[lip.size() / 2];
  const double share = dice.real(0.7, 1);
  const double tongue_share = dice.real(0.5, 0.9);
  const std::size_t columns = dice.count(9, 100);
  const std::size_t rows = dice.count(2, 28);
  const double tall = dice.real(0.15, 0.3) * w;
  const double width = dice.real(0.55, 0.8) * w;
  const ModelPoint middle = marks.mouth - ModelVector{0, 0, dice.real(0.15, 0.35) * w};
  const bool has_tongue = dice.chance(0.7);
  pieces.begin("upper_teeth");
  add_row(pieces, middle, width, tall, columns, rows, [&](const ModelPoint& p) { return pieces.add(p, {}); });
  const Make on_jaw = [&](const ModelPoint& p) { return pieces.add_on_jaw(p, low, share); };
  pieces.begin("lower_teeth");
  add_row(pieces, middle - ModelVector{0, tall, 0.04 * w}, 0.95 * width, tall, columns, rows, on_jaw);
  if (!has_tongue) return;
  pieces.begin("tongue");
  pieces.ball(middle - ModelVector{0, 0.3 * w, 0.6 * w}, ModelVector{0.35, 0.12, 0.5} * w, 10 + columns / 4,
              5 + rows / 2, [&](const ModelPoint& p) { return pieces.add_on_jaw(p, low, tongue_share); });
}

void add_hair_and_ears(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double h = marks.high - marks.low;
  const double follows = dice.chance(0.6) ? 0 : dice.real(0.1, 0.7);
  const ModelPoint middle{marks.nose.x, 0.5 * (marks.high + marks.eyes[0].y), marks.nose.z - 0.35 * h};
  const ModelVector radii = ModelVector{dice.real(0.36, 0.5), dice.real(0.35, 0.5), dice.real(0.35, 0.5)} * h;
  const std::size_t around = dice.count(10, 36);
  const double brow = marks.brows[0].y;
  pieces.begin("hair_cap");
  pieces.ball(middle + ModelVector{0, 0.1 * h, 0}, radii, around, around / 2, [&](const ModelPoint& p) {
    if (follows == 0) return pieces.add(p, {});
    const std::uint32_t skin = pieces.nearest(p);
    const bool low = p.y < brow;
    return pieces.add(p, {{skin, low ? 0 : follows}});
  });
  if (!dice.chance(0.5)) return;
  const ModelVector ear = ModelVector{0.04, 0.12, 0.07} * (h * dice.about_one(0.3));
  const double far = dice.real(0.34, 0.42) * h;
  for (const double out : {1.0, -1.0}) {
    pieces.begin(out > 0 ? "ear_L" : "ear_R");
    pieces.ball({middle.x + out * far, marks.nose.y, middle.z}, ear, 8, 5,
                [&](const ModelPoint& p) { return pieces.add(p, {}); });
  }
}

void add_shoulders(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double h = marks.high - marks.low;
  const double z = marks.nose.z - 0.4 * h;
  const std::size_t around = dice.count(10, 30);
  const double size = h * dice.about_one(0.2);
  const Make still = [&](const ModelPoint& p) { return pieces.add(p, {}); };
  pieces.begin("neck");
  pieces.ball({0, marks.low - 0.1 * size, z}, ModelVector{0.22, 0.35, 0.22} * size, around, around / 2, still);
  pieces.begin("shoulders");
  pieces.ball({0, marks.low - 0.5 * size, z}, ModelVector{0.85, 0.25, 0.3} * size, around, around / 2, still);
}

}  // namespace penpose::judges
