#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::geometry {

/// The place of a surface that is nearest to a point.
struct ClosestPoint {
  ModelPoint point;
  std::uint32_t triangle = 0;
  std::array<double, 3> barycentric{1, 0, 0};
  double distance = 0;  ///< >= 0
  /// Unit normal there: of the face, or at an edge or a corner the angle-weighted sum of the faces around, which tells
  /// inside from outside at every point (Baerentzen and Aanaes 2005).
  ModelVector normal{0, 0, 1};
};

/// Answers closest-point queries on a triangle mesh in double precision. Never changes; safe to share.
class ClosestPointTree {
 public:
  /// Precondition: at least one triangle; every index is below positions.size(); the positions are finite. Corners that
  /// are one vertex must carry one index, else the normals at their edges are those of single faces.
  ClosestPointTree(std::span<const ModelPoint> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

  /// Of several triangles at exactly one distance the lowest-numbered one wins.
  [[nodiscard]] ClosestPoint closest(const ModelPoint& point) const;
  /// Distance to the surface, negative behind it (against the normal).
  [[nodiscard]] double signed_distance(const ModelPoint& point) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< of the leaf's triangles in order_, or the left child (the right one follows it)
    std::uint32_t count = 0;  ///< 0: an inner node
  };

  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);
  void make_normals();
  [[nodiscard]] ModelVector normal_at(std::uint32_t triangle, const std::array<double, 3>& barycentric) const;

  std::vector<ModelPoint> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<ModelPoint> centers_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  std::vector<ModelVector> face_normals_;
  std::vector<ModelVector> corner_normals_;               ///< one a vertex
  std::vector<std::array<ModelVector, 3>> edge_normals_;  ///< of a triangle's edge opposite corner i
};

}  // namespace penpose::geometry
