#include "core/articulation/region.h"

#include <limits>
#include <numeric>

#include "core/geometry/lasso.h"

namespace penpose::articulation {
namespace {

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

struct Component {
  std::size_t vertices = 0;
  bool moves = false;  ///< not all of it is the surface that others slide over
  double nearest = std::numeric_limits<double>::infinity();
};

}  // namespace

base::Result<Region> general_region(const Canvas& canvas, const geometry::Camera& camera,
                                    std::span<const PxPoint> lasso_px, const KeptSurface& surface, Borders borders) {
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
  if (!any) return base::Error{"no vertex of the model lies inside the curve", "", "draw around a part of the model"};
  const Component* chosen = nullptr;
  bool surface_alone = false;
  for (const Component& component : components) {
    if (component.vertices <= k_scrap) continue;
    surface_alone = surface_alone || !component.moves;
    if (component.moves && (chosen == nullptr || component.nearest < chosen->nearest)) chosen = &component;
  }
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
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (inside[v] == 0 || joined.find(weld[v]) != name) continue;
    region.vertices.push_back(v);
    region.seen.push_back(seen[v]);
    if (borders == Borders::measured) region.border_px.push_back(lasso->distance(seen[v]));
  }
  return region;
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
    return base::Error{"no vertex of the region of general interest lies inside the curve", "",
                       "draw it inside the first region, around at least one vertex"};
  }
  return result;
}

}  // namespace penpose::articulation
