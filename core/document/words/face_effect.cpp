#include "core/document/words/face_effect.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::document {
namespace {

/// Rows in the order of Aspect.
struct AspectRow {
  double weight;
  std::string_view more, less, more_both, less_both;
};
constexpr std::array<AspectRow, k_aspects> k_rows{{
    {1.0, "brow out", "brow in", "brows apart", "brows together"},
    {1.0, "inner brow raised", "inner brow down", "inner brows raised", "inner brows down"},
    {1.0, "brow raised", "brow down", "brows raised", "brows down"},
    {1.0, "outer brow raised", "outer brow down", "outer brows raised", "outer brows down"},
    {1.5, "upper lid raised", "upper lid down", "upper lids raised", "upper lids down"},
    {1.8, "lower lid raised", "lower lid down", "lower lids raised", "lower lids down"},
    {2.0, "lids out", "lids in", "lids out", "lids in"},
    {1.0, "cheek raised", "cheek down", "cheeks raised", "cheeks down"},
    {1.0, "cheek out", "cheek in", "cheeks out", "cheeks in"},
    {0.5, "cheek wide", "cheek narrow", "cheeks wide", "cheeks narrow"},
    {0.5, "cheek raised", "cheek down", "cheeks raised", "cheeks down"},
    {0.7, "cheek puffs", "cheek sucked in", "cheeks puff", "cheeks sucked in"},
    {1.3, "nostril raised", "nostril down", "nostrils raised", "nostrils down"},
    {2.0, "nostril widens", "nostril narrows", "nostrils widen", "nostrils narrow"},
    {1.2, "mouth corner out", "mouth corner in", "mouth widens", "mouth narrows"},
    {1.2, "mouth corner up", "mouth corner down", "mouth corners up", "mouth corners down"},
    {0.6, "mouth corner forward", "mouth corner back", "mouth corners forward", "mouth corners back"},
    {1.0, "upper lip out", "upper lip in", "upper lip wide", "upper lip narrow"},
    {1.0, "upper lip raised", "upper lip down", "upper lip raised", "upper lip down"},
    {1.0, "upper lip raised", "upper lip down", "upper lip raised", "upper lip down"},
    {0.7, "upper lip forward", "upper lip rolls in", "upper lip forward", "upper lip rolls in"},
    {1.0, "upper lip rolls out", "upper lip rolls in", "upper lip rolls out", "upper lip rolls in"},
    {1.0, "lower lip out", "lower lip in", "lower lip wide", "lower lip narrow"},
    {1.0, "lower lip raised", "lower lip down", "lower lip raised", "lower lip down"},
    {1.0, "lower lip raised", "lower lip down", "lower lip raised", "lower lip down"},
    {0.7, "lower lip forward", "lower lip rolls in", "lower lip forward", "lower lip rolls in"},
    {0.7, "lower lip rolls out", "lower lip rolls in", "lower lip rolls out", "lower lip rolls in"},
    {1.0, "chin raised", "jaw opens", "chin raised", "jaw opens"},
    {0.8, "chin forward", "chin back", "chin forward", "chin back"},
    {1.5, "eye looks out", "eye looks in", "eyes look apart", "eyes cross"},
    {1.5, "eye looks up", "eye looks down", "eyes look up", "eyes look down"},
    {0.5, "tongue up", "tongue down", "tongue up", "tongue down"},
    {1.0, "tongue out", "tongue back", "tongue out", "tongue back"},
}};

/// A ball that turns by less, of the distance between the eyes, does not look elsewhere.
constexpr double k_least_gaze = 0.06;
/// A tongue that moves by less does not go out; likewise one that does not go farther than the rest by this factor.
constexpr double k_least_tongue = 0.1, k_tongue_beyond = 1.5;
/// A side that does less than this share of what the other one does is not meant.
constexpr double k_one_side = 0.5;

using enum Mark;

Aspects half_of(const HalfMoves& half) {
  Aspects out{};
  const auto set = [&](Aspect aspect, double value) { out[static_cast<std::size_t>(aspect)] = value; };
  set(Aspect::brow_in, half[brow_inner].x);
  set(Aspect::brow_inner_up, half[brow_inner].y);
  set(Aspect::brow_middle_up, half[brow_middle].y);
  set(Aspect::brow_outer_up, half[brow_outer].y);
  set(Aspect::lid_upper_up, half[lid_upper].y);
  set(Aspect::lid_lower_up, half[lid_lower].y);
  set(Aspect::lids_out, 0.5 * (half[lid_upper].x + half[lid_lower].x));
  set(Aspect::cheek_up, half[cheek].y);
  set(Aspect::cheek_forward, half[cheek].z);
  set(Aspect::hollow_out, half[cheek_hollow].x);
  set(Aspect::hollow_up, half[cheek_hollow].y);
  set(Aspect::hollow_forward, half[cheek_hollow].z);
  set(Aspect::wing_up, half[nose_wing].y);
  set(Aspect::wing_out, half[nose_wing].x);
  set(Aspect::corner_out, half[corner].x);
  set(Aspect::corner_up, half[corner].y);
  set(Aspect::corner_forward, half[corner].z);
  set(Aspect::upper_out, half[lip_upper].x - 0.5 * half[corner].x);
  set(Aspect::upper_up, half[lip_upper].y);
  set(Aspect::upper_middle_up, half[lip_upper_middle].y);
  set(Aspect::upper_forward, 0.5 * (half[lip_upper].z + half[lip_upper_middle].z));
  set(Aspect::upper_red, half[lip_upper_border].y - half[lip_upper_middle].y);
  set(Aspect::lower_out, half[lip_lower].x - 0.5 * half[corner].x);
  set(Aspect::lower_up, half[lip_lower].y);
  set(Aspect::lower_middle_up, half[lip_lower_middle].y);
  set(Aspect::lower_forward, 0.5 * (half[lip_lower].z + half[lip_lower_middle].z));
  set(Aspect::lower_red, half[lip_lower_middle].y - half[lip_lower_border].y);
  set(Aspect::chin_up, half[chin].y);
  set(Aspect::chin_forward, half[chin].z);
  double most = 0;
  for (const double value : out) most = std::max(most, std::abs(value));
  for (const auto& [aspect, value] :
       {std::pair{Aspect::gaze_out, half[ball].x}, std::pair{Aspect::gaze_up, half[ball].y}}) {
    if (std::abs(value) > k_least_gaze) set(aspect, value);
  }
  const geometry::ModelVector way = half[tongue] - half[chin];
  const double far = std::max(std::abs(way.y), std::abs(way.z));
  if (far > k_least_tongue && far > k_tongue_beyond * most) {
    set(Aspect::tongue_up, way.y);
    set(Aspect::tongue_forward, way.z);
  }
  for (std::size_t i = 0; i < k_aspects; ++i) out[i] *= k_rows[i].weight;
  return out;
}

/// Without what lies in the middle, which both sides have in common.
double amount_beside(const HalfMoves& half) {
  constexpr std::array k_beside{brow_inner, brow_middle,  brow_outer, lid_upper, lid_lower, cheek,
                                nose_wing,  cheek_hollow, corner,     lip_upper, lip_lower, ball};
  double sum = 0;
  for (const Mark mark : k_beside) sum += glm::dot(half[mark], half[mark]);
  return std::sqrt(sum);
}

FaceSide side_of(const FaceMoves& moves) {
  const double l = amount_beside(moves.half[0]);
  const double r = amount_beside(moves.half[1]);
  if (!(std::min(l, r) < k_one_side * std::max(l, r))) return FaceSide::both;
  return l > r ? FaceSide::left : FaceSide::right;
}

}  // namespace

