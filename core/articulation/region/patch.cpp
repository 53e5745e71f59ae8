#include "core/articulation/region/patch.h"

namespace penpose::articulation {

Patch::Patch(const Canvas& canvas, const Region& region) {
  constexpr int k_rings = 2;
  constexpr std::uint32_t k_none = ~0U;
  const auto weld = canvas.mesh().weld();
  std::vector<std::uint32_t> node_of(canvas.positions().size(), k_none);
  const auto add = [&](std::uint32_t v) {
    std::uint32_t& node = node_of[weld[v]];
    if (node == k_none) {
      node = static_cast<std::uint32_t>(rests_.size());
      rests_.push_back(canvas.positions()[v]);
      vertices_.push_back(v);
    }
    return node;
  };
  nodes_.reserve(region.vertices.size());
  for (const std::uint32_t v : region.vertices) nodes_.push_back(add(v));
  inner_count_ = rests_.size();
  std::size_t before = 0;
  for (int ring = 0; ring < k_rings; ++ring) {
    const std::size_t reached = rests_.size();
    for (const mesh::Triangle& t : canvas.mesh().triangles()) {
      const auto within = [&](std::size_t end) {
        return node_of[weld[t[0]]] < end || node_of[weld[t[1]]] < end || node_of[weld[t[2]]] < end;
      };
      if (!within(reached) || within(before)) continue;
      const mesh::Triangle triangle{add(t[0]), add(t[1]), add(t[2])};
      // Welding may leave a triangle without a surface.
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
      triangles_.push_back(triangle);
    }
    before = reached;
  }
  star_begins_.assign(rests_.size() + 1, 0);
  for (const mesh::Triangle& t : triangles_) {
    for (const std::uint32_t node : t) ++star_begins_[node + 1];
  }
  for (std::size_t i = 1; i < star_begins_.size(); ++i) star_begins_[i] += star_begins_[i - 1];
  stars_.resize(star_begins_.back());
  std::vector<std::uint32_t> next(star_begins_.begin(), star_begins_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (const std::uint32_t node : triangles_[i]) stars_[next[node]++] = i;
  }
}

}  // namespace penpose::articulation
