#include "core/portrait/reading/likeness.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The inverse of the covariance of a trace's middle: xx, xy, yy. The squares of the middle alone are no more than
/// those of the whole.
std::array<double, 3> inverse_spread_of_middle(const Spread& spread) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < k_numbers; ++i) {
    for (std::size_t k = 0; k <= i; ++k)
      sum[i % 2 + k % 2] += (i == k ? 1.0 : i % 2 == k % 2 ? 2.0 : 1.0) * spread[i * k_numbers + k];
  }
  constexpr double k_share = 1.0 / static_cast<double>(k_points * k_points);
  for (double& v : sum) v *= k_share;
  const double determinant = sum[0] * sum[2] - sum[1] * sum[1];
  if (!(determinant > 0.0)) return {};
  return {sum[2] / determinant, -sum[1] / determinant, sum[0] / determinant};
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
  for (std::size_t i = 0; i < k_points; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(k_points - 1);
    const double angle = base::k_pi * x;
    const std::array<double, k_along> along = {end * (1.0 - x), end * x, k_bend * length * base::sin(angle),
                                               k_bend / 2.0 * length * base::sin(2.0 * angle),
                                               k_bend / 3.0 * length * base::sin(3.0 * angle)};
    for (std::size_t s = 0; s < k_along; ++s) {
      out[s][2 * i] = along[s] * tangent[2 * i];
      out[s][2 * i + 1] = along[s] * tangent[2 * i + 1];
    }
  }
  return out;
}

Likeness::Likeness(const FaceView& face, const Belief& belief, const Hand& hand) {
  PxPoint centre{0, 0};
  for (std::size_t c = 0; c < face.curve_count(); ++c) {
    const Trace& rest = face.curve(c).rest;
    for (std::size_t i = 0; i < k_points; ++i) centre = centre + PxPoint{rest[2 * i], rest[2 * i + 1]};
  }
  centre = centre * (1.0 / static_cast<double>(face.curve_count() * k_points));
  for (std::size_t s = 0; s < face.stretches().size(); ++s) {
    const Stretch& stretch = face.stretches()[s];
    Normal normal;
    normal.mean = stretch.rest;
    for (std::size_t j = 0; j < belief.shares.size(); ++j) {
      if (belief.shares[j] == 0.0) continue;
      for (std::size_t i = 0; i < k_numbers; ++i) normal.mean[i] += belief.shares[j] * stretch.ways[j][i];
    }
    for (std::size_t p = 0; p < belief.proportions.size(); ++p) {
      for (std::size_t i = 0; i < k_numbers; ++i) normal.mean[i] += belief.proportions[p] * stretch.proportions[p][i];
    }
    const double wide = k_hand * hand.width;
    Spread& c = normal.factor;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = belief.doubt * belief.doubt * face.spread(s)[i];
    for (std::size_t i = 0; i < k_numbers; ++i) c[i * k_numbers + i] += wide * wide;
    for (std::size_t p = 0; p < face.proportion_count(); ++p)
      add_way(stretch.proportions[p], hand.proportion * belief.doubt, c);
    for (const Trace& slide : slides_of(normal.mean, stretch)) add_way(slide, 1.0, c);
    std::array<Trace, 4> moves{};
    for (std::size_t i = 0; i < k_points; ++i) {
      const double x = stretch.rest[2 * i] - centre.x, y = stretch.rest[2 * i + 1] - centre.y;
      moves[0][2 * i] = moves[1][2 * i + 1] = k_shift;
      moves[2][2 * i] = k_turn * x;
      moves[2][2 * i + 1] = k_turn * y;
      moves[3][2 * i] = -k_turn * y;
      moves[3][2 * i + 1] = k_turn * x;
    }
    for (const Trace& move : moves) add_way(move, belief.doubt, c);
    normal.middle = middle_of(normal.mean);
    normal.near = inverse_spread_of_middle(c);
    // Positive definite by what the hand strays.
    if (!algebra::factor(c.data(), k_numbers)) normal.constant = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < k_numbers; ++i) normal.constant += base::log(c[i * k_numbers + i]);
    if (!stretch.whole()) normal.constant += k_part_cost;
    normals_.push_back(normal);
  }
}

double Likeness::cost(const Trace& line, std::size_t stretch, double most) const {
  const Normal& normal = normals_[stretch];
  const double allowed = 2.0 * (most - normal.constant);
  const PxPoint off = middle_of(line) - normal.middle;
  const double least =
      normal.near[0] * off.x * off.x + 2.0 * normal.near[1] * off.x * off.y + normal.near[2] * off.y * off.y;
  if (least > allowed) return std::numeric_limits<double>::infinity();
  double sum = 0;
  Trace left{};
  for (std::size_t i = 0; i < k_numbers; ++i) {
    const double* row = normal.factor.data() + i * k_numbers;
    double v = line[i] - normal.mean[i];
    for (std::size_t k = 0; k < i; ++k) v -= row[k] * left[k];
    left[i] = v / row[i];
    sum += left[i] * left[i];
    if (sum > allowed) return std::numeric_limits<double>::infinity();
  }
  return 0.5 * sum + normal.constant;
}

}  // namespace penpose::portrait
