#include "ui/app/widgets/surface_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::app {
namespace {

using geometry::ModelPoint;

/// Where a picture looks from: x to the right, y down, z towards the eye, in px.
struct Eye {
  ModelPoint middle{0};
  double scale = 1;
  double half = 0;
  [[nodiscard]] glm::dvec3 seen(const ModelPoint& p) const {
    return {half + (p.x - middle.x) * scale, half - (p.y - middle.y) * scale, p.z * scale};
  }
};

}  // namespace

std::vector<std::uint8_t> surface_picture(std::span<const ModelPoint> positions,
                                          std::span<const mesh::Triangle> triangles, const PictureFrame& frame,
                                          int px) {
  const auto size = static_cast<std::size_t>(px);
  std::vector<std::uint8_t> picture(4 * size * size, 0);
  std::vector<double> depth(size * size, -1e300);
  const Eye from{frame.middle, px / std::max(1e-9, frame.side), 0.5 * px};
  for (const mesh::Triangle& corners : triangles) {
    const glm::dvec3 a = from.seen(positions[corners[0]]);
    const glm::dvec3 b = from.seen(positions[corners[1]]);
    const glm::dvec3 c = from.seen(positions[corners[2]]);
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    // Turned away, as seen with y down.
    if (!(area < 0)) continue;
    const glm::dvec3 normal = geometry::normalized({(c.y - a.y) * (b.z - a.z) - (b.y - a.y) * (c.z - a.z),
                                                    (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z), area});
    const double light = std::clamp(0.25 - 0.62 * normal.z + 0.3 * normal.y - 0.12 * normal.x, 0.08, 1.0);
    const int left = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
    const int right = std::min(px - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}))));
    const int top = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
    const int bottom = std::min(px - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}))));
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const double u = ((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x)) / area;
        const double v = ((c.x - x) * (a.y - y) - (c.y - y) * (a.x - x)) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const double z = u * a.z + v * b.z + (1 - u - v) * c.z;
        const std::size_t at = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
        if (z <= depth[at]) continue;
        depth[at] = z;
        // A warm grey.
        const auto grey = static_cast<unsigned>(255 * std::sqrt(light));
        std::uint8_t* pixel = picture.data() + 4 * at;
        pixel[0] = static_cast<std::uint8_t>(grey);
        pixel[1] = static_cast<std::uint8_t>(grey * 15 / 16);
        pixel[2] = static_cast<std::uint8_t>(grey * 7 / 8);
        pixel[3] = 255;
      }
    }
  }
  return picture;
}

std::vector<std::uint8_t> pose_pixels(const document::Model& model, const rig::Pose& pose, const PictureFrame& frame,
                                      int px) {
  std::vector<ModelPoint> posed(model.rig->vertex_count());
  model.rig->evaluate(pose, posed);
  PictureFrame seen = frame;
  if (model.front_yaw_degrees != 0) {
    // The model's own front faces the eye.
    const double yaw = base::radians(model.front_yaw_degrees);
    const double c = base::cos(yaw), s = base::sin(yaw);
    const auto turned = [&](const ModelPoint& p) { return ModelPoint{c * p.x - s * p.z, p.y, s * p.x + c * p.z}; };
    for (ModelPoint& p : posed) p = turned(p);
    seen.middle = turned(frame.middle);
  }
  return surface_picture(posed, model.mesh->triangles(), seen, px);
}

}  // namespace penpose::app
