#include "tests/judges/cases/random_gestures.h"

#include <array>

#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {
namespace {

GestureKind random_mouth(Dice& dice) {
  const bool left = dice.chance(0.5);
  // In an order of its own: that of arguments is the compiler's.
  const double wider = dice.real(1, 1.25);
  const Lips one = dice.chance(0.5) ? Lips::lower : Lips::upper;
  switch (dice.below(13)) {
    case 0:
    case 1:
      return smile(dice.real(6, 34), wider);
    case 2:
      return smile(dice.real(6, 34), wider, one);
    case 3:
      return frown(dice.real(6, 26));
    case 4:
      return frown(dice.real(6, 26), one);
    case 5:
      return open_mouth(dice.real(8, 60));
    case 6:
      return open_mouth(dice.real(8, 60), Lips::lower);
    case 7:
      return narrow_mouth(dice.real(5, 35));
    case 8:
      return wide_mouth(dice.real(5, 25));
    case 9:
      return smirk(dice.real(6, 28), left);
    case 10:
      return mouth_aside(dice.real(6, 24), left);
    case 11:
      return upper_lip_up(dice.real(5, 16));
    default:
      return lower_lip_down(dice.real(5, 18));
  }
}

GestureKind random_brows(Dice& dice) {
  const bool left = dice.chance(0.5);
  switch (dice.below(5)) {
    case 0:
      return brows_up(dice.real(6, 32));
    case 1:
      return one_brow_up(dice.real(6, 30), left);
    case 2:
      return furrow(dice.real(6, 20));
    case 3:
      return one_furrow(dice.real(6, 20), left);
    default:
      return sad_brows(dice.real(6, 22));
  }
}

GestureKind random_eyes(Dice& dice) {
  const bool left = dice.chance(0.5);
  switch (dice.below(4)) {
    case 0:
      return wink(dice.real(0.3, 1), left);
    case 1:
      return blink(dice.real(0.85, 1));
    case 2:
      return blink(dice.real(0.3, 0.7));
    default:
      return eyes_wide(dice.real(4, 14));
  }
}

GestureKind random_both(Dice& dice) {
  const GestureKind mouth = dice.chance(0.5)   ? smile(dice.real(8, 30))
                            : dice.chance(0.7) ? open_mouth(dice.real(10, 50))
                                               : random_mouth(dice);
  const double with = dice.real(0, 1);
  return combined(mouth, with < 0.5 ? brows_up(dice.real(8, 28)) : with < 0.8 ? random_brows(dice) : random_eyes(dice));
}

GestureKind random_kind(Dice& dice) {
  const double which = dice.real(0, 1);
  if (which < 0.5) return random_mouth(dice);
  if (which < 0.7) return random_brows(dice);
  if (which < 0.88) return random_eyes(dice);
  return random_both(dice);
}

/// One of those that have names, or one with a little of each of their habits.
Hand random_hand(Dice& dice) {
  if (dice.chance(0.4)) return dice.one_of(all_hands());
  return {.name = "any",
          .tremor_px = dice.real(0, 2.5),
          .uneven = dice.chance(0.4) ? dice.real(0, 0.7) : 0,
          .ends = dice.real(0, dice.chance(0.3) ? 0.14 : 0.04),
          .backwards = dice.chance(0.2),
          .wobbly_scale = dice.chance(0.3) ? dice.real(0, 0.08) : 0};
}

}  // namespace

std::vector<Gesture> random_gestures(const Rig& rig, std::uint64_t seed, std::size_t count) {
  const GestureArtist artist(rig);
  Dice dice(seed_of(rig.name, "gestures", seed));
  std::vector<Gesture> all;
  for (std::size_t tries = 0; tries < 20 * count && all.size() < count; ++tries) {
    const GestureKind kind = random_kind(dice);
    const Hand hand = random_hand(dice);
    auto gesture = artist.meant(kind);
    if (!gesture) continue;
    artist.draw(*gesture, kind, hand, kind.name + "/" + hand.name + "/" + std::to_string(all.size()));
    all.push_back(std::move(*gesture));
  }
  return all;
}

}  // namespace penpose::judges
