#include "core/io/picture_lines/svg/internal/filled_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/io/picture_lines/trace/internal/ink.h"
#include "core/io/picture_lines/trace/internal/skeleton.h"
#include "core/io/picture_lines/trace/internal/strokes.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

constexpr double k_slender = 10;     ///< length by width of a line with its ends; 4 for a square, pi for a disc
constexpr double k_width_px = 5;     ///< of a line in the picture
constexpr double k_least_width = 2;  ///< where that would be too large
constexpr double k_most_side = 2048;
constexpr double k_margin_px = 2;
constexpr int k_rows = 4;  ///< of samples in a px

double perimeter(const FilledShape& shape) {
  double sum = 0;
  for (const Contour& one : shape.outlines) {
    for (std::size_t i = 1; i < one.points.size(); ++i) sum += geometry::distance(one.points[i - 1], one.points[i]);
  }
  return sum;
}

/// What lies inside, where outlines of holes run the other way round, or the shape has none.
double area(const FilledShape& shape) {
  double sum = 0;
  for (const Contour& one : shape.outlines) {
    for (std::size_t i = 1; i < one.points.size(); ++i) {
      const PxPoint a = one.points[i - 1] - one.points[0];
      const PxPoint b = one.points[i] - one.points[0];
      sum += a.x * b.y - a.y * b.x;
    }
  }
  return std::abs(sum) / 2;
}

/// Where the picture of a shape is, and how large.
struct Frame {
  PxPoint corner;
  double scale = 0;  ///< px of the picture for one of the shape; 0 where none will do
  int width = 0;
  int height = 0;
};

Frame frame_of(const FilledShape& shape) {
  PxPoint least{1e300, 1e300};
  PxPoint most{-1e300, -1e300};
  for (const Contour& one : shape.outlines) {
    for (const PxPoint& p : one.points) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  }
  const double width = 2 * area(shape) / perimeter(shape);
  const double side = std::max(most.x - least.x, most.y - least.y);
  const double scale = std::min(k_width_px / width, k_most_side / side);
  if (!(scale * width >= k_least_width)) return {};
  const auto cells = [&](double length) { return static_cast<int>(std::ceil(length * scale + 2 * k_margin_px)); };
  const PxPoint margin{k_margin_px / scale, k_margin_px / scale};
  return {least - margin, scale, cells(most.x - least.x), cells(most.y - least.y)};
}

/// Where an outline crosses a row of samples, and whether downwards (1) or upwards (-1).
struct Crossing {
  double x = 0;
  int turn = 0;
};

class ShapeFiller {
 public:
  ShapeFiller(const FilledShape& shape, const Frame& frame)
      : shape_(shape), frame_(frame), rows_(static_cast<std::size_t>(frame.height) * k_rows) {}

  /// How much of each px is inside, 0..255.
  Bitmap fill() {
    for (const Contour& one : shape_.outlines) {
      for (std::size_t i = 1; i < one.points.size(); ++i)
        cross(in_picture(one.points[i - 1]), in_picture(one.points[i]));
    }
    Bitmap picture(frame_.width, frame_.height);
    std::vector<double> covered(static_cast<std::size_t>(frame_.width));
    for (int y = 0; y < frame_.height; ++y) {
      std::fill(covered.begin(), covered.end(), 0.0);
      for (int row = y * k_rows; row < (y + 1) * k_rows; ++row) add_row(rows_[static_cast<std::size_t>(row)], covered);
      for (int x = 0; x < frame_.width; ++x) {
        const double share = covered[static_cast<std::size_t>(x)] / k_rows;
        picture[picture.index(x, y)] = static_cast<std::uint8_t>(std::min(255.0, share * 255 + 0.5));
      }
    }
    return picture;
  }

 private:
  [[nodiscard]] PxPoint in_picture(PxPoint p) const { return (p - frame_.corner) * frame_.scale; }

  void cross(PxPoint a, PxPoint b) {
    const int turn = a.y < b.y ? 1 : -1;
    if (a.y > b.y) std::swap(a, b);
    // Rows of samples are in the middle of their share of a px.
    const int first = std::max(0, static_cast<int>(std::ceil(a.y * k_rows - 0.5)));
    const int last = std::min(frame_.height * k_rows, static_cast<int>(std::ceil(b.y * k_rows - 0.5)));
    for (int row = first; row < last; ++row) {
      const double share = ((row + 0.5) / k_rows - a.y) / (b.y - a.y);
      rows_[static_cast<std::size_t>(row)].push_back({a.x + (b.x - a.x) * share, turn});
    }
  }

  void add_row(std::vector<Crossing>& row, std::vector<double>& covered) const {
    std::stable_sort(row.begin(), row.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int turns = 0;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      turns += row[i].turn;
      if (shape_.even_odd ? turns % 2 != 0 : turns != 0) add_run(row[i].x, row[i + 1].x, covered);
    }
  }

  void add_run(double from, double to, std::vector<double>& covered) const {
    from = std::clamp(from, 0.0, static_cast<double>(frame_.width));
    to = std::clamp(to, from, static_cast<double>(frame_.width));
    for (int x = static_cast<int>(from); x < to; ++x) {
      covered[static_cast<std::size_t>(x)] += std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
    }
  }

  const FilledShape& shape_;
  const Frame& frame_;
  std::vector<std::vector<Crossing>> rows_;
};

}  // namespace

bool FilledShape::is_line() const {
  const bool closed = std::all_of(outlines.begin(), outlines.end(), [](const Contour& one) { return one.closed; });
  const double around = perimeter(*this);
  const double inside = area(*this);
  return closed && inside > 0 && around * around / (4 * inside) >= k_slender && frame_of(*this).scale > 0;
}

std::uint64_t FilledShape::px() const {
  const Frame frame = frame_of(*this);
  return static_cast<std::uint64_t>(frame.width) * static_cast<std::uint64_t>(frame.height);
}

std::vector<Contour> middle_lines(const FilledShape& shape) {
  const Frame frame = frame_of(shape);
  Ink ink{ShapeFiller(shape, frame).fill(), Bitmap(frame.width, frame.height), 1, 0, 0};
  for (std::size_t i = 0; i < ink.hue.size(); ++i) ink.hue[i] = ink.strength[i] >= 128;
  Skeleton skeleton = find_skeleton(ink.hue);
  clean_up(skeleton);
  const Bitmap weights = weights_of(ink, 1);
  std::vector<Contour> lines;
  double length = 0;
  for (TracedStroke& stroke : strokes_of(skeleton)) {
    refine(stroke, weights);
    if (stroke.points.size() < 2) continue;
    for (PxPoint& p : stroke.points) p = frame.corner + p * (1 / frame.scale);
    for (std::size_t i = 1; i < stroke.points.size(); ++i)
      length += geometry::distance(stroke.points[i - 1], stroke.points[i]);
    lines.push_back({std::move(stroke.points), stroke.closed});
  }
  if (length < perimeter(shape) / 4) lines.clear();
  return lines;
}

}  // namespace penpose::io
