#include "tests/judges/drawing/faces/mood.h"

namespace penpose::judges::drawn {
namespace {

std::array<double, 2> both(double value) { return {value, value}; }

Mood full(Expression expression, std::optional<Side> side) {
  const std::size_t here = side == Side::right ? 1 : 0;
  Mood mood;
  switch (expression) {
    case Expression::rest:
    case Expression::disgust:
    case Expression::contempt:
      break;
    case Expression::happy:
      mood = {.smile = both(0.9), .wide = 0.4, .brow_in = both(0.1), .brow_out = both(0.15)};
      break;
    case Expression::laugh:
      mood = {
          .smile = both(0.9), .open = 0.8, .wide = 0.5, .brow_in = both(0.2), .brow_out = both(0.3), .lid = both(0.5)};
      break;
    case Expression::sad:
      mood = {.smile = both(-0.8), .brow_in = both(0.8), .brow_out = both(-0.3), .lid = both(0.8)};
      break;
    case Expression::angry:
      mood = {.smile = both(-0.5), .brow_in = both(-0.9), .brow_out = both(0.2), .lid = both(0.75)};
      break;
    case Expression::surprised:
      mood = {.open = 0.8, .wide = -0.4, .brow_in = both(0.8), .brow_out = both(0.8), .lid = both(1.4)};
      break;
    case Expression::fear:
      mood = {
          .smile = both(-0.5), .open = 0.3, .wide = 0.3, .brow_in = both(0.9), .brow_out = both(0.3), .lid = both(1.4)};
      break;
    case Expression::wink:
      mood = {.smile = both(0.6), .wide = 0.2};
      mood.lid[here] = 0;
      mood.brow_in[here] = mood.brow_out[here] = -0.3;
      break;
    case Expression::smirk:
      mood.smile[here] = 0.9;
      mood.brow_out[here] = 0.4;
      break;
    case Expression::sleepy:
      mood = {.brow_in = both(-0.1), .brow_out = both(-0.2), .lid = both(0.2)};
      break;
    case Expression::kiss:
      mood.wide = -1;
      break;
    case Expression::open:
      mood = {.open = 0.8, .wide = -0.2};
      break;
  }
  return mood;
}

}  // namespace

bool is_drawn(Expression expression) { return expression != Expression::disgust && expression != Expression::contempt; }

Mood mood_of(Expression expression, std::optional<Side> side, double strength) {
  Mood mood = full(expression, side);
  for (std::size_t s = 0; s < 2; ++s) {
    for (double* part : {&mood.smile[s], &mood.brow_in[s], &mood.brow_out[s]}) *part *= strength;
    // Who draws a shut eye draws it shut, however little he exaggerates.
    if (mood.lid[s] > 1) mood.lid[s] = 1 + (mood.lid[s] - 1) * strength;
  }
  mood.open *= strength;
  return mood;
}

}  // namespace penpose::judges::drawn
