#include "tests/judges/cases/gesture_list.h"

#include <algorithm>
#include <utility>

namespace penpose::judges {
namespace {

using geometry::PxPoint;
using Bend = GestureKind::Bend;
using Groups = std::vector<std::vector<std::string>>;
using Names = std::vector<std::string>;

std::string numbered(const char* name, double px) { return name + std::to_string(static_cast<int>(px)); }

Names both(const Names& muscles) {
  Names out;
  for (const std::string& one : muscles) {
    out.push_back(one + "L");
    out.push_back(one + "R");
  }
  return out;
}

std::vector<GestureKind::Line> lips(const Bend& bend) {
  return {{"lip_upper", bend, "", 0}, {"lip_lower", bend, "", 0}};
}
std::vector<GestureKind::Line> brows(const Bend& bend) { return {{"brow_R", bend, "", 0}, {"brow_L", bend, "", 0}}; }

/// Corners up by `px` (down where it is negative), and a little wider.
Bend curved(double px, double wider) {
  return [=](PxPoint p, double, double t, double half) { return p + PxPoint{t * half * (wider - 1), px * t * t}; };
}
Bend dropped(double px) {
  return [=](PxPoint p, double, double t, double) { return p + PxPoint{0, -px * std::max(0.0, 1 - t * t)}; };
}
Bend scaled(double factor) {
  return [=](PxPoint p, double, double t, double half) { return p + PxPoint{t * half * (factor - 1), 0}; };
}
Bend risen(double px) {
  return [=](PxPoint p, double, double, double) { return p + PxPoint{0, px}; };
}
Bend one_corner(double px, double side) {
  return [=](PxPoint p, double, double t, double) {
    const double out = std::max(0.0, t * side);
    return p + PxPoint{side * 0.2 * px * out, px * out * out};
  };
}
/// The inner end by `up` and towards the middle by `together`, the outer end stays.
Bend inner_end(double up, double together) {
  return [=](PxPoint p, double s, double, double) {
    const double share = (1 - s) * (1 - s);
    return p + PxPoint{(p.x > 0 ? -together : together) * share, up * share};
  };
}

void add_mouths(std::vector<GestureKind>& all) {
  const Groups smile{{"smile_L"}, {"smile_R"}};
  const Names with_smile = both({"dimple_", "cheek_", "stretch_", "lower_down_"});
  for (const double px : {8.0, 15.0, 22.0, 30.0})
    all.push_back({numbered("smile_", px), lips(curved(px, 1.05)), smile, with_smile});
  all.push_back({"smile_wide_15", lips(curved(15, 1.2)), smile, with_smile});
  all.push_back({"smile_line_20", {{"lip_lower", curved(20, 1.05), "", 0}}, smile, with_smile});
  Names with_frown = both({"stretch_", "lower_down_", "upper_up_"});
  with_frown.insert(with_frown.end(), {"shrug_lower", "shrug_upper"});
  for (const double px : {12.0, 22.0})
    all.push_back({numbered("frown_", px), lips(curved(-px, 1)), {{"frown_L"}, {"frown_R"}}, with_frown});
  Names with_open = both({"lower_down_", "upper_up_"});
  with_open.push_back("funnel");
  for (const double px : {20.0, 45.0}) {
    all.push_back({numbered("open_", px),
                   {{"lip_upper", dropped(-0.1 * px), "", 0}, {"lip_lower", dropped(px), "", 0}},
                   {{"jaw_open"}},
                   with_open});
  }
  all.push_back({"open_line_30", {{"lip_lower", dropped(30), "", 0}}, {{"jaw_open"}}, with_open});
  Names with_narrow = both({"press_"});
  with_narrow.insert(with_narrow.end(), {"pucker", "funnel", "roll_upper", "roll_lower"});
  for (const double share : {10.0, 20.0, 30.0})
    all.push_back({numbered("narrow_", share), lips(scaled(1 - share / 100)), {{"pucker", "funnel"}}, with_narrow});
  for (const double share : {10.0, 20.0}) {
    all.push_back({numbered("wide_", share),
                   lips(scaled(1 + share / 100)),
                   {{"stretch_L", "smile_L", "dimple_L"}, {"stretch_R", "smile_R", "dimple_R"}},
                   both({"press_"})});
  }
  all.push_back({"smirk_L_18", lips(one_corner(18, 1)), {{"smile_L"}}, {"dimple_L", "cheek_L", "stretch_L"}});
  all.push_back({"smirk_R_18", lips(one_corner(18, -1)), {{"smile_R"}}, {"dimple_R", "cheek_R", "stretch_R"}});
  all.push_back({"aside_L_14",
                 lips([](PxPoint p, double, double, double) {
                   return p + PxPoint{14, 0};
                 }),
                 {{"mouth_L"}},
                 {"jaw_L"}});
}

void add_eyes(std::vector<GestureKind>& all) {
  const Groups up{{"brow_outer_up_L", "brow_inner_up_L"}, {"brow_outer_up_R", "brow_inner_up_R"}};
  const Names with_up = both({"brow_outer_up_", "brow_inner_up_"});
  for (const double px : {8.0, 16.0, 28.0}) all.push_back({numbered("brows_up_", px), brows(risen(px)), up, with_up});
  for (const double px : {12.0, 24.0}) {
    all.push_back({numbered("brow_up_R_", px),
                   {{"brow_R", risen(px), "", 0}},
                   {{"brow_outer_up_R", "brow_inner_up_R"}},
                   {"brow_outer_up_R", "brow_inner_up_R"}});
  }
  const Names with_furrow = both({"sneer_"});
  all.push_back({"furrow_12", brows(inner_end(-12, 4)), {{"brow_down_L"}, {"brow_down_R"}}, with_furrow});
  all.push_back({"furrow_R_14", {{"brow_R", inner_end(-14, 4), "", 0}}, {{"brow_down_R"}}, {"sneer_R"}});
  all.push_back({"sad_brows_14", brows(inner_end(14, 0)), {{"brow_inner_up_L"}, {"brow_inner_up_R"}}, {}});
  const auto lid = [](const char* side, double share) {
    return GestureKind::Line{std::string("eyelid_upper_") + side, {}, std::string("eyelid_lower_") + side, share};
  };
  all.push_back({"wink_L", {lid("L", 0.95)}, {{"blink_L"}}, {"squint_L", "cheek_L"}});
  all.push_back({"wink_R", {lid("R", 0.95)}, {{"blink_R"}}, {"squint_R", "cheek_R"}});
  all.push_back({"half_wink_R", {lid("R", 0.5)}, {{"blink_R"}}, {"squint_R", "cheek_R"}});
  all.push_back({"blink", {lid("R", 0.95), lid("L", 0.95)}, {{"blink_L"}, {"blink_R"}}, both({"squint_", "cheek_"})});
  const Bend wider = [](PxPoint p, double s, double, double) { return p + PxPoint{0, 8 * 4 * s * (1 - s)}; };
  all.push_back({"eyes_wide_8",
                 {{"eyelid_upper_R", wider, "", 0}, {"eyelid_upper_L", wider, "", 0}},
                 {{"wide_L"}, {"wide_R"}},
                 {}});
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
