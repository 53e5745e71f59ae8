#include "tests/judges/cases/gesture_kinds.h"

#include <algorithm>
#include <utility>

namespace penpose::judges {
namespace {

using geometry::PxPoint;
using Bend = GestureKind::Bend;
using Groups = std::vector<std::vector<std::string>>;
using Names = std::vector<std::string>;

std::string numbered(const std::string& name, double px) { return name + std::to_string(static_cast<int>(px)); }
std::string end_of(bool left) { return left ? "L" : "R"; }

Names both(const Names& muscles) {
  Names out;
  for (const std::string& one : muscles) {
    out.push_back(one + "L");
    out.push_back(one + "R");
  }
  return out;
}

std::vector<GestureKind::Line> lips_of(Lips lips, const Bend& bend) {
  if (lips == Lips::upper) return {{"lip_upper", bend, "", 0}};
  if (lips == Lips::lower) return {{"lip_lower", bend, "", 0}};
  return {{"lip_upper", bend, "", 0}, {"lip_lower", bend, "", 0}};
}
/// What stands behind the name where not all lines are drawn.
std::string alone(Lips lips) { return lips == Lips::upper ? "upper_line_" : lips == Lips::lower ? "line_" : ""; }

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
  return [=](PxPoint p, double s, double t, double) {
    const double share = (1 - s) * (1 - s);
    return p + PxPoint{(t > 0 ? -together : together) * share, up * share};
  };
}

GestureKind::Line lid(const std::string& side, double share) {
  return {"eyelid_upper_" + side, {}, "eyelid_lower_" + side, share};
}

}  // namespace

GestureKind smile(double px, double wider, Lips lips) {
  const std::string name = "smile_" + std::string(wider > 1.1 ? "wide_" : "") + alone(lips);
  return {numbered(name, px),
          lips_of(lips, curved(px, wider)),
          {{"smile_L"}, {"smile_R"}},
          both({"dimple_", "cheek_", "stretch_", "lower_down_"})};
}

GestureKind frown(double px, Lips lips) {
  Names accepted = both({"stretch_", "lower_down_", "upper_up_"});
  accepted.insert(accepted.end(), {"shrug_lower", "shrug_upper"});
  return {numbered("frown_" + alone(lips), px), lips_of(lips, curved(-px, 1)), {{"frown_L"}, {"frown_R"}}, accepted};
}

GestureKind open_mouth(double px, Lips lips) {
  Names accepted = both({"lower_down_", "upper_up_"});
  accepted.push_back("funnel");
  std::vector<GestureKind::Line> lines{{"lip_lower", dropped(px), "", 0}};
  if (lips == Lips::both) lines.insert(lines.begin(), {"lip_upper", dropped(-0.1 * px), "", 0});
  return {numbered("open_" + alone(lips), px), std::move(lines), {{"jaw_open"}}, accepted};
}

GestureKind narrow_mouth(double per_cent) {
  Names accepted = both({"press_"});
  accepted.insert(accepted.end(), {"pucker", "funnel", "roll_upper", "roll_lower"});
  return {
      numbered("narrow_", per_cent), lips_of(Lips::both, scaled(1 - per_cent / 100)), {{"pucker", "funnel"}}, accepted};
}

GestureKind wide_mouth(double per_cent) {
  return {numbered("wide_", per_cent),
          lips_of(Lips::both, scaled(1 + per_cent / 100)),
          {{"stretch_L", "smile_L", "dimple_L"}, {"stretch_R", "smile_R", "dimple_R"}},
          both({"press_"})};
}

GestureKind smirk(double px, bool left) {
  const std::string side = end_of(left);
  return {numbered("smirk_" + side + "_", px),
          lips_of(Lips::both, one_corner(px, left ? 1 : -1)),
          {{"smile_" + side}},
          {"dimple_" + side, "cheek_" + side, "stretch_" + side}};
}

GestureKind mouth_aside(double px, bool left) {
  const std::string side = end_of(left);
  const double way = left ? px : -px;
  return {numbered("aside_" + side + "_", px),
          lips_of(Lips::both,
                  [way](PxPoint p, double, double, double) {
                    return p + PxPoint{way, 0};
                  }),
          {{"mouth_" + side}},
          {"jaw_" + side}};
}

GestureKind upper_lip_up(double px) {
  Names accepted = both({"sneer_"});
  accepted.push_back("funnel");
  return {numbered("upper_lip_up_", px),
          lips_of(Lips::upper, dropped(-px)),
          {{"upper_up_L", "shrug_upper"}, {"upper_up_R", "shrug_upper"}},
          accepted};
}

GestureKind lower_lip_down(double px) {
  return {numbered("lower_lip_down_", px),
          lips_of(Lips::lower, dropped(px)),
          {{"lower_down_L", "jaw_open"}, {"lower_down_R", "jaw_open"}},
          {"funnel"}};
}

GestureKind brows_up(double px) {
  return {numbered("brows_up_", px),
          brows(risen(px)),
          {{"brow_outer_up_L", "brow_inner_up_L"}, {"brow_outer_up_R", "brow_inner_up_R"}},
          both({"brow_outer_up_", "brow_inner_up_"})};
}

GestureKind one_brow_up(double px, bool left) {
  const std::string side = end_of(left);
  const Names up{"brow_outer_up_" + side, "brow_inner_up_" + side};
  return {numbered("brow_up_" + side + "_", px), {{"brow_" + side, risen(px), "", 0}}, {up}, up};
}

GestureKind furrow(double px) {
  return {numbered("furrow_", px), brows(inner_end(-px, 4)), {{"brow_down_L"}, {"brow_down_R"}}, both({"sneer_"})};
}

GestureKind one_furrow(double px, bool left) {
  const std::string side = end_of(left);
  return {numbered("furrow_" + side + "_", px),
          {{"brow_" + side, inner_end(-px, 4), "", 0}},
          {{"brow_down_" + side}},
          {"sneer_" + side}};
}

GestureKind sad_brows(double px) {
  return {numbered("sad_brows_", px), brows(inner_end(px, 0)), {{"brow_inner_up_L"}, {"brow_inner_up_R"}}, {}};
}

GestureKind wink(double share, bool left) {
  const std::string side = end_of(left);
  return {(share > 0.75 ? "wink_" : "half_wink_") + side,
          {lid(side, share)},
          {{"blink_" + side}},
          {"squint_" + side, "cheek_" + side}};
}

GestureKind blink(double share) {
  return {share > 0.75 ? "blink" : "half_blink",
          {lid("R", share), lid("L", share)},
          {{"blink_L"}, {"blink_R"}},
          both({"squint_", "cheek_"})};
}

GestureKind eyes_wide(double px) {
  const Bend wider = [px](PxPoint p, double s, double, double) { return p + PxPoint{0, px * 4 * s * (1 - s)}; };
  return {numbered("eyes_wide_", px),
          {{"eyelid_upper_R", wider, "", 0}, {"eyelid_upper_L", wider, "", 0}},
          {{"wide_L"}, {"wide_R"}},
          {}};
}

GestureKind combined(const GestureKind& a, const GestureKind& b) {
  GestureKind out = a;
  out.name += "_and_" + b.name;
  out.lines.insert(out.lines.end(), b.lines.begin(), b.lines.end());
  out.needed.insert(out.needed.end(), b.needed.begin(), b.needed.end());
  out.accepted.insert(out.accepted.end(), b.accepted.begin(), b.accepted.end());
  return out;
}

}  // namespace penpose::judges
