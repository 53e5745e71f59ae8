#include "core/document/words/face_deeds.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace penpose::document {
namespace {

using enum Aspect;

struct Share {
  Aspect aspect;
  double share;
};
/// What has to happen for a deed, shares of the distance between the eyes.
struct Least {
  Aspect aspect = brow_in;
  double way = 0;  ///< below 0: at most
};
struct DeedRow {
  std::string_view one, both;
  bool sided;  ///< it may be done on one side
  std::array<Share, 9> shares;
  Least least = {};
};

/// Shares of what is done, from faces whose controls say what they are.
constexpr std::array k_deeds{
    DeedRow{"brow down",
            "brows down",
            true,
            {{{brow_in, -0.38}, {brow_inner_up, -0.66}, {brow_middle_up, -0.6}, {brow_outer_up, -0.24}}}},
    DeedRow{"inner brow down",
            "inner brows down",
            true,
            {{{brow_in, -0.3}, {brow_inner_up, -0.9}, {brow_middle_up, -0.15}}}},
    DeedRow{"outer brow down", "outer brows down", true, {{{brow_middle_up, -0.4}, {brow_outer_up, -0.9}}}},
    DeedRow{"brow in", "brows together", true, {{{brow_in, -1.0}, {brow_inner_up, -0.1}}}},
    DeedRow{
        "brow raised", "brows raised", true, {{{brow_inner_up, 0.6}, {brow_middle_up, 0.54}, {brow_outer_up, 0.56}}}},
    DeedRow{"inner brow raised",
            "inner brows raised",
            true,
            {{{brow_inner_up, 0.9}, {brow_middle_up, 0.4}, {brow_outer_up, 0.08}}}},
    DeedRow{"outer brow raised",
            "outer brows raised",
            true,
            {{{brow_inner_up, 0.1}, {brow_middle_up, 0.55}, {brow_outer_up, 0.83}}}},
    DeedRow{"eye closes", "eyes close", true, {{{lid_upper_up, -0.65}, {lids_out, -0.08}, {lid_lower_up, 0.06}}}},
    DeedRow{"upper lid down", "upper lids down", true, {{{lid_upper_up, -0.65}}}},
    DeedRow{"eye wide", "eyes wide", true, {{{lid_upper_up, 0.65}, {lid_lower_up, -0.1}}}},
    DeedRow{"eye wide", "eyes wide", true, {{{lid_upper_up, 0.5}, {lid_lower_up, -0.45}}}},
    DeedRow{"eye narrows", "eyes narrow", true, {{{lid_upper_up, -0.4}, {lid_lower_up, 0.4}, {cheek_up, 0.1}}}},
    DeedRow{"lower lid raised", "lower lids raised", true, {{{lid_lower_up, 0.55}, {cheek_up, 0.15}}}},
    DeedRow{"lower lid down", "lower lids down", true, {{{lid_lower_up, -0.55}}}},
    DeedRow{"eye looks down",
            "eyes look down",
            true,
            {{{lid_upper_up, -0.58}, {lid_lower_up, -0.22}, {gaze_up, -0.15}}},
            {lid_lower_up, -0.01}},
    DeedRow{"eye looks down", "eyes look down", true, {{{lid_upper_up, -0.2}, {lid_lower_up, -0.1}, {gaze_up, -0.6}}}},
    DeedRow{"eye looks up",
            "eyes look up",
            true,
            {{{lid_upper_up, 0.55}, {lid_lower_up, 0.28}, {gaze_up, 0.17}}},
            {lid_lower_up, 0.005}},
    DeedRow{"eye looks up", "eyes look up", true, {{{lid_upper_up, 0.15}, {lid_lower_up, 0.08}, {gaze_up, 0.6}}}},
    DeedRow{"eye looks in", "eyes cross", true, {{{lids_out, -0.48}}}},
    DeedRow{"eye looks in", "eyes cross", true, {{{lids_out, -0.2}, {gaze_out, -0.6}}}},
    DeedRow{"eye looks out", "eyes look apart", true, {{{lids_out, 0.48}}}},
    DeedRow{"eye looks out", "eyes look apart", true, {{{lids_out, 0.2}, {gaze_out, 0.6}}}},
    DeedRow{"cheek raised",
            "cheeks raised",
            true,
            {{{lid_lower_up, 0.22}, {cheek_up, 0.65}, {cheek_forward, 0.17}, {hollow_up, 0.7}, {brow_outer_up, -0.2}}}},
    DeedRow{"cheek puffs",
            "cheeks puff",
            true,
            {{{hollow_out, 0.5},
              {hollow_forward, 1.05},
              {corner_forward, 0.6},
              {upper_forward, 0.33},
              {lower_forward, 0.37},
              {corner_out, -0.1}}}},
    DeedRow{"cheek sucked in", "cheeks sucked in", true, {{{hollow_out, -1.2}, {hollow_forward, -1.1}}}},
    DeedRow{"nose wrinkles",
            "nose wrinkles",
            true,
            {{{brow_inner_up, -0.2},
              {cheek_up, 0.3},
              {hollow_up, 0.2},
              {wing_up, 0.6},
              {wing_out, 0.1},
              {corner_up, 0.1},
              {upper_up, 0.15},
              {upper_middle_up, 0.1}}}},
    DeedRow{"nostril widens", "nostrils widen", true, {{{wing_up, 0.25}, {wing_out, 0.46}}}},
    DeedRow{"nostril narrows", "nostrils narrow", true, {{{wing_up, -0.1}, {wing_out, -0.5}}}},
    DeedRow{"smile",
            "smile",
            true,
            {{{hollow_out, 0.3},
              {hollow_up, 0.39},
              {corner_out, 0.38},
              {corner_up, 0.6},
              {corner_forward, -0.39},
              {upper_up, 0.2},
              {lower_up, 0.22}}}},
    DeedRow{"smile", "smile", true, {{{corner_out, 0.3}, {corner_up, 0.9}, {upper_up, 0.15}, {lower_up, 0.15}}}},
    DeedRow{"mouth corner down",
            "mouth corners down",
            true,
            {{{hollow_up, -0.44},
              {corner_out, 0.18},
              {corner_up, -0.75},
              {corner_forward, -0.28},
              {upper_up, -0.17},
              {lower_up, -0.17}}}},
    DeedRow{
        "mouth stretches",
        "mouth stretches",
        true,
        {{{hollow_out, 0.4}, {corner_out, 0.68}, {corner_up, -0.2}, {corner_forward, -0.7}, {upper_forward, -0.18}}}},
    DeedRow{"mouth corner in", "mouth narrows", true, {{{hollow_out, -0.5}, {corner_out, -0.9}}}},
    DeedRow{"dimple",
            "dimples",
            true,
            {{{cheek_up, 0.12},
              {cheek_forward, 0.15},
              {corner_out, 0.2},
              {corner_up, 0.38},
              {corner_forward, -1.25},
              {lower_up, 0.14},
              {lower_forward, -0.18}}}},
    DeedRow{"upper lip raised",
            "upper lip raised",
            true,
            {{{cheek_up, 0.12}, {wing_up, 0.12}, {corner_up, 0.12}, {upper_up, 0.75}, {upper_middle_up, 0.6}}}},
    DeedRow{"upper lip down", "upper lip down", true, {{{upper_up, -0.7}, {upper_middle_up, -0.7}}}},
    DeedRow{"lower lip down",
            "lower lip down",
            true,
            {
                {{corner_up, -0.14}, {lower_up, -0.75}, {lower_middle_up, -0.6}, {chin_up, -0.2}},
            }},
    DeedRow{"lower lip raised",
            "lower lip raised",
            true,
            {{{corner_up, 0.14}, {lower_up, 0.55}, {lower_middle_up, 0.66}, {lower_forward, 0.3}, {chin_up, 0.35}}}},
    DeedRow{"upper lip rolls in", "upper lip rolls in", true, {{{upper_forward, -1.0}, {upper_red, -0.7}}}},
    DeedRow{"lower lip rolls in",
            "lower lip rolls in",
            true,
            {{{lower_middle_up, 0.24}, {lower_forward, -1.19}, {lower_red, -0.6}}}},
    DeedRow{"upper lip forward",
            "upper lip forward",
            true,
            {{{upper_up, 0.26}, {upper_middle_up, 0.4}, {upper_forward, 1.15}, {upper_red, 0.2}}}},
    DeedRow{
        "lower lip forward",
        "lower lip forward",
        true,
        {{{corner_out, -0.12}, {lower_up, -0.25}, {lower_middle_up, -0.4}, {lower_forward, 1.13}, {lower_red, 0.3}}}},
    DeedRow{"upper lip out", "upper lip wide", true, {{{upper_out, 1.0}, {upper_forward, -0.4}}}},
    DeedRow{"lower lip out", "lower lip wide", true, {{{lower_out, 1.0}, {lower_forward, -0.4}}}},
    DeedRow{"lips press",
            "lips press",
            true,
            {{{cheek_up, 0.18},
              {hollow_up, 0.25},
              {corner_up, 0.48},
              {upper_up, 0.15},
              {lower_up, 0.41},
              {lower_middle_up, 0.2},
              {chin_up, 0.55},
              {chin_forward, 0.19}}}},
    DeedRow{"lips press",
            "lips press",
            true,
            {{{upper_middle_up, -0.4},
              {upper_red, -0.4},
              {upper_forward, -0.5},
              {lower_middle_up, 0.3},
              {lower_red, -0.4},
              {lower_forward, -0.5},
              {corner_out, 0.4},
              {corner_up, 0.3}}}},
    DeedRow{"lips press",
            "lips press",
            true,
            {{{hollow_out, 0.15},
              {hollow_up, 0.35},
              {corner_out, 0.3},
              {corner_up, 0.75},
              {upper_up, 0.35},
              {lower_up, 0.45},
              {lower_middle_up, 0.15}}}},
    DeedRow{"lips pucker",
            "lips pucker",
            true,
            {{{hollow_out, -0.27},
              {hollow_forward, 0.25},
              {corner_out, -0.6},
              {corner_forward, 0.64},
              {upper_forward, 0.5},
              {upper_red, 0.15},
              {lower_forward, 0.55},
              {upper_out, -0.1},
              {lower_out, -0.1}}}},
    DeedRow{"lips funnel",
            "lips funnel",
            false,
            {{{corner_out, -0.3},
              {corner_forward, 0.52},
              {upper_up, 0.18},
              {upper_middle_up, 0.36},
              {upper_forward, 0.46},
              {lower_up, -0.35},
              {lower_middle_up, -0.51},
              {lower_forward, 0.43},
              {chin_up, -0.15}}}},
    DeedRow{"lips close",
            "lips close",
            false,
            {{{corner_up, 0.23},
              {upper_middle_up, -0.16},
              {lower_up, 0.59},
              {lower_middle_up, 0.69},
              {lower_forward, 0.29}}},
            {lower_middle_up, 0.2}},
    DeedRow{"mouth opens",
            "mouth opens",
            false,
            {{{corner_up, -0.2}, {lower_up, -0.55}, {lower_middle_up, -0.73}, {chin_up, -0.1}}},
            {lower_middle_up, -0.05}},
    DeedRow{"lips part",
            "lips part",
            false,
            {{{upper_up, 0.3}, {upper_middle_up, 0.5}, {lower_up, -0.4}, {lower_middle_up, -0.65}}},
            {lower_middle_up, -0.03}},
    DeedRow{"jaw opens",
            "jaw opens",
            false,
            {{{corner_up, -0.23},
              {lower_up, -0.47},
              {lower_middle_up, -0.55},
              {lower_forward, -0.27},
              {chin_up, -0.46},
              {chin_forward, -0.45}}},
            {chin_up, -0.1}},
    DeedRow{"mouth opens round",
            "mouth opens round",
            false,
            {{{corner_out, -0.35},
              {corner_up, -0.25},
              {corner_forward, 0.25},
              {lower_up, -0.5},
              {lower_middle_up, -0.7},
              {upper_forward, 0.2},
              {chin_up, -0.35},
              {chin_forward, -0.3},
              {hollow_out, -0.1}}},
            {lower_middle_up, -0.05}},
    DeedRow{"jaw forward",
            "jaw forward",
            false,
            {{{hollow_forward, 0.26}, {corner_forward, 0.43}, {lower_forward, 0.81}, {chin_forward, 0.93}}}},
    DeedRow{"jaw back",
            "jaw back",
            false,
            {{{hollow_forward, -0.26}, {corner_forward, -0.43}, {lower_forward, -0.81}, {chin_forward, -0.93}}}},
    DeedRow{"chin raised",
            "chin raised",
            false,
            {{{chin_up, 0.95}, {chin_forward, 0.33}, {lower_up, 0.15}, {lower_middle_up, 0.15}}}},
    DeedRow{"tongue out", "tongue out", false, {{{tongue_forward, 1.0}}}},
    DeedRow{"tongue up", "tongue up", false, {{{tongue_up, 1.0}}}},
};

/// Weighted and of amount one.
const std::vector<Aspects>& shapes_of_deeds() {
  static const std::vector<Aspects> all = [] {
    std::vector<Aspects> out;
    for (const DeedRow& row : k_deeds) {
      Aspects one{};
      for (const Share& share : row.shares)
        if (share.share != 0.0) one[static_cast<std::size_t>(share.aspect)] = share.share * weight(share.aspect);
      const double length = amount(one);
      for (double& value : one) value /= length;
      out.push_back(one);
    }
    return out;
  }();
  return all;
}

bool is_enough(const Least& least, const Aspects& aspects) {
  const double way = aspects[static_cast<std::size_t>(least.aspect)] / weight(least.aspect);
  return least.way == 0.0 || (least.way > 0.0 ? way >= least.way : way <= least.way);
}

}  // namespace

