#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::intent {

/// Where a surface faces another part of itself from near, as lips do along their seam, and how far each control
/// presses both into each other. A control that brings lips together only after another has parted them drives them
/// through each other on its own.
class Contacts {
 public:
  Contacts() = default;
  /// Finds the pairs at rest: vertices that shapes move (`moved`, one a vertex), whose normals are against each other.
  /// None where nothing moves.
  Contacts(const mesh::TriangleMesh& mesh, std::span<const geometry::ModelPoint> rest, const std::vector<bool>& moved);

  /// The vertices of all pairs.
  [[nodiscard]] std::span<const std::uint32_t> vertices() const { return vertices_; }
  /// Adds the next control. `rest`, `there`: the places of vertices(); empty: it moves nothing. `per`: times their way,
  /// for its whole range.
  void add(std::span<const geometry::ModelPoint> rest, std::span<const geometry::ModelPoint> there, double per);
  /// How deep the whole range of a control brings surfaces into each other from rest: 98 of 100 pairs are less deep. A
  /// share of the size of what shapes move; 0 without pairs.
  [[nodiscard]] double depth(std::size_t control) const { return depths_[control]; }
  /// The same from `pose` (shares of ranges from rest, one a control), where others may have parted them.
  [[nodiscard]] double depth(std::size_t control, std::span<const double> pose) const;

 private:
  struct Pair {
    std::size_t a = 0, b = 0;         ///< of vertices_
    geometry::ModelVector normal{0};  ///< of a
    double gap = 0;                   ///< along it, model units
  };
  [[nodiscard]] double depth_of(std::vector<double>& by_pair) const;

  double size_ = 0;  ///< of what shapes move, model units
  std::vector<std::uint32_t> vertices_;
  std::vector<Pair> pairs_;
  std::vector<std::vector<float>> closings_;  ///< one a control, one a pair, model units; empty: none
  std::vector<double> depths_;                ///< one a control
};

}  // namespace penpose::intent
