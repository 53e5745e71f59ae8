#include "core/articulation/region/region.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <string>

#include "core/articulation/region/under_stroke.h"
#include "core/geometry/bvh.h"
#include "core/geometry/lasso.h"

namespace penpose::articulation {
namespace {

/// Nearer to the camera than that, as a share of the distance, is in front.
constexpr double k_in_front = 1e-4;
constexpr std::size_t k_scrap = 10;  // the paper: a component of this many vertices or fewer is not meant

/// Sets of vertices that are joined by edges; each is named by its lowest vertex.
class Joined {
 public:
  explicit Joined(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Takes away what the camera does not see: vertices of which no triangle faces it, or that something lies in front of.
void keep_seen(const Canvas& canvas, const geometry::Camera& camera, std::vector<char>& inside) {
  const auto positions = canvas.positions();
  const auto weld = canvas.mesh().weld();
  std::vector<char> faces(positions.size(), 0);
  std::vector<mesh::Triangle> about;
  std::vector<PxPoint> drawn;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (inside[v] != 0) drawn.push_back(*camera.project(positions[v]));
  }
  if (drawn.empty()) return;
  about = triangles_under(canvas, camera, drawn);
  for (const mesh::Triangle& t : about) {
    const ModelPoint& a = positions[t[0]];
    const ModelVector normal = glm::cross(positions[t[1]] - a, positions[t[2]] - a);
    if (!(glm::dot(normal, camera.eye() - a) > 0.0)) continue;
    for (const std::uint32_t v : t) faces[weld[v]] = 1;
  }
  std::vector<glm::vec3> places;
  places.reserve(positions.size());
  for (const ModelPoint& p : positions) places.emplace_back(p);
  const geometry::TriangleBvh tree(places, about, geometry::TriangleBvh::Build::quick);
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (inside[v] == 0) continue;
    const ModelVector way = positions[v] - camera.eye();
    const double far = geometry::length(way);
    const auto hit = tree.nearest_hit({camera.eye(), geometry::normalized(way, camera.forward())});
    const bool hidden = hit && hit->distance < (1.0 - k_in_front) * far;
    if (faces[weld[v]] == 0 || hidden) inside[v] = 0;
  }
}

struct Component {
  std::size_t vertices = 0;
  bool moves = false;  ///< not all of it is the surface that others slide over
  double nearest = std::numeric_limits<double>::infinity();
};

}  // namespace

base::Result<Region> general_region(const Canvas& canvas, const geometry::Camera& camera,
                                    std::span<const PxPoint> lasso_px, const KeptSurface& surface, Borders borders,
                                    const Taken& taken) {
  const auto lasso = geometry::Lasso::make(lasso_px);
  if (!lasso) return lasso.error();
  const auto positions = canvas.positions();
  const auto weld = canvas.mesh().weld();
  std::vector<char> inside(positions.size(), 0);
  std::vector<PxPoint> seen(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const auto px = camera.project(positions[v]);
    if (!px) continue;
    seen[v] = *px;
    inside[v] = lasso->contains(*px) ? 1 : 0;
  }
  if (taken.reach == Reach::front) keep_seen(canvas, camera, inside);
  Joined joined(positions.size());
  for (const mesh::Triangle& triangle : canvas.mesh().triangles()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i];
      const std::uint32_t b = triangle[(i + 1) % 3];
      if (inside[a] != 0 && inside[b] != 0) joined.join(weld[a], weld[b]);
    }
  }
  std::vector<Component> components(positions.size());
  bool any = false;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (inside[v] == 0) continue;
    any = true;
    Component& component = components[joined.find(weld[v])];
    ++component.vertices;
    component.moves = component.moves || !surface.consists_of(v, positions[v]);
    component.nearest = std::min(component.nearest, geometry::distance(positions[v], camera.eye()));
  }
  if (!any) return base::Error{"no part of the model lies inside the curve", "", "draw around a part of the model"};
  std::vector<const Component*> meant;
  bool surface_alone = false;
  for (const Component& component : components) {
    if (component.vertices <= k_scrap) continue;
    surface_alone = surface_alone || !component.moves;
    if (component.moves) meant.push_back(&component);
  }
  std::stable_sort(meant.begin(), meant.end(),
                   [](const Component* a, const Component* b) { return a->nearest < b->nearest; });
  if (!meant.empty() && taken.piece >= meant.size()) {
    return base::Error{"the curve encloses " + std::to_string(meant.size()) +
                           (meant.size() == 1 ? " piece" : " pieces") + " of the model and no more",
                       "piece", "take one of them, numbered from 0"};
  }
  const Component* chosen = meant.empty() ? nullptr : meant[taken.piece];
  if (chosen == nullptr && surface_alone) {
    return base::Error{"what lies inside the curve belongs to the surface that is kept", "",
                       "draw around what moves over it, or give a smaller sphere"};
  }
  if (chosen == nullptr) {
    return base::Error{"no connected piece inside the curve has more than 10 vertices", "",
                       "draw around a larger part of the model"};
  }
  const auto name = static_cast<std::uint32_t>(chosen - components.data());
  Region region;
  region.pieces = static_cast<std::uint32_t>(meant.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (inside[v] == 0 || joined.find(weld[v]) != name) continue;
    region.vertices.push_back(v);
    region.seen.push_back(seen[v]);
    if (borders == Borders::measured) region.border_px.push_back(lasso->distance(seen[v]));
  }
  return region;
}

