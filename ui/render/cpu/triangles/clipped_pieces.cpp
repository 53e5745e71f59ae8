#include "ui/render/cpu/triangles/clipped_pieces.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace penpose::render {
namespace {

struct Cut {
  glm::dvec3 seen;   ///< in the camera's space
  glm::dvec3 share;  ///< of the triangle's corners
};

}  // namespace

void add_pieces(const Raster& raster, std::span<const glm::vec3> positions, const mesh::Triangle& triangle,
                std::uint32_t item, std::vector<Piece>& pieces) {
  std::vector<Cut> shape;
  for (int k = 0; k < 3; ++k) {
    const glm::vec3 p = raster.in_view(positions[triangle[static_cast<std::size_t>(k)]]);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
    glm::dvec3 share(0);
    share[k] = 1;
    shape.push_back({glm::dvec3(p), share});
  }
  // A border a px outside the picture is never seen. With z towards the eye, a plane through it keeps what has
  // normal . p + offset >= 0.
  const double x = 1.0 / static_cast<double>(raster.view.to_clip[0][0]) * (1.0 + 4.0 / raster.size.width);
  const double y = 1.0 / static_cast<double>(raster.view.to_clip[1][1]) * (1.0 + 4.0 / raster.size.height);
  const glm::dvec4 planes[5] = {
      {0, 0, -1, -static_cast<double>(raster.near())}, {1, 0, -x, 0}, {-1, 0, -x, 0}, {0, 1, -y, 0}, {0, -1, -y, 0}};
  std::vector<Cut> kept;
  for (const glm::dvec4& plane : planes) {
    kept.clear();
    const auto height = [&](const Cut& cut) { return glm::dot(glm::dvec3(plane), cut.seen) + plane.w; };
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Cut& a = shape[i];
      const Cut& b = shape[(i + 1) % shape.size()];
      const double ha = height(a);
      const double hb = height(b);
      if (ha >= 0) kept.push_back(a);
      if ((ha >= 0) == (hb >= 0)) continue;
      const double t = ha / (ha - hb);
      kept.push_back({a.seen + (b.seen - a.seen) * t, a.share + (b.share - a.share) * t});
    }
    std::swap(shape, kept);
    if (shape.size() < 3) return;
  }
  const auto corner = [&](const Cut& cut) {
    const glm::dvec2 px = raster.px(cut.seen);
    return Corner{static_cast<std::int32_t>(std::floor(px.x * k_subpixels + 0.5)),
                  static_cast<std::int32_t>(std::floor(px.y * k_subpixels + 0.5)),
                  static_cast<float>(1.0 / -cut.seen.z)};
  };
  for (std::size_t i = 1; i + 1 < shape.size(); ++i) {
    Piece piece;
    piece.item = item;
    const Cut* const three[3] = {&shape[0], &shape[i], &shape[i + 1]};
    for (std::size_t k = 0; k < 3; ++k) {
      piece.corners[k] = corner(*three[k]);
      piece.shares[k] = glm::vec3(three[k]->share);
    }
    pieces.push_back(piece);
  }
}

}  // namespace penpose::render
