#include "core/head/form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"

namespace penpose::head {
namespace {

/// Above 2: flatter in front and at the side than an ellipse.
constexpr double k_front_exponent = 2.25;
constexpr double k_back_exponent = 2.1;

constexpr std::array<Row, k_rows> k_row_table{{
    {9.2, 6.6, 6.1, 9.4, -0.9, 8.2, -7.9},        // upper forehead
    {6.2, 8.35, 7.25, 6.5, -0.7, 5.2, -9.3},      // forehead
    {3.6, 8.85, 7.5, 3.9, -0.4, 2.9, -9.6},       // above the brows
    {2.3, 8.85, 7.45, 2.2, -0.2, 1.0, -9.4},      // brows, upper edge of the orbit
    {0.0, 8.5, 7.25, 0.5, 0.0, -0.8, -8.8},       // middle of the eyes
    {-2.2, 8.4, 7.1, -0.8, 0.1, -2.2, -7.9},      // lower edge of the orbit
    {-3.3, 8.45, 6.95, -1.7, 0.1, -3.3, -7.1},    // tip of the nose
    {-4.1, 8.5, 6.75, -2.5, 0.2, -4.2, -6.5},     // foot of the nose
    {-4.9, 8.55, 6.5, -3.3, 0.3, -5.0, -6.0},     // above the mouth
    {-6.5, 8.5, 6.1, -4.4, 0.4, -5.8, -5.6},      // mouth
    {-8.2, 8.25, 5.65, -5.6, 0.5, -6.7, -5.3},    // below the mouth
    {-9.5, 8.2, 5.2, -6.8, 0.4, -7.7, -5.1},      // chin
    {-10.8, 7.4, 4.65, -8.0, 0.0, -8.7, -5.0},    // edge of the jaw
    {-11.2, 4.6, 3.95, -9.4, -0.8, -9.8, -5.0},   // throat
    {-12.6, 2.4, 3.6, -11.5, -1.4, -11.6, -5.0},  // neck
    {-15.2, 2.5, 4.1, -14.7, -1.5, -14.2, -5.4},  // where it spreads
    {-16.7, 3.2, 5.6, -16.5, -1.5, -16.1, -5.9},  // foot
    {-16.8, 2.6, 4.9, -16.7, -1.5, -16.4, -5.3},  // turned in
}};

ModelPoint on_row(const Row& r, double sine, double cosine) {
  const bool front = cosine >= 0;
  const double exponent = 2.0 / (front ? k_front_exponent : k_back_exponent);
  const double x = r.side_x * base::pow(sine, exponent);
  const double depth = base::pow(std::abs(cosine), exponent);
  const double end_z = front ? r.front_z : r.back_z;
  const double end_y = front ? r.front_y : r.back_y;
  return {x, r.side_y + (end_y - r.side_y) * cosine * cosine, r.side_z + (end_z - r.side_z) * depth};
}

}  // namespace

double profile(std::initializer_list<Knot> knots, double at) {
  const Knot* k = knots.begin();
  const auto n = static_cast<std::ptrdiff_t>(knots.size());
  if (at <= k[0].at) return k[0].value;
  if (at >= k[n - 1].at) return k[n - 1].value;
  std::ptrdiff_t i = 0;
  while (at > k[i + 1].at) ++i;
  const auto slope = [&](std::ptrdiff_t j) {
    const std::ptrdiff_t a = std::max<std::ptrdiff_t>(j - 1, 0);
    const std::ptrdiff_t b = std::min(j + 1, n - 1);
    return (k[b].value - k[a].value) / (k[b].at - k[a].at);
  };
  const double width = k[i + 1].at - k[i].at;
  const double t = (at - k[i].at) / width;
  const double s = 1 - t;
  return k[i].value * s * s * (1 + 2 * t) + slope(i) * width * t * s * s + k[i + 1].value * t * t * (3 - 2 * t) -
         slope(i + 1) * width * t * t * s;
}

double ramp(double from, double to, double at) {
  const double t = std::clamp((at - from) / (to - from), 0.0, 1.0);
  return t * t * t * (t * (6 * t - 15) + 10);
}

double bump(double distance_square) {
  const double t = std::max(1 - distance_square, 0.0);
  return t * t * t;
}

const Row& row(int number) { return k_row_table[static_cast<std::size_t>(number)]; }

ModelPoint point_at_angle(const Row& r, double degrees) {
  const double angle = base::radians(degrees);
  return on_row(r, std::max(base::sin(angle), 0.0), base::cos(angle));
}

ModelPoint point_at_x(const Row& r, double x) {
  const double sine = base::pow(std::clamp(x / r.side_x, 0.0, 1.0), k_front_exponent / 2.0);
  ModelPoint p = on_row(r, sine, std::sqrt(std::max(1 - sine * sine, 0.0)));
  p.x = x;
  return p;
}

double bare_depth(double x, double y) {
  // The rows are nearly level in front; those of the throat and neck are no part of the face.
  constexpr int k_last = 12;
  int lower = 1;
  while (lower < k_last && point_at_x(row(lower), x).y > y) ++lower;
  const auto at = [&](int r) { return point_at_x(row(std::clamp(r, 0, k_last)), x); };
  const std::array<ModelPoint, 4> p{at(lower - 2), at(lower - 1), at(lower), at(lower + 1)};
  const auto slope = [&](std::size_t a, std::size_t b) {
    return p[b].y == p[a].y ? 0.0 : (p[b].z - p[a].z) / (p[b].y - p[a].y);
  };
  const double height = p[2].y - p[1].y;
  const double t = std::clamp((y - p[1].y) / height, 0.0, 1.0);
  const double s = 1 - t;
  return p[1].z * s * s * (1 + 2 * t) + slope(0, 2) * height * t * s * s + p[2].z * t * t * (3 - 2 * t) -
         slope(1, 3) * height * t * t * s;
}

}  // namespace penpose::head
