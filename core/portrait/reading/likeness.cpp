#include "core/portrait/reading/likeness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/algebra/cholesky.h"
#include "core/base/math.h"

namespace penpose::portrait {
namespace {

// px of a face of k_face_px, and shares.
constexpr double k_hand = 5.0;
constexpr double k_shift = 25.0;
constexpr double k_turn = 0.06;

PxPoint middle_of(const Trace& trace) {
  PxPoint sum{0, 0};
  for (std::size_t i = 0; i < k_points; ++i) sum = sum + PxPoint{trace[2 * i], trace[2 * i + 1]};
  return sum * (1.0 / static_cast<double>(k_points));
}

/// One, two and three half waves at the points of a trace.
std::array<std::array<double, 3>, k_points> waves_along() {
  std::array<std::array<double, 3>, k_points> out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const double angle = base::k_pi * (static_cast<double>(i) / static_cast<double>(k_points - 1));
    out[i] = {base::sin(angle), base::sin(2.0 * angle), base::sin(3.0 * angle)};
  }
  return out;
}

/// Adds the square of what a way does to the middle of a trace: xx, xy, yy.
void add_to_middle(const Trace& way, double factor, std::array<double, 3>& spread) {
  const PxPoint moved = middle_of(way) * factor;
  spread[0] += moved.x * moved.x;
  spread[1] += moved.x * moved.y;
  spread[2] += moved.y * moved.y;
}

std::array<double, 3> inverse_of(const std::array<double, 3>& spread) {
  const double determinant = spread[0] * spread[2] - spread[1] * spread[1];
  if (!(determinant > 0.0)) return {};
  return {spread[2] / determinant, -spread[1] / determinant, spread[0] / determinant};
}

}  // namespace

std::vector<Trace> slides_of(const Trace& mean, const Stretch& stretch) {
  constexpr double k_end = 0.04, k_end_of_part = 0.14, k_bend = 0.04;
  constexpr std::size_t k_along = 5;
  std::vector<Trace> out(k_along);
  Trace tangent{};
  double length = 0;
  for (std::size_t i = 0; i < k_points; ++i) {
    const std::size_t a = i == 0 ? 0 : i - 1, b = std::min(i + 1, k_points - 1);
    const double dx = mean[2 * b] - mean[2 * a], dy = mean[2 * b + 1] - mean[2 * a + 1];
    const double step = std::sqrt(dx * dx + dy * dy);
    length += step / static_cast<double>(b - a);
    if (!(step > 0.0)) continue;
    tangent[2 * i] = dx / step;
    tangent[2 * i + 1] = dy / step;
  }
  const double end_share = stretch.whole() ? k_end : k_end_of_part;
  const double end = end_share * length / (stretch.to - stretch.from);
  static const std::array<std::array<double, 3>, k_points> waves = waves_along();
  for (std::size_t i = 0; i < k_points; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(k_points - 1);
    const std::array<double, k_along> along = {end * (1.0 - x), end * x, k_bend * length * waves[i][0],
                                               k_bend / 2.0 * length * waves[i][1],
                                               k_bend / 3.0 * length * waves[i][2]};
    for (std::size_t s = 0; s < k_along; ++s) {
      out[s][2 * i] = along[s] * tangent[2 * i];
      out[s][2 * i + 1] = along[s] * tangent[2 * i + 1];
    }
  }
  return out;
}

Likeness::Likeness(const FaceView& face, Belief belief, const Hand& hand)
    : face_(face),
      belief_(std::move(belief)),
      hand_(hand),
      places_(face.stretches().size()),
      normals_(face.stretches().size()) {
  for (std::size_t c = 0; c < face.curve_count(); ++c) {
    const Trace& rest = face.curve(c).rest;
    for (std::size_t i = 0; i < k_points; ++i) centre_ = centre_ + PxPoint{rest[2 * i], rest[2 * i + 1]};
  }
  centre_ = centre_ * (1.0 / static_cast<double>(face.curve_count() * k_points));
}

