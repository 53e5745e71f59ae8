#include "tests/judges/rigs/random/pieces/eye_pieces.h"

#include <algorithm>
#include <array>

#include "core/base/math.h"
#include "tests/judges/rigs/random/landmarks.h"

namespace penpose::judges {
namespace {

struct Side {
  std::string end;
  double out;
};
const std::array<Side, 2>& sides() {
  static const std::array<Side, 2> both{{{"_L", 1}, {"_R", -1}}};
  return both;
}

/// The vertex of another line that is as far along it.
std::uint32_t beside(const std::vector<std::uint32_t>& other, std::size_t i, std::size_t count) {
  return other[(i * (other.size() - 1) + (count - 1) / 2) / (count - 1)];
}

}  // namespace

void add_lashes(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double length = dice.real(0.15, 0.9) * marks.eye;
  const double tips = dice.real(1.05, 1.8);
  const double up = dice.real(0.2, 0.9);
  const bool lower = dice.chance(0.4);
  const bool cards = dice.chance(0.4);
  const std::size_t rows = dice.chance(0.4) ? dice.count(2, 4) : dice.count(5, 20);
  const std::size_t between = dice.chance(0.4) ? 1 : dice.count(2, 8);
  for (const Side& side : sides()) {
    for (const bool upper : {true, false}) {
      if (!upper && !lower) continue;
      pieces.begin((upper ? "lashes_upper" : "lashes_lower") + side.end);
      const auto& lid = parts.line((upper ? "eyelid_upper" : "eyelid_lower") + side.end);
      const double size = upper ? length : 0.5 * length;
      std::vector<std::vector<std::uint32_t>> grid(rows);
      const std::size_t columns = (lid.size() - 1) * between + 1;
      for (std::size_t c = 0; c < columns; ++c) {
        const double t = 2.0 * static_cast<double>(c) / static_cast<double>(columns - 1) - 1;
        const ModelVector way = geometry::normalized(ModelVector{side.out * 0.5 * t, upper ? up : -up, 0.7});
        const std::uint32_t a = lid[c / between];
        const std::uint32_t b = lid[std::min(c / between + 1, lid.size() - 1)];
        const double past = static_cast<double>(c % between) / static_cast<double>(between);
        const ModelPoint root = parts.rest()[a] + (parts.rest()[b] - parts.rest()[a]) * past;
        for (std::size_t r = 0; r < rows; ++r) {
          const double far = static_cast<double>(r) / static_cast<double>(rows - 1);
          const double gain = 1 + (tips - 1) * far;
          grid[r].push_back(pieces.add(root + way * (size * far), {{a, gain * (1 - past)}, {b, gain * past}}));
        }
      }
      for (std::size_t r = 0; r + 1 < rows; ++r) {
        for (std::size_t i = 0; i + 1 < columns; ++i) {
          pieces.triangle(grid[r][i], grid[r][i + 1], grid[r + 1][i + 1]);
          if (!cards) pieces.triangle(grid[r][i], grid[r + 1][i + 1], grid[r + 1][i]);
        }
      }
    }
  }
}

void add_eye_shells(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double bulge = dice.real(0.05, 0.3) * marks.eye;
  const bool whole = dice.chance(0.6);
  const std::size_t rows = dice.count(3, 24);
  for (const Side& side : sides()) {
    pieces.begin((whole ? "occlusion" : "tear_line") + side.end);
    const auto& upper = parts.line("eyelid_upper" + side.end);
    const auto& lower = parts.line("eyelid_lower" + side.end);
    std::vector<std::uint32_t> above;
    for (std::size_t r = 0; r < rows; ++r) {
      const double v = static_cast<double>(r) / static_cast<double>(rows - 1) * (whole ? 1 : 0.15);
      std::vector<std::uint32_t> row;
      for (std::size_t i = 0; i < lower.size(); ++i) {
        const std::uint32_t high = beside(upper, i, lower.size());
        const ModelPoint at = parts.rest()[lower[i]] + (parts.rest()[high] - parts.rest()[lower[i]]) * v;
        row.push_back(pieces.add(at + ModelVector{0, 0, 4 * bulge * v * (1 - v)}, {{lower[i], 1 - v}, {high, v}}));
      }
      if (r > 0) pieces.strip(above, row);
      above = std::move(row);
    }
  }
}

void add_brow_hair(Pieces& pieces, const Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double tall = dice.real(0.06, 0.25) * marks.eye;
  const double before = dice.real(0.02, 0.1) * marks.eye;
  const std::size_t rows = dice.count(2, 5);
  for (const Side& side : sides()) {
    pieces.begin("brow_hair" + side.end);
    const auto& brow = parts.line("brow" + side.end);
    std::vector<std::uint32_t> below;
    for (std::size_t r = 0; r < rows; ++r) {
      const double y = tall * (2.0 * static_cast<double>(r) / static_cast<double>(rows - 1) - 1);
      std::vector<std::uint32_t> row;
      for (const std::uint32_t v : brow) {
        const ModelPoint at = parts.rest()[v] + ModelVector{0, y, before};
        row.push_back(pieces.add(at, {{pieces.nearest(at), 1}}));
      }
      if (r > 0) pieces.strip(below, row);
      below = std::move(row);
    }
  }
}

void add_balls(Parts& parts, Dice dice) {
  const Landmarks marks = landmarks_of(parts);
  const double radius = dice.real(0.75, 1) * marks.eye;
  const std::size_t around = dice.count(8, 20);
  Pieces pieces(parts);
  for (const std::size_t i : {0U, 1U}) {
    pieces.begin(i == 0 ? "eye_L" : "eye_R");
    auto& ball = parts.eyes[i == 0 ? "L" : "R"];
    pieces.ball(marks.eyes[i] - ModelVector{0, 0, 1.05 * radius}, ModelVector{radius, radius, radius}, around,
                around / 2, [&](const ModelPoint& at) {
                  ball.push_back(pieces.add(at, {}));
                  return ball.back();
                });
  }
  std::move(pieces).attach(parts);
}

}  // namespace penpose::judges