std::string_view words_of_deed(Deed deed, bool both) { return both ? k_deeds[deed].both : k_deeds[deed].one; }

std::optional<Deed> deed_of_words(std::string_view one) {
  for (Deed d = 0; d < k_deeds.size(); ++d) {
    if (k_deeds[d].one == one) return d;
  }
  return std::nullopt;
}

std::vector<LikeDeed> deeds_like(const Aspects& aspects, FaceSide side) {
  std::vector<LikeDeed> out;
  const double length = amount(aspects);
  if (!(length > 0.0)) return out;
  for (Deed d = 0; d < k_deeds.size(); ++d) {
    const DeedRow& row = k_deeds[d];
    if ((side != FaceSide::both && !row.sided) || !is_enough(row.least, aspects)) continue;
    // Several rows may be one deed, which is called by the first of them.
    const Deed named = *deed_of_words(row.one);
    const double alike = product(aspects, shapes_of_deeds()[d]) / length;
    const auto same = std::find_if(out.begin(), out.end(), [&](const LikeDeed& one) { return one.deed == named; });
    if (same == out.end()) {
      out.push_back({named, alike});
    } else {
      same->alike = std::max(same->alike, alike);
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const LikeDeed& a, const LikeDeed& b) { return a.alike > b.alike; });
  return out;
}

