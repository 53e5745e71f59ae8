#include "core/portrait/features/lip_border.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/portrait/features/smooth_path.h"
#include "core/portrait/surface/ray_walk.h"

namespace penpose::portrait {
namespace {

/// Rays from the seam, and places along each.
constexpr std::size_t k_rays = 41;
constexpr std::size_t k_border_steps = 56;
// Lengths are shares of the width of the mouth.
constexpr double k_border_reach = 0.36;
/// Usual heights of the red in the middle, and of what lies beyond the corners; they may be off by this share.
constexpr double k_upper = 0.17, k_lower = 0.18, k_corner = 0.03;
constexpr double k_spread = 0.5;
/// The turn is the mean of those over these lengths, and the hollow lies between these lengths outside.
constexpr std::array k_chords{0.015, 0.025, 0.04};
constexpr double k_hollow_from = 0.035, k_hollow_to = 0.08;
/// A border of a material counts like this much turn (radians), where it is.
constexpr double k_material = 3.0;
/// What is far from usual, and a border that is not smooth, cost turn.
constexpr double k_unusual = 0.25, k_rough = 0.02;
constexpr int k_jump = 4;

/// A turn, less that of the hollow, which leaves no doubt.
constexpr double k_clear = 0.34;

struct Ray {
  double x = 0, y = 0;    ///< its start, px
  double dx = 0, dy = 0;  ///< px a step
  double usual = 0;       ///< steps
  std::vector<std::optional<SurfacePlace>> places;
};

std::vector<Ray> rays_of(const FaceSurface& surface, const MouthSeam& seam, bool upper) {
  const auto& columns = seam.columns;
  const double from = columns.front().x;
  const double width = columns.back().x - from;
  const double step = k_border_reach * width / k_border_steps;
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < k_rays; ++i) {
    const double share = static_cast<double>(i) / (k_rays - 1);
    const MouthSeam::Column& c =
        columns[static_cast<std::size_t>(std::lround(share * static_cast<double>(columns.size() - 1)))];
    const double u = 2.0 * share - 1.0;
    Ray ray;
    ray.x = c.x;
    ray.y = upper ? c.upper : c.lower;
    // Upright in the middle, sideways at the corners.
    const double slant = u * u * u;
    const double rise = std::sqrt(1.0 - slant * slant);
    ray.dx = slant * step;
    ray.dy = (upper ? rise : -rise) * step;
    const double height = upper ? k_upper : k_lower;
    ray.usual = (k_corner + (height - k_corner) * (1.0 - u * u)) / k_border_reach * k_border_steps;
    for (std::size_t s = 0; s < k_border_steps; ++s) {
      ray.places.push_back(
          place_at(surface, ray.x + static_cast<double>(s) * ray.dx, ray.y + static_cast<double>(s) * ray.dy));
    }
    rays.push_back(std::move(ray));
  }
  return rays;
}

/// How well each place of a ray is a border.
std::vector<double> scores_of(const FaceSurface& surface, const Ray& ray, double width) {
  const double step = k_border_reach * width / k_border_steps;
  std::vector<double> turns(k_border_steps, 0.0);
  for (const double length : k_chords) {
    const auto chord = static_cast<std::size_t>(std::max(1L, std::lround(length * width / step)));
    const std::vector<double> at_length = turns_of(ray.places, chord);
    for (std::size_t s = 0; s < k_border_steps; ++s) turns[s] += at_length[s] / static_cast<double>(k_chords.size());
  }
  const auto near = static_cast<std::size_t>(std::lround(k_hollow_from * width / step));
  const auto far = static_cast<std::size_t>(std::lround(k_hollow_to * width / step));
  std::vector<double> scores(k_border_steps, 0.0);
  for (std::size_t s = 0; s < k_border_steps; ++s) {
    double hollow = 0;
    double count = 0;
    for (std::size_t o = s + near; o <= s + far && o < k_border_steps; ++o) {
      hollow += turns[o];
      count += 1.0;
    }
    scores[s] = turns[s] - (count > 0.0 ? hollow / count : 0.0);
    if (s > 0 && ray.places[s] && ray.places[s - 1] &&
        part_of(surface.mesh(), ray.places[s]->point.triangle) !=
            part_of(surface.mesh(), ray.places[s - 1]->point.triangle)) {
      scores[s] += k_material;
    }
    const double off = (static_cast<double>(s) - ray.usual) / (k_spread * ray.usual + 1.0);
    scores[s] -= k_unusual * off * off;
    if (!ray.places[s]) scores[s] -= 10.0;
  }
  return scores;
}

/// Both sides of a mouth are alike: each place counts half for its mirror image.
void make_even(std::vector<std::vector<double>>& scores) {
  for (std::size_t i = 0; 2 * i < scores.size(); ++i) {
    std::vector<double>& right = scores[i];
    std::vector<double>& left = scores[scores.size() - 1 - i];
    for (std::size_t s = 0; s < k_border_steps; ++s) {
      const double both = (right[s] + left[s]) / 4.0;
      right[s] = right[s] / 2.0 + both;
      left[s] = left[s] / 2.0 + both;
    }
  }
}

FoundLine border_of(const FaceSurface& surface, const MouthSeam& seam, bool upper) {
  const std::vector<Ray> rays = rays_of(surface, seam, upper);
  const double width = seam.columns.back().x - seam.columns.front().x;
  std::vector<std::vector<double>> scores;
  for (const Ray& ray : rays) scores.push_back(scores_of(surface, ray, width));
  make_even(scores);
  const std::vector<std::size_t> path = smooth_path(scores, k_jump, k_rough);
  FoundLine line;
  double clear = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto& place = rays[i].places[path[i]];
    if (!place) continue;
    line.points.push_back(place->point);
    const double share = std::abs(2.0 * static_cast<double>(i) / (k_rays - 1) - 1.0);
    if (share < 0.8) clear += std::clamp(scores[i][path[i]] / k_clear, 0.0, 1.0) / (0.8 * k_rays);
  }
  line.sureness = seam.sureness * std::min(1.0, 0.15 + 0.85 * clear);
  return line;
}

}  // namespace

std::array<FoundLine, 2> lip_borders(const FaceSurface& surface, const MouthSeam& seam) {
  return {border_of(surface, seam, true), border_of(surface, seam, false)};
}

}  // namespace penpose::portrait