std::array<Trace, 4> Likeness::moves_of(const Stretch& stretch) const {
  std::array<Trace, 4> moves{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const double x = stretch.rest[2 * i] - centre_.x, y = stretch.rest[2 * i + 1] - centre_.y;
    moves[0][2 * i] = moves[1][2 * i + 1] = k_shift;
    moves[2][2 * i] = k_turn * x;
    moves[2][2 * i + 1] = k_turn * y;
    moves[3][2 * i] = -k_turn * y;
    moves[3][2 * i + 1] = k_turn * x;
  }
  return moves;
}

const Likeness::Place& Likeness::place(std::size_t number) const {
  auto& kept = places_[number];
  if (kept) return *kept;
  Place& out = kept.emplace();
  const Stretch& stretch = face_.stretches()[number];
  out.mean = stretch.rest;
  for (std::size_t j = 0; j < belief_.shares.size(); ++j) {
    if (belief_.shares[j] == 0.0) continue;
    for (std::size_t i = 0; i < k_numbers; ++i) out.mean[i] += belief_.shares[j] * stretch.ways[j][i];
  }
  for (std::size_t p = 0; p < belief_.proportions.size(); ++p) {
    for (std::size_t i = 0; i < k_numbers; ++i) out.mean[i] += belief_.proportions[p] * stretch.proportions[p][i];
  }
  const double wide = k_hand * hand_.width;
  std::array<double, 3> spread = face_.spread_of_middle(number);
  for (double& v : spread) v *= belief_.doubt * belief_.doubt;
  spread[0] += wide * wide / static_cast<double>(k_points);
  spread[2] += wide * wide / static_cast<double>(k_points);
  for (const Trace& way : stretch.proportions) add_to_middle(way, hand_.proportion * belief_.doubt, spread);
  for (const Trace& slide : slides_of(out.mean, stretch)) add_to_middle(slide, 1.0, spread);
  for (const Trace& move : moves_of(stretch)) add_to_middle(move, belief_.doubt, spread);
  out.middle = middle_of(out.mean);
  out.near = inverse_of(spread);
  return out;
}

const Likeness::Normal& Likeness::normal(std::size_t number) const {
  auto& kept = normals_[number];
  if (kept) return *kept;
  const Stretch& stretch = face_.stretches()[number];
  const Trace& mean = place(number).mean;
  Normal& out = kept.emplace();
  const double wide = k_hand * hand_.width;
  Spread& c = out.factor;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = belief_.doubt * belief_.doubt * face_.spread(number)[i];
  for (std::size_t i = 0; i < k_numbers; ++i) c[i * k_numbers + i] += wide * wide;
  for (const Trace& way : stretch.proportions) add_way(way, hand_.proportion * belief_.doubt, c);
  for (const Trace& slide : slides_of(mean, stretch)) add_way(slide, 1.0, c);
  for (const Trace& move : moves_of(stretch)) add_way(move, belief_.doubt, c);
  // Positive definite by what the hand strays.
  if (!algebra::factor(c.data(), k_numbers)) out.constant = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < k_numbers; ++i) out.constant += base::log(c[i * k_numbers + i]);
  if (!stretch.whole()) out.constant += k_part_cost;
  return out;
}

double Likeness::cost(const Trace& line, std::size_t stretch, double most) const {
  const Place& at = place(stretch);
  const PxPoint off = middle_of(line) - at.middle;
  const double least = at.near[0] * off.x * off.x + 2.0 * at.near[1] * off.x * off.y + at.near[2] * off.y * off.y;
  // The squares of the middle alone are no more than those of the whole, and the determinant is no less than what the
  // hand strays.
  const double least_constant = static_cast<double>(k_numbers) * base::log(k_hand * hand_.width);
  if (least > 2.0 * (most - least_constant)) return std::numeric_limits<double>::infinity();
  const Normal& about = normal(stretch);
  const double allowed = 2.0 * (most - about.constant);
  if (least > allowed) return std::numeric_limits<double>::infinity();
  double sum = 0;
  Trace left{};
  for (std::size_t i = 0; i < k_numbers; ++i) {
    const double* row = about.factor.data() + i * k_numbers;
    double v = line[i] - at.mean[i];
    for (std::size_t k = 0; k < i; ++k) v -= row[k] * left[k];
    left[i] = v / row[i];
    sum += left[i] * left[i];
    if (sum > allowed) return std::numeric_limits<double>::infinity();
  }
  return 0.5 * sum + about.constant;
}

}  // namespace penpose::portrait
