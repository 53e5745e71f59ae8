#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/quad_mesh.h"

namespace penpose::mesh {

/// The edges of quads as halfedges. What is numbered, and where the ring of a vertex starts, follows from the order in
/// which quads are added and from nothing else: sums over rings are rounded in that order, and every recorded state of
/// the built-in head hangs on it. The way faces are added one by one, borders linked around every vertex, is that of
/// Botsch, Steinberg, Bischoff and Kobbelt, "OpenMesh - a generic and efficient polygon mesh data structure" (2002).
class Halfedges {
 public:
  using Id = std::uint32_t;
  static constexpr Id k_none = 0xffffffffU;

  explicit Halfedges(std::size_t vertices) : outgoing_(vertices, k_none) {}

  /// Adds one more quad, with indices in range and none twice. False, and the quad is not there, where the mesh would
  /// be no manifold.
  bool add(const Quad& quad);

  [[nodiscard]] std::size_t edge_count() const { return all_.size() / 2; }
  /// Halfedge 2e of edge e runs as the first quad with that edge does; 2e + 1 against it.
  [[nodiscard]] static Id opposite(Id halfedge) { return halfedge ^ 1U; }
  [[nodiscard]] Id next(Id halfedge) const { return all_[halfedge].next; }
  [[nodiscard]] Id end(Id halfedge) const { return all_[halfedge].end; }
  /// The quad to its left; k_none at a border.
  [[nodiscard]] Id face(Id halfedge) const { return all_[halfedge].face; }
  [[nodiscard]] bool is_border(Id halfedge) const { return face(halfedge) == k_none; }
  /// The halfedge from which the ring of a vertex starts, along a border if it has one; k_none where no quad is.
  [[nodiscard]] Id outgoing(Id vertex) const { return outgoing_[vertex]; }
  /// The next halfedge away from the same vertex, clockwise.
  [[nodiscard]] Id turned(Id halfedge) const { return next(opposite(halfedge)); }
  /// The halfedge between two vertices, or k_none.
  [[nodiscard]] Id find(Id from, Id to) const;

 private:
  struct Halfedge {
    Id end = k_none;
    Id face = k_none;
    Id next = k_none;
    Id previous = k_none;
  };
  struct Link {
    Id from;
    Id to;
  };

  Id add_edge(Id from, Id to);
  void link(Id from, Id to);
  [[nodiscard]] std::optional<std::vector<Link>> joined_borders(const std::vector<Id>& sides) const;

  std::vector<Halfedge> all_;
  std::vector<Id> outgoing_;
  Id faces_ = 0;
};

}  // namespace penpose::mesh
