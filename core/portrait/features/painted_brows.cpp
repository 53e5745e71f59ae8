#include "core/portrait/features/painted_brows.h"

#include <cmath>
#include <vector>

#include "core/portrait/features/smooth_path.h"
#include "core/portrait/surface/ray_walk.h"

namespace penpose::portrait {
namespace {

/// Columns over the window and a quarter of its width beyond both ends.
constexpr std::size_t k_strip_columns = 49;
constexpr double k_beyond_window = 0.25;
/// Thicknesses that are tried, shares of the distance of the eyes.
constexpr std::array<double, 3> k_thicknesses{0.045, 0.08, 0.13};
/// Rows that the middle of a brow may rise from column to column, as a share of the distance of the eyes.
constexpr double k_steepest = 0.08;
constexpr double k_rough_strip = 1e-4;
/// Contrast of a strip that is surely a brow (display values), and the share of it at which a brow ends.
constexpr double k_clear_strip = 0.07, k_end_of_strip = 0.5;
constexpr double k_of_paint = 0.92;
/// A brow is no shorter, shares of the distance of the eyes.
constexpr double k_shortest_strip = 0.3;
/// Brows of one face lie at the same height within this share of the distance of the eyes.
constexpr double k_uneven = 0.1;

using Rgb = std::array<double, 3>;

/// What a window shows, by columns and rows.
struct PaintedWindow {
  std::vector<std::vector<std::optional<SurfacePlace>>> places;
  std::vector<std::vector<double>> differs;  ///< from the skin
  int step = 1;                              ///< px from row to row
};

double median_of(std::vector<double>& values) {
  std::stable_sort(values.begin(), values.end());
  return values[values.size() / 2];
}

PaintedWindow look_through(const FaceSurface& surface, const SurfacePaint& paint, const BrowWindow& window) {
  PaintedWindow seen;
  seen.step = std::max(1, static_cast<int>(window.unit / 100.0));
  std::vector<std::vector<Rgb>> colors;
  std::array<std::vector<double>, 3> channels;
  for (std::size_t i = 0; i < k_strip_columns; ++i) {
    const double share = static_cast<double>(i) / (k_strip_columns - 1);
    const double x =
        window.outer + (window.inner - window.outer) * (share * (1 + 2 * k_beyond_window) - k_beyond_window);
    auto& column = seen.places.emplace_back();
    auto& own = colors.emplace_back();
    for (int y = window.bottom; y <= window.top; y += seen.step) {
      column.push_back(place_at(surface, x, y));
      own.emplace_back(Rgb{});
      if (!column.back()) continue;
      const auto rgba = paint(column.back()->point);
      for (std::size_t c = 0; c < 3; ++c) {
        own.back()[c] = rgba[c];
        channels[c].push_back(rgba[c]);
      }
    }
  }
  if (channels[0].size() < 100) return {};
  Rgb skin{};
  for (std::size_t c = 0; c < 3; ++c) skin[c] = median_of(channels[c]);
  for (std::size_t i = 0; i < k_strip_columns; ++i) {
    auto& column = seen.differs.emplace_back();
    for (std::size_t r = 0; r < colors[i].size(); ++r) {
      double square = 0;
      for (std::size_t c = 0; c < 3 && seen.places[i][r]; ++c)
        square += (colors[i][r][c] - skin[c]) * (colors[i][r][c] - skin[c]);
      column.push_back(std::sqrt(square / 3.0));
    }
  }
  return seen;
}

/// At each row, how much more a strip around it differs from the skin than what lies above and below it: the most of
/// several thicknesses.
std::vector<double> strips_of(const std::vector<double>& differs, const std::vector<std::size_t>& thicknesses) {
  std::vector<double> sums(differs.size() + 1, 0.0);
  for (std::size_t r = 0; r < differs.size(); ++r) sums[r + 1] = sums[r] + differs[r];
  const auto mean = [&](std::size_t from, std::size_t to) {
    return (sums[to] - sums[from]) / static_cast<double>(to - from);
  };
  std::vector<double> out(differs.size(), -1.0);
  for (const std::size_t thick : thicknesses) {
    const std::size_t half = thick / 2 + 1;
    for (std::size_t r = 3 * half; r + 3 * half < differs.size(); ++r) {
      const double within = mean(r - half, r + half);
      const double around = std::max(mean(r - 3 * half, r - half), mean(r + half, r + 3 * half));
      out[r] = std::max(out[r], within - around);
    }
  }
  return out;
}

FoundLine strip_in(const FaceSurface& surface, const SurfacePaint& paint, const BrowWindow& window) {
  FoundLine line;
  const PaintedWindow seen = look_through(surface, paint, window);
  if (seen.differs.empty() || seen.differs.front().empty()) return line;
  const double unit = window.unit / seen.step;
  std::vector<std::size_t> thicknesses;
  for (const double share : k_thicknesses) thicknesses.push_back(static_cast<std::size_t>(share * unit));
  std::vector<std::vector<double>> scores;
  for (const auto& column : seen.differs) scores.push_back(strips_of(column, thicknesses));
  const int jump = std::max(1, static_cast<int>(k_steepest * unit));
  const auto path = smooth_path(scores, jump, k_rough_strip);
  std::vector<double> along;
  for (std::size_t i = 0; i < path.size(); ++i) along.push_back(scores[i][path[i]]);
  std::vector<double> sorted = along;
  std::stable_sort(sorted.begin(), sorted.end(), std::greater<>());
  const double clear = sorted[sorted.size() / 4];
  // The longest run of columns that show the strip.
  std::size_t best_from = 0, best_to = 0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    std::size_t to = i;
    while (to < along.size() && along[to] > k_end_of_strip * clear) ++to;
    if (to - i > best_to - best_from) {
      best_from = i;
      best_to = to;
    }
    i = std::max(i, to);
  }
  const double column_width = std::abs(window.inner - window.outer) * (1 + 2 * k_beyond_window) / (k_strip_columns - 1);
  if (static_cast<double>(best_to - best_from) * column_width < k_shortest_strip * window.unit) return line;
  for (std::size_t i = best_from; i < best_to; ++i) {
    const auto& place = seen.places[i][path[i]];
    if (place) line.points.push_back(place->point);
  }
  line.sureness = k_of_paint * std::clamp(clear / k_clear_strip, 0.0, 1.0);
  return line;
}

double height_of_line(const FaceSurface& surface, const FoundLine& line) {
  double sum = 0;
  for (const mesh::MeshPoint& p : line.points) sum += surface.position(p).y;
  return sum / static_cast<double>(line.points.size());
}

}  // namespace

std::array<FoundLine, 2> find_painted_brows(const FaceSurface& surface, const SurfacePaint& paint,
                                            const std::array<BrowWindow, 2>& windows) {
  std::array<FoundLine, 2> brows;
  if (!paint) return brows;
  for (std::size_t side = 0; side < 2; ++side) brows[side] = strip_in(surface, paint, windows[side]);
  if (brows[0].points.empty() || brows[1].points.empty()) {
    for (FoundLine& brow : brows) brow.sureness *= 0.5;
    return brows;
  }
  const double distance = windows[0].unit * surface.image().px();
  const double off = (height_of_line(surface, brows[0]) - height_of_line(surface, brows[1])) / (k_uneven * distance);
  for (FoundLine& brow : brows) brow.sureness /= 1.0 + off * off;
  return brows;
}

}  // namespace penpose::portrait
