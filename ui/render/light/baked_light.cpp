#include "ui/render/light/baked_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/bvh.h"
#include "core/rig/surface_poser.h"

namespace penpose::render {
namespace {

/// Directions on a whole ball, of which a vertex takes those on its side: neighbours take nearly the same, so that the
/// shade is smooth where the surface is.
constexpr int k_directions = 64;
/// Rays for all vertices together.
constexpr double k_most_rays = 2e6;
/// Shares of the model's diagonal: how far shade reaches, and how far from the surface rays begin.
constexpr double k_reach = 0.12;
constexpr double k_start = 0.0015;
/// Of the model's height: how far what stands over the ground shades it.
constexpr double k_ground_reach = 0.22;
/// Nothing is quite dark: light comes back from what is near.
constexpr double k_least_sky = 0.3;

/// Even on a ball (Fibonacci; Swinbank and Purser 2006).
std::vector<glm::dvec3> directions_on_ball(int count) {
  std::vector<glm::dvec3> all;
  const double golden = base::k_pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / count;
    const double around = std::sqrt(1.0 - y * y);
    all.emplace_back(around * base::cos(golden * i), y, around * base::sin(golden * i));
  }
  return all;
}

/// Triangles that nobody sees through.
std::vector<mesh::Triangle> shading_triangles(const document::Model& model, const Appearance& appearance) {
  const auto triangles = model.mesh->triangles();
  std::vector<bool> clear(triangles.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::size_t s =
        appearance.surface_of_vertex.empty() ? 0 : std::size_t{appearance.surface_of_vertex[triangles[t][0]]};
    clear[t] = appearance.surfaces[s].base_color.a < 1.0F;
  }
  for (const LookBatch& batch : appearance.batches) {
    const bool opaque = appearance.look->surfaces[batch.surface].alpha == document::AlphaMode::opaque;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i)
      clear[appearance.look_triangles[i]] = !opaque;
  }
  std::vector<mesh::Triangle> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!clear[t]) kept.push_back(triangles[t]);
  }
  return kept;
}

/// How much of the sky around an axis is seen, 0..1; what is nearer than `reach` hides the more the nearer it is.
double open_sky(const geometry::TriangleBvh& tree, const glm::dvec3& from, const glm::dvec3& axis, double reach,
                std::span<const glm::dvec3> directions) {
  double sum = 0;
  double open = 0;
  for (const glm::dvec3& d : directions) {
    const double weight = glm::dot(d, axis);
    if (weight <= 0.05) continue;
    sum += weight;
    const auto hit = tree.nearest_hit({from, d});
    const double far = hit ? std::min(hit->distance / reach, 1.0) : 1.0;
    open += weight * far * (2 - far);
  }
  return sum > 0 ? open / sum : 1.0;
}

void bake_ground(const geometry::TriangleBvh& tree, std::span<const glm::vec3> positions, BakedLight& light,
                 const std::atomic<bool>* stop) {
  glm::vec3 low(positions[0]);
  glm::vec3 high(positions[0]);
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double reach = k_ground_reach * static_cast<double>(high.y - low.y);
  if (!(reach > 0)) return;
  // What is high above the ground does not reach it.
  glm::vec3 left(high);
  glm::vec3 right(low);
  for (const glm::vec3& p : positions) {
    if (static_cast<double>(p.y - low.y) > 0.5 * reach) continue;
    left = glm::min(left, p);
    right = glm::max(right, p);
  }
  const glm::vec3 middle = (left + right) * 0.5F;
  light.ground = {middle.x, low.y, middle.z};
  light.half_side = std::max(right.x - left.x, right.z - left.z) * 0.5F + static_cast<float>(0.7 * reach);
  light.ground_shade.assign(static_cast<std::size_t>(BakedLight::k_ground_px) * BakedLight::k_ground_px, 0);
  const auto all = directions_on_ball(k_directions);
  const glm::dvec3 up(0, 1, 0);
  for (int row = 0; row < BakedLight::k_ground_px; ++row) {
    if (stop != nullptr && *stop) return;
    for (int column = 0; column < BakedLight::k_ground_px; ++column) {
      const double x = 2.0 * (column + 0.5) / BakedLight::k_ground_px - 1.0;
      const double z = 2.0 * (row + 0.5) / BakedLight::k_ground_px - 1.0;
      const double rim = std::clamp(2.5 * (1.0 - std::sqrt(x * x + z * z)), 0.0, 1.0);
      if (rim == 0) continue;
      const glm::dvec3 from =
          glm::dvec3(light.ground) + static_cast<double>(light.half_side) * glm::dvec3(x, 0, z) - 0.002 * reach * up;
      const double shade = (1.0 - open_sky(tree, from, up, reach, all)) * rim * rim * (3 - 2 * rim);
      light.ground_shade[static_cast<std::size_t>(row) * BakedLight::k_ground_px + static_cast<std::size_t>(column)] =
          static_cast<std::uint8_t>(shade * 255 + 0.5);
    }
  }
}

}  // namespace

std::shared_ptr<const BakedLight> bake_light(const document::Model& model, const Appearance& appearance,
                                             const std::atomic<bool>* stop) {
  const rig::SurfacePoser poser(model.rig);
  const auto positions = poser.positions();
  const auto normals = poser.normals();
  geometry::Box box;
  for (const glm::vec3& p : positions) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return nullptr;
    box.add(geometry::ModelPoint(p));
  }
  const auto triangles = shading_triangles(model, appearance);
  if (positions.empty() || triangles.empty() || !(box.diagonal() > 0)) return nullptr;
  const geometry::TriangleBvh tree(positions, triangles);
  auto light = std::make_shared<BakedLight>();
  light->sky.assign(positions.size(), 255);
  const double most = k_most_rays * 2 / static_cast<double>(positions.size());
  const auto directions = directions_on_ball(static_cast<int>(std::clamp(most, 12.0, double{k_directions})));
  const double reach = k_reach * box.diagonal();
  const auto weld = model.mesh->weld();
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (v % 256 == 0 && stop != nullptr && *stop) return nullptr;
    if (weld[v] != v) {
      light->sky[v] = light->sky[weld[v]];
      continue;
    }
    const glm::dvec3 normal(normals[v]);
    const glm::dvec3 from = glm::dvec3(positions[v]) + normal * (k_start * box.diagonal());
    const double open = open_sky(tree, from, normal, reach, directions);
    light->sky[v] = static_cast<std::uint8_t>((k_least_sky + (1 - k_least_sky) * open) * 255 + 0.5);
  }
  bake_ground(tree, positions, *light, stop);
  if (stop != nullptr && *stop) return nullptr;
  return light;
}

}  // namespace penpose::render
