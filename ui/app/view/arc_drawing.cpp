#include "ui/app/view/arc_drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace penpose::app {
namespace {

/// Unlike skin, and unlike the lines of keys before and after.
constexpr std::uint32_t k_arc_color = 0xf0a020;
constexpr float k_path_px = 1.5F;
constexpr double k_same_frame_s = 1e-4;
/// Ticks are no nearer to each other.
constexpr double k_apart_px = 5;

}  // namespace

void add_arcs(std::vector<render::CurveDrawing>& out, std::span<const ShownArc> arcs, double time_s, float scale) {
  for (const ShownArc& arc : arcs) {
    render::CurveDrawing path;
    path.points_px = arc.places;
    path.color = render::from_srgb(k_arc_color, 0.85F);
    path.width_px = k_path_px * scale;
    out.push_back(std::move(path));
    std::optional<PxPoint> last;
    for (std::size_t f = 0; f < arc.places.size(); ++f) {
      const PxPoint& at = arc.places[f];
      const bool now = std::abs(arc.moments_s[f] - time_s) < k_same_frame_s;
      // Frames that lie on each other are one tick.
      if (last && !now && geometry::distance(*last, at) < k_apart_px * static_cast<double>(scale)) continue;
      last = at;
      const PxPoint along = arc.places[std::min(f + 1, arc.places.size() - 1)] - arc.places[f > 0 ? f - 1 : 0];
      const double size = std::sqrt(geometry::dot(along, along));
      const PxPoint across = size > 0 ? PxPoint{-along.y / size, along.x / size} : PxPoint{0, 1};
      const double half = (now ? 7.0 : 3.5) * static_cast<double>(scale);
      render::CurveDrawing tick;
      tick.points_px = {at - across * half, at + across * half};
      tick.color = render::from_srgb(k_arc_color, 1);
      tick.width_px = (now ? 4.0F : 2.0F) * scale;
      out.push_back(std::move(tick));
    }
  }
}

}  // namespace penpose::app
