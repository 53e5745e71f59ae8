#include "ui/render/cpu/ghost_veil.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "ui/render/cpu/mixing.h"
#include "ui/render/cpu/triangles/triangle_raster.h"

namespace penpose::render {
namespace {

/// A face lets so much of what is behind it through where it looks at the eye, and less where it turns away.
constexpr float k_veil_alpha = 0.32F, k_veil_edge_alpha = 0.6F;
/// How much of its colour is its tint.
constexpr float k_tinted = 0.6F;
constexpr float k_veil_others = 0.4F;
constexpr float k_no_depth = 0.0F;

/// A vertex of a ghost in the picture.
struct VeilVertex {
  Corner corner;
  float facing = 1;  ///< how much it looks at the eye, 0..1
  float apart = 0;   ///< ghost_apart
  bool seen = false;
};

/// What is nearest at each px of one ghost.
struct VeilLayer {
  std::vector<float> depth, facing, apart;
  explicit VeilLayer(std::size_t px) : depth(px, k_no_depth), facing(px), apart(px) {}
};

std::vector<glm::vec3> veil_normals(const mesh::TriangleMesh& mesh, std::span<const glm::vec3> positions) {
  const auto weld = mesh.weld();
  std::vector<glm::vec3> normals(positions.size(), glm::vec3(0));
  for (const mesh::Triangle& t : mesh.triangles()) {
    const glm::vec3 normal = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t v : t) normals[weld[v]] += normal;
  }
  for (glm::vec3& normal : normals) {
    const float length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::vec3(0, 0, 1);
  }
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = normals[weld[v]];
  return normals;
}

std::vector<VeilVertex> veil_vertices(const Ghost& ghost, std::span<const glm::vec3> normals,
                                      std::span<const glm::vec3> now, const geometry::Camera& camera, float scale) {
  std::vector<VeilVertex> out(ghost.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const geometry::ModelPoint at(ghost.positions[v]);
    const auto px = camera.project(at);
    const auto was = camera.project(geometry::ModelPoint(now[v]));
    if (!px || !was || std::abs(px->x) > 1e5 || std::abs(px->y) > 1e5) continue;
    VeilVertex& made = out[v];
    made.seen = true;
    made.corner = {static_cast<std::int32_t>(std::lround(0.5 * px->x * k_subpixels)),
                   static_cast<std::int32_t>(std::lround(0.5 * px->y * k_subpixels)),
                   static_cast<float>(1.0 / camera.depth(at))};
    made.apart = ghost_apart(geometry::distance(*px, *was), scale);
    const glm::vec3 way(at - camera.eye());
    const float far = glm::length(way);
    if (far > 0) made.facing = std::min(1.0F, std::abs(glm::dot(normals[v], way)) / far);
  }
  return out;
}

/// The plane of a value of the corners. Precondition: as depth_plane.
PxPlane veil_plane(Corners corners, std::int64_t area, const std::array<float, 3>& values) {
  for (std::size_t k = 0; k < 3; ++k) corners[k].inverse_depth = values[k];
  return depth_plane(corners, area);
}

VeilLayer veil_layer(const mesh::TriangleMesh& mesh, const std::vector<VeilVertex>& vertices, const Image& image) {
  const PxRect all{0, 0, image.width, image.height};
  VeilLayer layer(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (mesh::Triangle t : mesh.triangles()) {
    if (!vertices[t[0]].seen || !vertices[t[1]].seen || !vertices[t[2]].seen) continue;
    Corners corners{vertices[t[0]].corner, vertices[t[1]].corner, vertices[t[2]].corner};
    std::int64_t area = twice_area(corners);
    if (area == 0) continue;
    if (area < 0) {
      std::swap(corners[1], corners[2]);
      std::swap(t[1], t[2]);
      area = -area;
    }
    const auto of = [&](float VeilVertex::*member) {
      return veil_plane(corners, area, {vertices[t[0]].*member, vertices[t[1]].*member, vertices[t[2]].*member});
    };
    const PxPlane depth = depth_plane(corners, area);
    const PxPlane facing = of(&VeilVertex::facing);
    const PxPlane apart = of(&VeilVertex::apart);
    visit_inside(corners, all, [&](int x, int y) {
      const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      const float near = depth.at(x, y);
      if (near <= layer.depth[at]) return;
      layer.depth[at] = near;
      layer.facing[at] = facing.at(x, y);
      layer.apart[at] = apart.at(x, y);
    });
  }
  return layer;
}

/// Lays a ghost, as it looks, over those that are there. True: something of it is seen.
bool lay(const VeilLayer& layer, const Image& face, const Color& tint, Image& image) {
  const std::array<float, 3> color{encode_srgb(tint.r) * 255.0F, encode_srgb(tint.g) * 255.0F,
                                   encode_srgb(tint.b) * 255.0F};
  bool any = false;
  for (std::size_t at = 0; at < layer.depth.size(); ++at) {
    if (layer.depth[at] == k_no_depth) continue;
    const float facing = std::clamp(layer.facing[at], 0.0F, 1.0F);
    const float apart = std::clamp(layer.apart[at], 0.0F, 1.0F);
    const float over = tint.a * apart * mixed(k_veil_edge_alpha, k_veil_alpha, facing);
    if (over < 1.0F / 255.0F) continue;
    any = true;
    const std::uint8_t* const seen = face.pixels.data() + 4 * at;
    std::uint8_t* const out = image.pixels.data() + 4 * at;
    const float under = static_cast<float>(out[3]) / 255.0F * (1 - over);
    for (std::size_t c = 0; c < 3; ++c) {
      const float own = mixed(static_cast<float>(seen[c]), color[c], k_tinted);
      out[c] = static_cast<std::uint8_t>((own * over + static_cast<float>(out[c]) * under) / (over + under));
    }
    out[3] = static_cast<std::uint8_t>(255.0F * (over + under));
  }
  return any;
}

/// From which column on each row has something, and up to, but without, which one.
std::vector<std::pair<int, int>> veiled_columns(const Image& veil) {
  std::vector<std::pair<int, int>> columns(static_cast<std::size_t>(veil.height), {veil.width, 0});
  for (int y = 0; y < veil.height; ++y) {
    auto& [left, right] = columns[static_cast<std::size_t>(y)];
    for (int x = 0; x < veil.width; ++x) {
      if (veil.at(x, y)[3] == 0) continue;
      left = std::min(left, x);
      right = x + 1;
    }
  }
  return columns;
}

}  // namespace

void lay_veil(const Image& veil, Image& picture) {
  const std::vector<std::pair<int, int>> seen = veiled_columns(veil);
  for (int y = 0; y < picture.height; ++y) {
    // Between the middles of rows of the veil, a quarter of the way from the nearest one.
    const int near_y = std::min(y / 2, veil.height - 1);
    const int far_y = std::clamp(near_y + (y % 2 == 0 ? -1 : 1), 0, veil.height - 1);
    const std::array<const std::uint8_t*, 2> rows{veil.at(0, near_y), veil.at(0, far_y)};
    const auto [left, right] = std::pair{
        std::min(seen[static_cast<std::size_t>(near_y)].first, seen[static_cast<std::size_t>(far_y)].first),
        std::max(seen[static_cast<std::size_t>(near_y)].second, seen[static_cast<std::size_t>(far_y)].second)};
    for (int x = std::max(0, 2 * left - 1); x < std::min(picture.width, 2 * right + 1); ++x) {
      const int near_x = std::min(x / 2, veil.width - 1);
      const int far_x = std::clamp(near_x + (x % 2 == 0 ? -1 : 1), 0, veil.width - 1);
      const std::array<const std::uint8_t*, 4> px{rows[0] + 4 * near_x, rows[0] + 4 * far_x, rows[1] + 4 * near_x,
                                                  rows[1] + 4 * far_x};
      const std::array<unsigned, 4> alpha{9U * px[0][3], 3U * px[1][3], 3U * px[2][3], 1U * px[3][3]};
      const unsigned all = alpha[0] + alpha[1] + alpha[2] + alpha[3];
      if (all == 0) continue;
      std::uint8_t* const out = px_of(picture, x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        const unsigned sum = alpha[0] * px[0][c] + alpha[1] * px[1][c] + alpha[2] * px[2][c] + alpha[3] * px[3][c];
        out[c] = static_cast<std::uint8_t>((sum + (16U * 255U - all) * out[c]) / (16U * 255U));
      }
    }
  }
}

GhostVeil::GhostVeil() {
  renderer_.set_occlusion(false);
  renderer_.set_smoothing(true);
}

std::shared_ptr<const Image> GhostVeil::draw(std::span<const Ghost> ghosts, const VeiledModel& model,
                                             const geometry::Camera& camera, const GhostInk& ink) {
  auto image = std::make_shared<Image>();
  image->width = (camera.viewport().width + 1) / 2;
  image->height = (camera.viewport().height + 1) / 2;
  // Clear px are grey, so that no dark rim comes where they are blended with others.
  image->pixels.assign(4 * static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height), 0x90);
  for (std::size_t at = 3; at < image->pixels.size(); at += 4) image->pixels[at] = 0;
  const auto half = geometry::Camera::make(camera.pose(), {image->width, image->height});
  if (!half) return nullptr;
  bool any = false;
  for (const std::size_t g : farthest_first(ghosts)) {
    const Ghost& ghost = ghosts[g];
    if (ghost.positions.size() != model.now.size()) continue;
    const std::vector<glm::vec3> normals = veil_normals(model.mesh, ghost.positions);
    Scene scene;
    scene.positions = ghost.positions;
    scene.normals = normals;
    scene.triangles = model.mesh.triangles();
    scene.appearance = &model.appearance;
    scene.shape_number = model.shape_number;
    if (!renderer_.draw(scene, *half, face_)) continue;
    Color tint = ghost_color(ghost.moment);
    if (ink.lit && ink.lit->ghost != g) tint.a *= k_veil_others;
    const auto vertices = veil_vertices(ghost, normals, model.now, camera, ink.scale);
    any |= lay(veil_layer(model.mesh, vertices, *image), face_, tint, *image);
  }
  return any ? image : nullptr;
}

}  // namespace penpose::render
