#include "tests/judges/drawing/faces/no_faces.h"

#include <array>

#include "core/base/math.h"

namespace penpose::judges::drawn {
namespace {

void boat(Sheet& sheet) {
  sheet.corners({{120, 520}, {680, 520}, {590, 640}, {210, 640}, {120, 520}});
  sheet.corners({{400, 520}, {400, 120}});
  sheet.corners({{400, 130}, {640, 460}, {400, 460}});
  sheet.corners({{380, 200}, {200, 460}, {380, 460}});
  for (int i = 0; i < 3; ++i)
    sheet.line({{60.0 + 240 * i, 700}, {120.0 + 240 * i, 680}, {180.0 + 240 * i, 700}, {240.0 + 240 * i, 690}});
}

void flower(Sheet& sheet) {
  sheet.oval({400, 260}, 60, 60);
  for (int i = 0; i < 6; ++i) {
    const double angle = base::radians(60.0 * i + sheet.random()(-8, 8));
    sheet.oval(PxPoint{400, 260} + PxPoint{base::cos(angle), base::sin(angle)} * 130, 65, 60);
  }
  sheet.line({{400, 460}, {410, 600}, {390, 760}});
  sheet.loop({{405, 640}, {500, 580}, {560, 600}, {490, 650}});
}

void fish(Sheet& sheet) {
  sheet.line({{640, 300}, {400, 180}, {180, 330}, {400, 480}, {640, 340}, {740, 440}, {730, 220}, {640, 300}});
  sheet.oval({270, 300}, 18, 18);
  sheet.arc({350, 330}, 40, 90, -80, 80);
  sheet.line({{420, 190}, {480, 110}, {560, 230}});
  for (int i = 0; i < 3; ++i) sheet.arc({430.0 + 55 * i, 330}, 20, 40, -90, 90);
}

void stairs(Sheet& sheet) {
  std::vector<PxPoint> steps{{100, 700}};
  for (int i = 0; i < 6; ++i) {
    steps.push_back({steps.back().x, steps.back().y - 80});
    steps.push_back({steps.back().x + 90, steps.back().y});
  }
  sheet.corners(steps);
  sheet.corners({{100, 480}, {640, 20}});
  for (int i = 0; i < 4; ++i) sheet.corners({{140.0 + 140 * i, 620.0 - 125 * i}, {140.0 + 140 * i, 446.0 - 119 * i}});
}

void writing(Sheet& sheet) {
  for (int row = 0; row < 4; ++row) {
    for (int word = 0; word < 3; ++word) {
      std::vector<PxPoint> line;
      const auto count = 5 + static_cast<int>(sheet.random().index(6));
      for (int i = 0; i < count; ++i)
        line.push_back({90.0 + 230 * word + 20 * i, 180.0 + 150 * row + (i % 2 == 0 ? 1 : -1) * sheet.random()(8, 34)});
      sheet.line(line);
    }
  }
}

void spiral(Sheet& sheet) {
  std::vector<PxPoint> line;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.4 * i;
    line.push_back(PxPoint{400, 400} + PxPoint{base::cos(angle), base::sin(angle)} * (20 + 5.5 * i));
  }
  sheet.line(line);
  sheet.corners({{60, 60}, {740, 740}});
  sheet.corners({{740, 60}, {60, 740}});
}

void bottle(Sheet& sheet) {
  sheet.line({{350, 80}, {350, 240}, {260, 360}, {260, 720}, {540, 720}, {540, 360}, {450, 240}, {450, 80}});
  sheet.oval({400, 80}, 50, 14);
  sheet.corners({{260, 450}, {540, 450}});
  sheet.corners({{260, 620}, {540, 620}});
  sheet.line({{310, 560}, {360, 500}, {400, 560}, {450, 500}, {500, 560}});
}

void flat_plan(Sheet& sheet) {
  sheet.corners({{80, 120}, {720, 120}, {720, 680}, {80, 680}, {80, 120}});
  sheet.corners({{380, 120}, {380, 400}});
  sheet.corners({{80, 400}, {300, 400}});
  sheet.corners({{460, 400}, {720, 400}});
  sheet.arc({380, 400}, 80, 80, 0, 90);
  sheet.corners({{540, 480}, {660, 480}, {660, 620}, {540, 620}, {540, 480}});
  sheet.oval({200, 540}, 60, 60);
}

constexpr std::array<NoFace, 8> k_things{{{"boat", boat},
                                          {"flower", flower},
                                          {"fish", fish},
                                          {"stairs", stairs},
                                          {"writing", writing},
                                          {"spiral", spiral},
                                          {"bottle", bottle},
                                          {"flat_plan", flat_plan}}};

}  // namespace

std::span<const NoFace> no_faces() { return k_things; }

portrait::Drawing drawn_thing(const NoFace& thing, std::uint64_t seed) {
  static const Stroke k_stroke{.hand = {.name = "", .tremor_px = 1.5, .ends = 0.03}, .in_pieces = 0.1};
  Sheet sheet(k_stroke, seed);
  thing.draw(sheet);
  return {sheet.lines()};
}

}  // namespace penpose::judges::drawn
