#include "ui/render/ghosts/ghost_drawings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/curve/distance.h"

namespace penpose::render {
namespace {

using geometry::ModelPoint;
using geometry::PxPoint;

/// So far away a place is seen faintly, and as it is; px of an ordinary display.
constexpr float k_apart_from_px = 0.7F, k_apart_to_px = 3.5F;
/// Each ghost shows so much of the one before it.
constexpr float k_fade = 0.6F;
constexpr float k_nearest_alpha = 0.9F;
constexpr float k_stepped_back = 0.35F;
constexpr float k_nearest_width_px = 2.2F, k_thinner_px = 0.25F, k_least_width_px = 1.2F;
constexpr float k_hardly_seen = 0.03F;
/// Points of a line that are nearer to each other are one.
constexpr double k_fine_px = 1.5;
/// Shorter parts of lines say nothing.
constexpr double k_least_part_px = 8;
/// Lines of two ghosts that are as near as that lie together.
constexpr double k_together_px = 1.5;

ModelPoint place_of(const posing::CurvePoint& point, std::span<const glm::vec3> positions) {
  ModelPoint place(0);
  for (std::size_t k = 0; k < point.vertex.size(); ++k)
    place += ModelPoint(positions[point.vertex[k]]) * point.weight[k];
  return place;
}

/// How one line is drawn.
struct Pen {
  Color color;
  float width_px = 2;
  float least = 0;  ///< alpha where the face is now
  bool highlighted = false;
};

/// The parts of a line that are seen, as drawings.
void add_line(std::vector<CurveDrawing>& out, const Ghost& ghost, const GhostLine& line, const Pen& pen,
              std::span<const glm::vec3> now, const geometry::Camera& camera, float scale) {
  std::vector<float> alphas;
  for (std::size_t i = 0; i < line.on.size(); ++i) {
    const auto px = camera.project(place_of(line.on[i], now));
    const float apart = px ? ghost_apart(geometry::distance(*px, line.places[i]), scale) : 1.0F;
    alphas.push_back(pen.color.a * std::max(pen.least, apart));
  }
  CurveDrawing part;
  PxPoint last;
  double length_px = 0;
  const auto end_part = [&] {
    if (part.points.size() >= 2 && length_px >= k_least_part_px * static_cast<double>(scale)) {
      part.width_px = pen.width_px;
      part.highlighted = pen.highlighted;
      out.push_back(std::move(part));
    }
    part = {};
    length_px = 0;
  };
  for (std::size_t i = 0; i < line.on.size(); ++i) {
    const bool beside =
        (i > 0 && alphas[i - 1] > k_hardly_seen) || (i + 1 < alphas.size() && alphas[i + 1] > k_hardly_seen);
    if (alphas[i] <= k_hardly_seen && !beside) {
      end_part();
      continue;
    }
    const bool is_end = i + 1 == line.on.size() || alphas[i + 1] <= k_hardly_seen;
    if (!part.points.empty() && !is_end && geometry::distance(last, line.places[i]) < k_fine_px) continue;
    if (!part.points.empty()) length_px += geometry::distance(last, line.places[i]);
    last = line.places[i];
    part.points.push_back(place_of(line.on[i], ghost.positions));
    part.point_colors.push_back({pen.color.r, pen.color.g, pen.color.b, alphas[i]});
  }
  end_part();
}

}  // namespace

std::vector<std::size_t> farthest_first(std::span<const Ghost> ghosts) {
  std::vector<std::size_t> order(ghosts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(ghosts[a].moment.away) > std::abs(ghosts[b].moment.away);
  });
  return order;
}

Color ghost_color(const GhostMoment& moment) {
  const auto steps = static_cast<float>(std::abs(moment.away) - 1);
  return from_srgb(moment.away < 0 ? k_before_color : k_after_color, k_nearest_alpha * std::pow(k_fade, steps));
}

float ghost_apart(double px, float scale) {
  const float t =
      std::clamp((static_cast<float>(px) / scale - k_apart_from_px) / (k_apart_to_px - k_apart_from_px), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

std::vector<CurveDrawing> ghost_drawings(std::span<const Ghost> ghosts, std::span<const glm::vec3> now,
                                         const geometry::Camera& camera, const GhostInk& ink) {
  std::vector<CurveDrawing> out;
  for (const std::size_t g : farthest_first(ghosts)) {
    const Ghost& ghost = ghosts[g];
    if (ghost.positions.size() != now.size()) continue;
    const bool lit = ink.lit && ink.lit->ghost == g;
    Pen pen;
    pen.color = ghost_color(ghost.moment);
    if (lit) pen.color.a = 1;
    if (ink.lit && !lit) pen.color.a *= k_stepped_back;
    const float thinner = k_thinner_px * static_cast<float>(std::abs(ghost.moment.away) - 1);
    pen.width_px = ink.scale * std::max(k_least_width_px, k_nearest_width_px - thinner);
    for (std::size_t l = 0; l < ghost.lines.size(); ++l) {
      Pen own = pen;
      own.highlighted = lit && ink.lit->line == l;
      if (lit && !ghost.lines[l].is_contour()) own.least = own.highlighted ? 1.0F : 0.5F;
      add_line(out, ghost, ghost.lines[l], own, now, camera, ink.scale);
    }
  }
  return out;
}

std::optional<GhostPlace> ghost_near(std::span<const Ghost> ghosts, PxPoint at, double within_px) {
  std::optional<GhostPlace> found;
  double least = within_px;
  auto order = farthest_first(ghosts);
  std::reverse(order.begin(), order.end());
  for (const std::size_t g : order) {
    for (std::size_t l = 0; l < ghosts[g].lines.size(); ++l) {
      const GhostLine& line = ghosts[g].lines[l];
      if (line.is_contour()) continue;
      const double px = curve::distance_to(line.places, at);
      // A line of a farther moment takes the place of one that it does not lie with.
      const bool other = found && found->ghost != g;
      if (px >= least - (other ? k_together_px : 0.0)) continue;
      least = px;
      found = GhostPlace{g, l};
    }
  }
  return found;
}

}  // namespace penpose::render