base::Status check_crossing(std::span<const PxPoint> lasso_px) {
  constexpr int k_cells = 48;
  constexpr double k_unlike = 0.35;
  const auto lasso = geometry::Lasso::make(lasso_px);
  if (!lasso) return lasso.error();
  PxPoint least = lasso_px[0];
  PxPoint most = lasso_px[0];
  double turned = 0;
  for (std::size_t i = 0; i < lasso_px.size(); ++i) {
    const PxPoint& a = lasso_px[i];
    const PxPoint& b = lasso_px[(i + 1) % lasso_px.size()];
    turned += 0.5 * (a.x * b.y - b.x * a.y);
    least = {std::min(least.x, a.x), std::min(least.y, a.y)};
    most = {std::max(most.x, a.x), std::max(most.y, a.y)};
  }
  const PxPoint cell = (most - least) * (1.0 / k_cells);
  double inside = 0;
  for (int r = 0; r < k_cells; ++r) {
    for (int c = 0; c < k_cells; ++c) {
      if (lasso->contains(least + PxPoint{(c + 0.5) * cell.x, (r + 0.5) * cell.y})) inside += cell.x * cell.y;
    }
  }
  if (std::abs(std::abs(turned) - inside) <= k_unlike * std::max(std::abs(turned), inside)) return base::Done{};
  return base::Error{"the curve crosses itself, so that it is not known what it encloses", "",
                     "draw once around the part, without crossing the line"};
}

base::Error core_outside(const Region& region, std::span<const PxPoint> lasso) {
  PxPoint way;
  for (const PxPoint& p : lasso) way = way + p * (1.0 / static_cast<double>(lasso.size()));
  for (const PxPoint& p : region.seen) way = way - p * (1.0 / static_cast<double>(region.seen.size()));
  const bool beside = std::abs(way.x) > std::abs(way.y);
  const char* side = beside ? (way.x > 0.0 ? "right of" : "left of") : (way.y > 0.0 ? "below" : "above");
  return {std::string("nothing that the first line took lies inside the second line, which is ") + side +
              " the middle of the first",
          "", "draw it inside the first line, around a part of the model"};
}

base::Result<Weights> specific_region(const Region& region, std::span<const PxPoint> lasso_px) {
  const auto lasso = geometry::Lasso::make(lasso_px);
  if (!lasso) return lasso.error();
  Weights result;
  for (std::uint32_t i = 0; i < region.vertices.size(); ++i) {
    if (lasso->contains(region.seen[i])) {
      result.specific.push_back(i);
      result.weights.push_back(1.0);
      continue;
    }
    const double g = region.border_px[i];
    result.weights.push_back(g > 0.0 ? g / (g + lasso->distance(region.seen[i])) : 0.0);
  }
  if (result.specific.empty()) {
    return base::Error{"nothing that the first line took lies inside the second line", "",
                       "draw it inside the first line, around a part of the model"};
  }
  return result;
}

}  // namespace penpose::articulation
