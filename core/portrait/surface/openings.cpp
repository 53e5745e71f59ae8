#include "core/portrait/surface/openings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"

namespace penpose::portrait {
namespace {

/// Directions in which a rim is sought.
constexpr int k_directions = 128;
/// Skin is next to a hole within this many px.
constexpr int k_next = 6;

struct Region {
  std::vector<std::uint32_t> px;
  bool at_border = false;
};

std::vector<Region> regions_of(const Mask& mask, int width, int height) {
  std::vector<Region> regions;
  std::vector<bool> done(mask.size(), false);
  for (std::uint32_t start = 0; start < mask.size(); ++start) {
    if (!mask[start] || done[start]) continue;
    Region region;
    region.px.push_back(start);
    done[start] = true;
    for (std::size_t i = 0; i < region.px.size(); ++i) {
      const int x = static_cast<int>(region.px[i]) % width;
      const int y = static_cast<int>(region.px[i]) / width;
      if (x == 0 || y == 0 || x == width - 1 || y == height - 1) {
        region.at_border = true;
        continue;
      }
      for (const int next : {x + 1 + y * width, x - 1 + y * width, x + (y + 1) * width, x + (y - 1) * width}) {
        if (!mask[next] || done[next]) continue;
        done[next] = true;
        region.px.push_back(static_cast<std::uint32_t>(next));
      }
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

/// The rim as seen from the middle: along each ray the skin behind the last px of the region.
void find_rim(const FaceSurface& surface, const Region& region, Opening& opening) {
  const FaceImage& image = surface.image();
  const int width = image.width();
  Mask own(static_cast<std::size_t>(width) * image.height(), false);
  double mean_x = 0, mean_y = 0;
  for (const std::uint32_t i : region.px) {
    own[i] = true;
    mean_x += i % width;
    mean_y += i / width;
  }
  const auto count = static_cast<double>(region.px.size());
  mean_x /= count;
  mean_y /= count;
  opening.centre = image.place(mean_x, mean_y);
  opening.area = count;
  double reach_x = 1, reach_y = 1;
  for (const std::uint32_t i : region.px) {
    reach_x = std::max(reach_x, std::abs(i % width - mean_x));
    reach_y = std::max(reach_y, std::abs(i / width - mean_y));
  }
  int met = 0;
  for (int d = 0; d < k_directions; ++d) {
    const double angle = 2.0 * base::k_pi * d / k_directions;
    const double dx = base::cos(angle) * reach_x;
    const double dy = base::sin(angle) * reach_y;
    const double step = 0.5 / std::max(1.0, std::max(std::abs(dx), std::abs(dy)));
    double last = 0;
    for (double t = 0; t < 1.5; t += step) {
      const int x = static_cast<int>(std::lround(mean_x + t * dx));
      const int y = static_cast<int>(std::lround(mean_y + t * dy));
      if (image.inside(x, y) && own[x + static_cast<std::size_t>(y) * width]) last = t;
    }
    for (int i = 1; i <= 2 * k_next; ++i) {
      const double t = last + i * step;
      const int x = static_cast<int>(std::lround(mean_x + t * dx));
      const int y = static_cast<int>(std::lround(mean_y + t * dy));
      if (!surface.shows_skin(x, y) || own[x + static_cast<std::size_t>(y) * width]) continue;
      opening.rim.push_back(surface.at(x, y));
      ++met;
      break;
    }
  }
  opening.enclosed = static_cast<double>(met) / k_directions;
}

}  // namespace

std::vector<Opening> openings_of(const FaceSurface& surface, const Mask& mask, double fewest) {
  std::vector<Opening> openings;
  for (const Region& region : regions_of(mask, surface.image().width(), surface.image().height())) {
    if (region.at_border || static_cast<double>(region.px.size()) < fewest) continue;
    Opening opening;
    find_rim(surface, region, opening);
    openings.push_back(std::move(opening));
  }
  std::stable_sort(openings.begin(), openings.end(),
                   [](const Opening& a, const Opening& b) { return a.area > b.area; });
  return openings;
}

}  // namespace penpose::portrait
