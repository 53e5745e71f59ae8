#include "tests/judges/hands/hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/base/math.h"
#include "tests/support/random.h"

namespace penpose::judges {
namespace {

using geometry::PxPoint;

constexpr std::array<Hand, 7> k_hands{{
    {.name = "exact"},
    {.name = "tremor_1", .tremor_px = 1, .ends = 0.02},
    {.name = "tremor_2", .tremor_px = 2, .ends = 0.02},
    {.name = "uneven", .tremor_px = 1, .uneven = 0.6, .ends = 0.02},
    {.name = "ends", .tremor_px = 1, .ends = 0.12},
    {.name = "backwards", .tremor_px = 1, .ends = 0.02, .backwards = true},
    {.name = "wobbly", .tremor_px = 1, .ends = 0.02, .wobbly_scale = 0.08},
}};

double bell(tests::Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random(0, 1);
  return sum;
}

std::vector<double> lengths_along(std::span<const PxPoint> line) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + geometry::distance(line[i - 1], line[i]));
  return along;
}

/// The point at a length from the beginning; beyond an end, straight on.
PxPoint at_length(std::span<const PxPoint> line, std::span<const double> along, double length) {
  std::size_t i = 1;
  while (i + 1 < line.size() && (along[i] < length || along[i] <= along[i - 1])) ++i;
  // The straight way on at an end is that of a piece which has a length.
  while (i > 1 && along[i] <= along[i - 1]) --i;
  const double piece = along[i] - along[i - 1];
  const double t = piece > 0 ? (length - along[i - 1]) / piece : 0.0;
  return line[i - 1] + (line[i] - line[i - 1]) * t;
}

/// Smooth numbers of root mean square 1: white ones under a window of a cosine.
std::vector<double> shaken(std::size_t count, tests::Random& random) {
  constexpr std::size_t k_window = 17;
  std::array<double, k_window> window{};
  double square = 0;
  for (std::size_t k = 0; k < k_window; ++k) {
    window[k] = 0.5 - 0.5 * base::cos(2 * base::k_pi * static_cast<double>(k) / (k_window - 1));
    square += window[k] * window[k];
  }
  std::vector<double> white;
  for (std::size_t i = 0; i < count + k_window - 1; ++i) white.push_back(bell(random));
  std::vector<double> smooth(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < k_window; ++k) smooth[i] += white[i + k] * window[k] / std::sqrt(square);
  }
  return smooth;
}

}  // namespace

std::span<const Hand> all_hands() { return k_hands; }

const Hand& hand_named(std::string_view name) {
  const auto* found = std::find_if(k_hands.begin(), k_hands.end(), [&](const Hand& h) { return name == h.name; });
  if (found == k_hands.end()) std::abort();
  return *found;
}

std::vector<PxPoint> resampled(std::span<const PxPoint> line, std::size_t count) {
  const std::vector<double> along = lengths_along(line);
  std::vector<PxPoint> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(at_length(line, along, along.back() * static_cast<double>(i) / static_cast<double>(count - 1)));
  return out;
}

std::vector<PxPoint> drawn_by(const Hand& hand, std::span<const PxPoint> meant, std::uint64_t seed,
                              std::size_t points) {
  tests::Random random(seed);
  const std::vector<double> along = lengths_along(meant);
  const double length = along.back();
  const double first = random(-hand.ends, hand.ends) * length;
  const double last = length + random(-hand.ends, hand.ends) * length;
  const double phase = random(0, 2 * base::k_pi);
  const double scale = 1 + random(-hand.wobbly_scale, hand.wobbly_scale);
  const PxPoint middle = at_length(meant, along, 0.5 * length);
  std::vector<PxPoint> line;
  for (std::size_t i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(points - 1);
    // Its derivative, the speed, is 1 + uneven cos(2 pi t + phase).
    const double late = hand.uneven / (2 * base::k_pi) * (base::sin(2 * base::k_pi * t + phase) - base::sin(phase));
    const PxPoint p = at_length(meant, along, first + (last - first) * (t + late));
    line.push_back(middle + (p - middle) * scale);
  }
  if (hand.tremor_px > 0) {
    const std::vector<double> x = shaken(points, random);
    const std::vector<double> y = shaken(points, random);
    for (std::size_t i = 0; i < points; ++i) line[i] = line[i] + PxPoint{x[i], y[i]} * hand.tremor_px;
  }
  if (hand.backwards) std::reverse(line.begin(), line.end());
  return line;
}

std::uint64_t seed_of(std::string_view rig, std::string_view of_case, std::uint64_t number) {
  // FNV-1a, whose numbers are the same everywhere.
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](std::uint64_t byte) { hash = (hash ^ byte) * 1099511628211ULL; };
  for (const char c : rig) add(static_cast<unsigned char>(c));
  add(0);
  for (const char c : of_case) add(static_cast<unsigned char>(c));
  for (int k = 0; k < 8; ++k) add((number >> (8 * k)) & 0xffU);
  return hash;
}

}  // namespace penpose::judges
