#include "core/io/picture_lines/trace/trace_lines.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/io/picture_lines/trace/internal/ink.h"
#include "core/io/picture_lines/trace/internal/skeleton.h"
#include "core/io/picture_lines/trace/internal/strokes.h"

namespace penpose::io {
namespace {

constexpr int k_largest_side = 16384;
constexpr std::size_t k_most_lines = 10'000;
constexpr double k_shortest_px = 4;

double length_of(const std::vector<geometry::PxPoint>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += geometry::distance(points[i - 1], points[i]);
  return sum;
}

/// Specks are no longer than wide.
bool is_speck(const TracedStroke& stroke) {
  return length_of(stroke.points) < std::max(k_shortest_px, 2 * stroke.radius);
}

Bitmap ink_of(const Ink& ink, int hue) {
  Bitmap mask(ink.hue.width(), ink.hue.height());
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = ink.hue[i] == hue;
  return mask;
}

base::Error photograph(const char* what) { return {what, "", "choose a drawing of lines on plain paper"}; }

}  // namespace

base::Result<PictureLines> trace_lines(const PictureView& picture) {
  const auto px = static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height);
  if (picture.width < 1 || picture.height < 1 || picture.width > k_largest_side || picture.height > k_largest_side ||
      picture.pixels.size() != px * 4) {
    return base::Error{"the picture's size does not fit its pixels", "", "give width * height * 4 bytes"};
  }
  const Ink ink = find_ink(picture);
  if (ink.covered > px / 2) return photograph("more than half of the picture differs from its paper");
  PictureLines drawing{{}, static_cast<double>(picture.width), static_cast<double>(picture.height)};
  for (int hue = 1; hue <= ink.hues; ++hue) {
    Skeleton skeleton = find_skeleton(ink_of(ink, hue));
    clean_up(skeleton);
    std::vector<TracedStroke> strokes = strokes_of(skeleton);
    join_gaps(strokes, ink);
    const Bitmap weights = weights_of(ink, hue);
    for (TracedStroke& stroke : strokes) {
      refine(stroke, weights);
      if (stroke.points.size() < 2 || is_speck(stroke)) continue;
      if (drawing.lines.size() == k_most_lines) return photograph("the picture has more than 10000 lines");
      if (!stroke.closed && stroke.points.back().x < stroke.points.front().x) {
        std::reverse(stroke.points.begin(), stroke.points.end());
      }
      drawing.lines.push_back({std::move(stroke.points), stroke.closed, drawing.lines.size(), ""});
    }
  }
  return drawing;
}

}  // namespace penpose::io