std::string_view behind(FaceSide side) {
  return side == FaceSide::left ? ", left" : side == FaceSide::right ? ", right" : "";
}

double product(const Aspects& a, const Aspects& b) {
  double sum = 0;
  for (std::size_t i = 0; i < k_aspects; ++i) sum += a[i] * b[i];
  return sum;
}

double amount(const Aspects& aspects) { return std::sqrt(product(aspects, aspects)); }

double amount_of_eyes(const Aspects& aspects) {
  double sum = 0;
  for (std::size_t i = 0; i < k_aspects; ++i) {
    const auto aspect = static_cast<Aspect>(i);
    const bool eyes = aspect <= Aspect::lids_out || aspect == Aspect::gaze_out || aspect == Aspect::gaze_up;
    if (eyes) sum += aspects[i] * aspects[i];
  }
  return std::sqrt(sum);
}

double weight(Aspect aspect) { return k_rows[static_cast<std::size_t>(aspect)].weight; }

std::string_view words_of(Aspect aspect, bool positive, bool both) {
  const AspectRow& row = k_rows[static_cast<std::size_t>(aspect)];
  if (both) return positive ? row.more_both : row.less_both;
  return positive ? row.more : row.less;
}

FaceEffect effect_of(const FaceMoves& moves) {
  const Aspects left = half_of(moves.half[0]);
  const Aspects right = half_of(moves.half[1]);
  FaceEffect out;
  out.side = side_of(moves);
  Aspects alike{};
  Aspects unlike{};
  for (std::size_t i = 0; i < k_aspects; ++i) {
    alike[i] = 0.5 * (left[i] + right[i]);
    unlike[i] = 0.5 * (left[i] - right[i]);
  }
  out.aspects = out.side == FaceSide::left ? left : out.side == FaceSide::right ? right : alike;
  const HalfMoves& lids = moves.half[out.side == FaceSide::right ? 1 : 0];
  out.lid_inner = std::max(std::abs(lids[lid_upper_inner].y), std::abs(lids[lid_lower_inner].y));
  out.lid_outer = std::max(std::abs(lids[lid_upper_outer].y), std::abs(lids[lid_lower_outer].y));
  const auto to_left = [&](Mark mark) { return 0.5 * (moves.half[0][mark].x - moves.half[1][mark].x); };
  const double all = amount(alike) + amount(unlike);
  out.sideways = all > 0 ? amount(unlike) / all : 0;
  out.lips_left = 0.5 * (to_left(lip_upper_middle) + to_left(lip_lower_middle));
  out.chin_left = to_left(chin);
  out.gaze_left = to_left(ball);
  out.left_corner_up = 0.5 * (moves.half[0][corner].y - moves.half[1][corner].y);
  return out;
}

}  // namespace penpose::document
