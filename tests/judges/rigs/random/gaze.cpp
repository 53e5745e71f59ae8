#include "tests/judges/rigs/random/gaze.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "tests/judges/rigs/random/landmarks.h"
#include "tests/judges/rigs/sculpt.h"

namespace penpose::judges {
namespace {

double longest(const Field& field, std::size_t count) {
  double most = 0;
  for (std::size_t v = 0; v < count; ++v) most = std::max(most, geometry::length(field[v]));
  return most;
}

/// What a maker lets eyes and lids do, for both sides.
struct Gaze {
  const char* name;
  ModelVector axis;
  double front = 0;             ///< how far the front of a ball goes, of its radius
  double upper = 0, lower = 0;  ///< how far lids go along, of the way of the front
  double aside = 0;
};

}  // namespace

void add_gaze(Parts& parts, const Dice& dice) {
  Dice own = dice.about("form of gaze");
  const bool turns = own.chance(0.42);
  const double follows = own.chance(0.1) && turns ? 0 : own.real(0.2, turns ? 0.6 : 1.2);
  const bool front_only = own.chance(0.4);
  std::array<Gaze, 4> gazes{
      {{"look_up_", {-1, 0, 0}}, {"look_down_", {1, 0, 0}}, {"look_left_", {0, 1, 0}}, {"look_right_", {0, -1, 0}}}};
  for (Gaze& gaze : gazes) {
    gaze.front = own.real(0.3, 0.6);
    gaze.upper = follows * own.about_one(0.25);
    gaze.lower = gaze.upper * own.real(0.15, 0.7);
    gaze.aside = follows * own.real(0.1, 0.5);
  }
  const Landmarks marks = landmarks_of(parts);
  const std::size_t count = parts.rest().size();
  for (const auto& [side, ball] : parts.eyes) {
    std::vector<double> share(count, 0.0);
    std::vector<double> is_ball(count, 0.0);
    for (const std::uint32_t v : ball) is_ball[v] = 1;
    geometry::Box box;
    for (const std::uint32_t v : ball) box.add(parts.rest()[v]);
    const double radius = 0.5 * (box.maximum.y - box.minimum.y);
    const double middle = box.center().z;
    for (const std::uint32_t v : ball)
      share[v] = front_only ? smooth_step(middle, middle + 0.4 * radius, parts.rest()[v].z) : 1;
    const ModelPoint& eye = marks.eyes[side == "L" ? 0 : 1];
    for (const Gaze& gaze : gazes) {
      const double half = 0.5 * gaze.front;
      const double degrees = 2 * base::degrees(base::atan2(half, std::sqrt(1 - half * half)));
      Field field(count, ModelVector{0});
      if (turns) field = turned(parts.rest(), share, box.center(), gaze.axis, degrees);
      const double way = gaze.front * radius;
      const auto lid = [&](const char* muscle, double amount) {
        const Field& other = parts.field(muscle + side);
        const double most = longest(other, count);
        if (most > 0) add_to(field, amount * way / most, other);
      };
      if (gaze.axis.x < 0) {
        lid("wide_", gaze.upper);
        lid("squint_", gaze.lower);
      } else if (gaze.axis.x > 0) {
        lid("blink_", gaze.upper);
        lid("squint_", -gaze.lower);
      } else {
        auto lids = around(parts.rest(), eye, ModelVector{1, 0.8, 1} * marks.eye);
        for (std::size_t v = 0; v < count; ++v) lids[v] *= 1 - is_ball[v];
        add_to(field, gaze.aside * way, pushed(lids, {gaze.axis.y, 0, 0}));
      }
      parts.fields[gaze.name + side] = std::move(field);
    }
  }
}

void add_lips_close(Parts& parts, const Dice& dice) {
  Dice own = dice.about("lips close");
  const double upper = own.real(0, 0.5);
  const double strength = own.real(0.8, 1.1);
  const double below_lip = own.real(0.45, 1.9);
  const double lower_by = own.chance(0.5) ? 0 : own.real(0, 0.6);
  const double w = parts.mouth;
  const Field& jaw = parts.field("jaw_open");
  const auto middle_of = [&](const char* line) {
    const auto& lip = parts.line(line);
    return lip[lip.size() / 2];
  };
  const std::uint32_t low = middle_of("lip_lower");
  const auto below = around(parts.rest(), parts.rest()[low] - ModelVector{0, lower_by * w, 0},
                            ModelVector{1.3, lower_by + below_lip, 1.2} * w);
  auto above = around(parts.rest(), parts.rest()[middle_of("lip_upper")], ModelVector{0.9, 0.4, 0.9} * w);
  for (std::size_t v = 0; v < above.size(); ++v) above[v] *= 1 - parts.jaw_share[v];
  Field field(parts.rest().size(), ModelVector{0});
  add_to(field, -strength * (1 - upper), times(jaw, below));
  add_to(field, strength * upper, pushed(above, jaw[low]));
  parts.fields["lips_close"] = std::move(field);
}

}  // namespace penpose::judges
