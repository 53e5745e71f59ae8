#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/region/region.h"

namespace penpose::articulation {

/// The surface of a region of general interest as a small mesh of its own: its vertices, welded, and around them the
/// rim, the neighbouring vertices that stay where they are. Nodes of the region come first, those of the rim after
/// them.
class Patch {
 public:
  /// It includes two rings of triangles outside of the region, so that the rim's own surroundings are known.
  Patch(const Canvas& canvas, const Region& region);

  /// Number of nodes of the region, and of all with the rim.
  [[nodiscard]] std::size_t inner_count() const { return inner_count_; }
  [[nodiscard]] std::size_t node_count() const { return rests_.size(); }
  [[nodiscard]] std::span<const ModelPoint> rests() const { return rests_; }
  /// A vertex of the mesh that the node represents.
  [[nodiscard]] std::uint32_t vertex(std::uint32_t node) const { return vertices_[node]; }
  /// The node of each vertex of the region, in the region's order.
  [[nodiscard]] std::span<const std::uint32_t> nodes() const { return nodes_; }
  /// Triangles that touch the region.
  [[nodiscard]] std::span<const mesh::Triangle> triangles() const { return triangles_; }
  /// The triangles around a node.
  [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t node) const {
    return std::span(stars_).subspan(star_begins_[node], star_begins_[node + 1] - star_begins_[node]);
  }

 private:
  std::size_t inner_count_ = 0;
  std::vector<ModelPoint> rests_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint32_t> nodes_;
  std::vector<mesh::Triangle> triangles_;
  std::vector<std::uint32_t> stars_;
  std::vector<std::uint32_t> star_begins_;
};

}  // namespace penpose::articulation