Aspects without(const Aspects& aspects, Deed deed) {
  const Aspects* most = nullptr;
  double far = 0;
  for (Deed d = 0; d < k_deeds.size(); ++d) {
    if (k_deeds[d].one != k_deeds[deed].one) continue;
    const double along = product(aspects, shapes_of_deeds()[d]);
    if (most != nullptr && along <= far) continue;
    most = &shapes_of_deeds()[d];
    far = along;
  }
  Aspects out = aspects;
  for (std::size_t i = 0; i < k_aspects; ++i) out[i] -= far * (*most)[i];
  return out;
}

std::string words_sideways(const FaceEffect& effect) {
  if (effect.side != FaceSide::both || effect.sideways < 0.5) return {};
  const auto way = [](double left) { return left > 0 ? "left" : "right"; };
  const double lips = std::abs(effect.lips_left);
  const double chin = std::abs(effect.chin_left);
  const double gaze = std::abs(effect.gaze_left);
  const double tilt = std::abs(effect.left_corner_up);
  const double most = std::max({lips, chin, gaze, tilt});
  if (most < 0.01) return {};
  if (gaze == most) return std::string("eyes look ") + way(effect.gaze_left);
  if (tilt == most) return std::string("mouth tilts, ") + way(effect.left_corner_up) + " up";
  return std::string(chin > 0.7 * lips ? "jaw " : "mouth ") +
         way(chin > 0.7 * lips ? effect.chin_left : effect.lips_left);
}

}  // namespace penpose::document
