#include "ui/film/frame_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace penpose::film {
namespace {

// Digits are strokes in a box 0.6 wide and 1 high, y down; what follows is in heights of a digit.
constexpr double k_digit_width = 0.6, k_advance = 0.86, k_stroke = 0.075;
/// From the digits to the edge of the plate.
constexpr double k_margin = 0.42;
constexpr double k_plate = 0.62;
constexpr double k_light = 240;

struct Point {
  double x, y;
};

/// Part of an ellipse, degrees clockwise from the right; no radius: a line from (x, y) to (to_x, to_y).
struct Stroke {
  double x, y, rx, ry, from, to;
};
constexpr Stroke line(double x, double y, double to_x, double to_y) { return {x, y, 0, 0, to_x, to_y}; }
constexpr Stroke arc(double x, double y, double rx, double ry, double from, double to) {
  return {x, y, rx, ry, from, to};
}

const std::array<std::vector<Stroke>, 10> k_digits{{
    {arc(0.3, 0.5, 0.3, 0.5, 0, 360)},
    {line(0.08, 0.2, 0.35, 0), line(0.35, 0, 0.35, 1)},
    {arc(0.3, 0.28, 0.28, 0.28, 180, 400), line(0.514, 0.46, 0, 1), line(0, 1, 0.6, 1)},
    {arc(0.29, 0.25, 0.27, 0.25, 190, 450), arc(0.29, 0.75, 0.31, 0.25, 270, 530)},
    {line(0.42, 0, 0, 0.7), line(0, 0.7, 0.6, 0.7), line(0.42, 0, 0.42, 1)},
    {line(0.54, 0, 0.09, 0), line(0.09, 0, 0.043, 0.474), arc(0.28, 0.68, 0.31, 0.32, 220, 500)},
    {arc(0.3, 0.68, 0.3, 0.32, 0, 360), arc(0.55, 0.68, 0.55, 0.68, 180, 260)},
    {line(0, 0, 0.6, 0), line(0.6, 0, 0.2, 1)},
    {arc(0.3, 0.25, 0.25, 0.25, 0, 360), arc(0.3, 0.75, 0.3, 0.25, 0, 360)},
    {arc(0.3, 0.32, 0.3, 0.32, 0, 360), arc(0.05, 0.32, 0.55, 0.68, 0, 80)},
}};

std::vector<Point> points_of(const Stroke& stroke) {
  if (stroke.rx == 0) return {{stroke.x, stroke.y}, {stroke.from, stroke.to}};
  constexpr int k_parts = 24;
  std::vector<Point> points;
  for (int i = 0; i <= k_parts; ++i) {
    const double angle = (stroke.from + (stroke.to - stroke.from) * i / k_parts) * std::numbers::pi / 180;
    points.push_back({stroke.x + stroke.rx * std::cos(angle), stroke.y + stroke.ry * std::sin(angle)});
  }
  return points;
}

double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Lays a grey over the px of a box by how much of each is covered.
template <typename Cover>
void lay(render::Image& image, Point low, Point high, double grey, const Cover& cover) {
  const int left = std::max(0, static_cast<int>(std::floor(low.x)));
  const int top = std::max(0, static_cast<int>(std::floor(low.y)));
  const int right = std::min(image.width, static_cast<int>(std::ceil(high.x)));
  const int bottom = std::min(image.height, static_cast<int>(std::ceil(high.y)));
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const double share = std::clamp(cover(Point{x + 0.5, y + 0.5}), 0.0, 1.0);
      auto* px =
          image.pixels.data() +
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 4;
      for (int c = 0; c < 3; ++c) px[c] = static_cast<std::uint8_t>(std::lround(px[c] + share * (grey - px[c])));
      px[3] = static_cast<std::uint8_t>(std::max<long>(px[3], std::lround(255 * share)));
    }
  }
}

}  // namespace

double number_width(int number, double height) {
  const auto digits = static_cast<double>(std::to_string(number).size());
  return height * (k_advance * (digits - 1) + k_digit_width);
}

void draw_number(render::Image& image, int number, const NumberPlace& place, bool on_dark) {
  const double h = place.height;
  const double half_width = 0.5 * number_width(number, h);
  if (on_dark) {
    const double half_x = half_width + k_margin * h, half_y = (0.5 + k_margin) * h, round = 0.3 * h;
    lay(image, {place.x - half_x - 1, place.y - half_y - 1}, {place.x + half_x + 1, place.y + half_y + 1}, 0,
        [&](const Point& p) {
          const double dx = std::max(0.0, std::abs(p.x - place.x) - half_x + round);
          const double dy = std::max(0.0, std::abs(p.y - place.y) - half_y + round);
          return k_plate * std::clamp(round - std::hypot(dx, dy) + 0.5, 0.0, 1.0);
        });
  }
  const double top = place.y - 0.5 * h;
  double left = place.x - half_width;
  for (const char digit : std::to_string(number)) {
    std::vector<std::vector<Point>> lines;
    for (const Stroke& stroke : k_digits[static_cast<std::size_t>(digit - '0')]) lines.push_back(points_of(stroke));
    const double reach = k_stroke * h + 1;
    lay(image, {left - reach, top - reach}, {left + k_digit_width * h + reach, top + h + reach}, k_light,
        [&](const Point& p) {
          const Point inside{(p.x - left) / h, (p.y - top) / h};
          double nearest = 1e9;
          for (const auto& points : lines) {
            for (std::size_t i = 1; i < points.size(); ++i)
              nearest = std::min(nearest, distance(inside, points[i - 1], points[i]));
          }
          return (k_stroke - nearest) * h + 0.5;
        });
    left += k_advance * h;
  }
}

void draw_frame_number(render::Image& image, int frame) {
  constexpr double k_share = 0.028, k_least_px = 9, k_edge = 1.4;
  const double height = std::max(k_least_px, k_share * std::min(image.width, image.height));
  const NumberPlace place{k_edge * height + 0.5 * number_width(frame, height), image.height - k_edge * height, height};
  draw_number(image, frame, place, true);
}

}  // namespace penpose::film
