#include "tests/judges/cases/gesture_list.h"

namespace penpose::judges {
namespace {

void add_mouths(std::vector<GestureKind>& all) {
  for (const double px : {8.0, 15.0, 22.0, 30.0}) all.push_back(smile(px));
  all.push_back(smile(15, 1.2));
  all.push_back(smile(20, 1.05, Lips::lower));
  for (const double px : {12.0, 22.0}) all.push_back(frown(px));
  for (const double px : {20.0, 45.0}) all.push_back(open_mouth(px));
  all.push_back(open_mouth(30, Lips::lower));
  for (const double share : {10.0, 20.0, 30.0}) all.push_back(narrow_mouth(share));
  for (const double share : {10.0, 20.0}) all.push_back(wide_mouth(share));
  all.push_back(smirk(18, true));
  all.push_back(smirk(18, false));
  all.push_back(mouth_aside(14, true));
}

void add_eyes(std::vector<GestureKind>& all) {
  for (const double px : {8.0, 16.0, 28.0}) all.push_back(brows_up(px));
  for (const double px : {12.0, 24.0}) all.push_back(one_brow_up(px, false));
  all.push_back(furrow(12));
  all.push_back(one_furrow(14, false));
  all.push_back(sad_brows(14));
  all.push_back(wink(0.95, true));
  all.push_back(wink(0.95, false));
  all.push_back(wink(0.5, false));
  all.push_back(blink(0.95));
  all.push_back(eyes_wide(8));
}

}  // namespace

std::span<const GestureKind> gesture_kinds() {
  static const std::vector<GestureKind> all = [] {
    std::vector<GestureKind> kinds;
    add_mouths(kinds);
    add_eyes(kinds);
    return kinds;
  }();
  return all;
}

}  // namespace penpose::judges
