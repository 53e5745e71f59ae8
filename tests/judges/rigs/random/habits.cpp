#include "tests/judges/rigs/random/habits.h"

#include <algorithm>
#include <array>

#include "tests/judges/rigs/random/landmarks.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

/// A muscle of a side takes along another one, or a side's half of one that has no sides.
struct Habit {
  const char* from;
  const char* onto;
  double least, most;
};

constexpr std::array k_along{Habit{"smile_", "cheek_", 0, 0.9},       Habit{"smile_", "squint_", 0, 0.2},
                             Habit{"puff_", "pucker", 0.1, 0.9},      Habit{"puff_", "shrug_lower", 0, 0.4},
                             Habit{"press_", "shrug_lower", 0, 0.9},  Habit{"press_", "shrug_upper", 0, -0.5},
                             Habit{"press_", "dimple_", 0, 0.6},      Habit{"sneer_", "upper_up_", 0.05, 1.7},
                             Habit{"sneer_", "cheek_", 0, 0.3},       Habit{"cheek_", "upper_up_", 0.05, 0.4},
                             Habit{"cheek_", "squint_", 0, 0.3},      Habit{"dimple_", "cheek_", 0, 0.8},
                             Habit{"dimple_", "smile_", 0, 0.25},     Habit{"frown_", "shrug_lower", 0, 0.35},
                             Habit{"frown_", "lower_down_", 0, 0.35}, Habit{"squint_", "cheek_", 0, 0.6},
                             Habit{"stretch_", "lower_down_", 0, 0.3}};

/// Skin around goes along with the place that a muscle moves most.
struct Reach {
  const char* muscle;
  double out, up;  ///< which way
  double most;     ///< of the muscle's own way
};

constexpr std::array k_reaches{
    Reach{"brow_inner_up_", -0.2, 1, 2}, Reach{"brow_outer_up_", 0.1, 1, 1.3}, Reach{"brow_down_", 0, 1, 1},
    Reach{"frown_", 0.1, -1, 1.2},       Reach{"smile_", 0.7, 0.6, 0.7},       Reach{"dimple_", 0.8, 0.3, 0.8},
    Reach{"sneer_", 0.2, -0.8, 0.6},     Reach{"stretch_", 0.3, -0.8, 0.8},    Reach{"squint_", 0.2, -1, 0.6}};

void add_reaches(Parts& parts, Dice own) {
  const double w = parts.mouth;
  for (const Reach& reach : k_reaches) {
    const double share = own.chance(0.2) ? 0 : own.real(0, reach.most);
    const double far = own.real(0.2, 1.4);
    const ModelVector radii = ModelVector{own.real(0.6, 2.6), own.real(0.5, 1.9), 1.6} * w;
    for (const char* side : {"L", "R"}) {
      Field& field = parts.fields[std::string(reach.muscle) + side];
      const auto peak = std::max_element(field.begin(), field.end(), [](const ModelVector& a, const ModelVector& b) {
        return geometry::length(a) < geometry::length(b);
      });
      const ModelVector way = *peak * share;
      const double out = side[0] == 'L' ? reach.out : -reach.out;
      const ModelPoint at =
          parts.rest()[static_cast<std::size_t>(peak - field.begin())] + ModelVector{out, reach.up, 0} * (far * w);
      auto skin = around(parts.rest(), at, radii);
      for (const auto& [end, ball] : parts.eyes) {
        for (const std::uint32_t v : ball) skin[v] = 0;
      }
      add_to(field, 1, pushed(skin, way));
    }
  }
}

/// Lips that press each other take the chin along.
void add_chin(Parts& parts, Dice own) {
  const Landmarks marks = landmarks_of(parts);
  const double share = own.real(0, 2);
  const ModelPoint at = marks.mouth + (marks.chin - marks.mouth) * own.real(0.5, 1.5);
  const ModelVector radii = ModelVector{own.real(0.6, 1.8), own.real(0.4, 1.2), 1.4} * parts.mouth;
  for (const char* side : {"L", "R"}) {
    Field& field = parts.fields[std::string("press_") + side];
    double most = 0;
    for (const ModelVector& d : field) most = std::max(most, geometry::length(d));
    const auto half = side_share(parts.rest(), side[0] == 'L', 0.4 * parts.mouth);
    add_to(field, 1, pushed(product(around(parts.rest(), at, radii), half), {0, most * share, 0.2 * most * share}));
  }
}

}  // namespace

void add_habits(Parts& parts, const Dice& dice) {
  Dice own = dice.about("habits");
  const double strength = own.chance(0.15) ? 0 : own.real(0.5, 1);
  const auto before = parts.fields;
  for (const Habit& habit : k_along) {
    const double share = strength * own.real(habit.least, habit.most);
    const std::string from = habit.from;
    const std::string onto = habit.onto;
    for (const char* side : {"L", "R"}) {
      if (onto.back() == '_') {
        add_to(parts.fields[from + side], share, before.at(onto + side));
      } else {
        const auto half = side_share(parts.rest(), side[0] == 'L', 0.4 * parts.mouth);
        add_to(parts.fields[from + side], share, times(before.at(onto), half));
      }
    }
  }
  if (strength == 0) return;
  add_reaches(parts, dice.about("reaches"));
  add_chin(parts, dice.about("chin"));
}

}  // namespace penpose::judges
