#include "core/portrait/sketch/expression.h"

#include <algorithm>
#include <cmath>

#include "core/portrait/sketch/habits.h"

namespace penpose::portrait {
namespace {

/// Shrinks a difference from the usual value: a usual difference becomes 0, a clearly larger one stays as it is, and
/// the result grows linearly between the two (firm shrinkage; Gao and Bruce 1997).
double beyond(double difference, const Usual& usual, double doubt) {
  const double size = std::abs(difference);
  const double low = usual.spread * doubt * k_from;
  const double high = usual.spread * doubt * k_whole;
  if (size <= low) return 0;
  if (size >= high) return difference;
  return (difference > 0 ? 1.0 : -1.0) * high * (size - low) / (high - low);
}

/// Returns the gap between a brow and the eye below it, as it is where the eye is open. `closed` is the share by which
/// its lid has come down, `opening` that of its width by which lids are apart at rest.
double gap_over_eye(const BrowMeasure& brow, const std::optional<EyeMeasure>& eye, double closed, double opening) {
  return brow.height - (eye ? eye->top + std::clamp(closed, 0.0, 1.0) * opening * eye->width : 0.0);
}

bool is_line(const std::optional<EyeMeasure>& eye) { return eye && eye->kind == EyeKind::line; }
bool is_open(const std::optional<EyeMeasure>& eye) { return eye && eye->kind == EyeKind::open; }

/// Returns how far an eye is closed, judged without the other eye: 1 is shut, below 0 is wide.
double closed_alone(const EyeMeasure& eye, const std::optional<EyeMeasure>& rest, double doubt) {
  if (eye.kind == EyeKind::dot) return 0;
  if (rest && rest->kind == EyeKind::open && rest->opening > 0) {
    const double opening = eye.kind == EyeKind::open ? eye.opening : 0;
    const double ratio = eye.width > 0 && rest->width > 0 ? opening * eye.width / (rest->opening * rest->width) : 1;
    return std::clamp(beyond(1 - ratio, k_closing, doubt), -k_widest, 1.0);
  }
  if (eye.kind == EyeKind::line) return std::abs(eye.bend) >= k_shut_bend ? 1 : 0;
  double closed = 0;
  if (eye.covered) closed = std::clamp(beyond(*eye.covered - k_covered.mean, k_covered, doubt), -k_widest, 1.0);
  if (eye.opening < k_half_open) closed = std::max(closed, 1 - eye.opening / k_half_open);
  return closed;
}

/// Returns how far lids are lowered of which so little of the opening lies above the corners of the eyes: a lid that
/// comes down takes it from there.
double lowered_by_arch(double arched) {
  const double usual = k_arched.mean + std::min(0.0, beyond(arched - k_arched.mean, k_arched, 1));
  return std::clamp((k_arched.mean - usual) / (1 - usual), 0.0, 1.0);
}

std::array<std::optional<double>, 2> closed_of(const FaceMeasures& drawn, const std::optional<RestingFace>& rest) {
  std::array<std::optional<double>, 2> out;
  const double doubt = rest ? rest->doubt : 1;
  for (std::size_t side = 0; side < 2; ++side) {
    if (!drawn.eyes[side]) continue;
    out[side] = closed_alone(*drawn.eyes[side], rest ? rest->measures.eyes[side] : std::nullopt, doubt);
  }
  if (!out[0] || !out[1]) return out;
  if (!rest && is_open(drawn.eyes[0]) && is_open(drawn.eyes[1])) {
    const double lowered = lowered_by_arch(std::max(drawn.eyes[0]->arched, drawn.eyes[1]->arched));
    for (auto& one : out) {
      if (lowered > 0) one = std::max(*one, lowered);
    }
  }
  // Eyes are wide together.
  const double wide = std::max(*out[0], *out[1]);
  for (auto& one : out) {
    if (*one < 0) one = std::min(0.0, wide);
  }
  // One eye against the other says more than either alone.
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& one = drawn.eyes[side];
    const auto& other = drawn.eyes[1 - side];
    if (is_line(one) && !is_line(other)) {
      out[side] = 1;
      const bool winks = !is_open(other) || other->opening >= k_half_open;
      out[1 - side] = winks ? std::min(*out[1 - side], 0.0) : std::max(*out[1 - side], lowered_by_arch(other->arched));
    }
    if (is_open(one) && is_open(other)) {
      const double own = one->opening * one->width;
      const double its = other->opening * other->width;
      if (its > 0 && own < k_unlike * its) out[side] = std::max(*out[side], 1 - own / its);
    }
  }
  return out;
}

/// Gives both sides their mean if they differ by no more than `stray`, as an unsteady hand makes them.
void make_even(double& one, double& other, double stray) {
  if (std::abs(one - other) > stray) return;
  one = other = 0.5 * (one + other);
}

std::optional<Expression::Brow> brow_of(const FaceMeasures& drawn, std::size_t side, double closed,
                                        const std::optional<RestingFace>& rest) {
  if (!drawn.brows[side]) return {};
  const BrowMeasure& brow = *drawn.brows[side];
  double tilt = k_tilt.mean, gap = k_brow_gap.mean, opening = k_opening;
  if (rest && rest->measures.brows[side]) {
    tilt = rest->measures.brows[side]->tilt;
    gap = gap_over_eye(*rest->measures.brows[side], rest->measures.eyes[side], 0, 0);
    if (is_open(rest->measures.eyes[side])) opening = rest->measures.eyes[side]->opening;
  }
  const double doubt = rest ? rest->doubt : 1;
  Expression::Brow out;
  out.tilted = std::clamp(beyond(brow.tilt - tilt, k_tilt, doubt), -k_most_tilt, k_most_tilt);
  double higher = gap_over_eye(brow, drawn.eyes[side], 0, 0) - gap;
  // A lid that comes down leaves a gap below a brow that stays.
  if (higher > 0) higher = std::max(0.0, gap_over_eye(brow, drawn.eyes[side], closed, opening) - gap);
  out.raised = std::clamp(beyond(higher, higher > 0 ? k_brow_gap : k_low_brow, doubt), -k_most_raise, k_most_raise);
  return out;
}

Expression::Mouth mouth_of(const MouthMeasure& drawn, const std::optional<RestingFace>& rest) {
  const double doubt = rest ? rest->doubt : 1;
  const MouthMeasure* known = rest && rest->measures.mouth ? &*rest->measures.mouth : nullptr;
  Expression::Mouth out;
  const double ratio = known ? drawn.width / known->width : drawn.relative_width / k_mouth_width.mean;
  // A mouth of one flat line is drawn in any width.
  const bool says_width = drawn.lines > 1 || ratio > 1 + k_widest_flat;
  out.widened = says_width ? std::clamp(beyond(ratio - 1, k_mouth_width, doubt), -k_most_narrowed, k_most_widened) : 0;
  // Heights are of the drawn width; a mouth that is drawn twice as wide curves twice as far, but no face does.
  const double scale = std::clamp(ratio, 0.5, 1.3);
  const double gap = drawn.shut ? 0 : drawn.gap - (known && !known->shut ? known->gap : 0);
  // Lips that kiss have a form of their own.
  const bool kisses = drawn.shut && drawn.lines > 1 && out.widened < 0;
  out.opened = std::clamp(std::max(0.0, beyond(gap * ratio, k_gap, doubt)), 0.0, k_most_open);
  const std::array<double, 2> at_rest = known ? known->corners : std::array<double, 2>{k_corner.mean, k_corner.mean};
  std::array<double, 2> corners{};
  for (std::size_t side = 0; side < 2; ++side) corners[side] = drawn.corners[side] - at_rest[side];
  double both = beyond(0.5 * (corners[0] + corners[1]), k_corner, doubt);
  const double uneven = beyond(corners[0] - corners[1], k_corner_skew, doubt);
  // The middle of an open mouth is lower than that of a shut one.
  const bool laughs = gap > 0 && 0.5 * (corners[0] + corners[1]) > k_laughing * gap;
  if (both > 0) both = std::max(laughs ? k_laughs : 0.0, both - k_corners_stay * gap);
  for (std::size_t side = 0; side < 2; ++side) {
    const double own = both + (side == 0 ? 0.5 : -0.5) * uneven;
    out.corners[side] = std::clamp(own * scale, -k_most_corner, k_most_corner);
  }
  // One corner is raised or lowered alone, but seldom one against the other.
  if (out.corners[0] * out.corners[1] < 0) {
    const std::size_t lesser = std::abs(out.corners[0]) < std::abs(out.corners[1]) ? 0 : 1;
    out.corners[lesser] = 0;
  }
  // Corners that go up go outwards.
  for (const double corner : out.corners) {
    if (out.widened >= 0 && corner > 0) out.widened = std::max(out.widened, k_smile_widens * corner);
  }
  if (kisses) out.corners = {0, 0};
  // A small round mouth has no corners; one that laughs is drawn in any width.
  if (out.widened < 0 && out.opened > 0) {
    if (laughs) {
      out.widened = 0;
    } else {
      out.corners = {0, 0};
      out.widened = std::max(out.widened, -k_narrowed_open);
    }
  }
  // What an opening jaw does by itself is no gesture of its own.
  if (out.widened < 0) out.widened = std::min(0.0, out.widened + k_open_narrows * out.opened);
  return out;
}

/// Adds what accompanies an expression but is seldom drawn, such as wide eyes of a frightened face.
void add_companions(Expression& expression, const FaceMeasures& drawn) {
  if (!expression.brows[0] || !expression.brows[1] || !expression.mouth) return;
  const double tilt = 0.5 * (expression.brows[0]->tilted + expression.brows[1]->tilted);
  const double raised = 0.5 * (expression.brows[0]->raised + expression.brows[1]->raised);
  Expression::Mouth& mouth = *expression.mouth;
  if (tilt > k_angry_tilt) {
    for (auto& brow : expression.brows) brow->raised = std::min(brow->raised, 0.0);
  }
  const bool afraid = tilt < 0 && (mouth.opened > 0 || mouth.widened > 0 || drawn.mouth->queasy);
  const bool surprised = raised > 0 && mouth.opened > 0 && mouth.widened < 0;
  for (std::size_t side = 0; side < 2; ++side) {
    if ((afraid || surprised) && expression.closed[side] && *expression.closed[side] == 0 && !is_line(drawn.eyes[side]))
      expression.closed[side] = -k_startled;
  }
  const bool squeezed = expression.closed[0].value_or(0) > k_squeezed && expression.closed[1].value_or(0) > k_squeezed;
  const bool queasy = (drawn.wrinkled[0] && drawn.wrinkled[1]) || drawn.mouth->queasy || squeezed;
  const bool disgusted = tilt > 0 && queasy && mouth.corners[0] <= 0 && mouth.corners[1] <= 0;
  if (disgusted) mouth.sneered = k_sneer;
}

}  // namespace

bool Expression::rests() const {
  for (const auto& brow : brows) {
    if (brow && (brow->raised != 0 || brow->tilted != 0)) return false;
  }
  for (const auto& eye : closed) {
    if (eye && *eye != 0) return false;
  }
  return !mouth || (mouth->corners == std::array<double, 2>{0, 0} && mouth->widened == 0 && mouth->opened == 0 &&
                    mouth->sneered == 0);
}

Expression expression_of(const FaceMeasures& drawn, const std::optional<RestingFace>& rest) {
  Expression out;
  out.closed = closed_of(drawn, rest);
  if (out.closed[0] && out.closed[1]) make_even(*out.closed[0], *out.closed[1], k_even_lids);
  for (std::size_t side = 0; side < 2; ++side)
    out.brows[side] = brow_of(drawn, side, out.closed[side].value_or(0), rest);
  if (out.brows[0] && out.brows[1]) {
    make_even(out.brows[0]->raised, out.brows[1]->raised, k_even_brows);
    make_even(out.brows[0]->tilted, out.brows[1]->tilted, k_even_tilts);
  }
  if (drawn.mouth) out.mouth = mouth_of(*drawn.mouth, rest);
  add_companions(out, drawn);
  return out;
}

}  // namespace penpose::portrait
