#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::geometry {

/// Where a ray meets a triangle: distance along the ray in units of its direction's length, and barycentric coordinates
/// of the corners in order (each >= 0, sum one).
struct RayHit {
  double distance = 0;
  std::uint32_t triangle = 0;
  std::array<double, 3> barycentric{1, 0, 0};
};

/// A hierarchy of boxes over the triangles of a mesh. Built once for a mesh; after the mesh has moved it is refitted,
/// which keeps the tree and updates its boxes. Triangles count from both sides. The test of a single triangle is
/// watertight (Woop, Benthin and Wald 2013) in double precision: a ray through a shared edge never slips between its
/// two triangles. Of several hits at exactly one distance the lowest-numbered triangle wins.
class TriangleBvh {
 public:
  static constexpr std::uint32_t k_no_hint = 0xffffffffU;

  /// For many rays, or quickly for those of one stroke. The answers are the same.
  enum class Build : std::uint8_t { careful, quick };
  /// Precondition: every index is below positions.size(); the positions are finite.
  TriangleBvh(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
              Build build = Build::careful);

  /// Updates all boxes. Precondition: as many positions as at the start.
  void refit(std::span<const glm::vec3> positions);

  /// The nearest hit in front of the ray's origin. `hint`, a triangle that is likely to be hit (the one under the pen a
  /// moment ago), makes the search faster and never changes its result.
  [[nodiscard]] std::optional<RayHit> nearest_hit(const Ray& ray, std::uint32_t hint = k_no_hint) const;

  [[nodiscard]] std::size_t triangle_count() const { return slot_of_.size(); }
  /// Bytes in use, for reports.
  [[nodiscard]] std::size_t memory() const;

 private:
  /// Boxes of up to four children, one lane each. A child below k_leaf is a node, with it a block of triangles.
  struct alignas(64) Node {
    std::array<std::array<float, 4>, 3> minimum;
    std::array<std::array<float, 4>, 3> maximum;
    std::array<std::uint32_t, 4> child;
  };
  /// Up to four triangles: corner, axis, lane; copied from the mesh so that a test reads one place. Unused lanes repeat
  /// lane 0.
  struct alignas(16) Block {
    std::array<std::array<std::array<float, 4>, 3>, 3> corner;
    std::array<std::uint32_t, 4> triangle;
  };
  static constexpr std::uint32_t k_leaf = 0x80000000U;
  static constexpr std::uint32_t k_empty = 0xffffffffU;

  struct Builder;
  struct Query;

  void load_block(Block& block, std::span<const glm::vec3> positions) const;
  static void test_block(const Block& block, Query& query);

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Node> nodes_;  ///< children come after their parent
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> slot_of_;  ///< block of every triangle
  float extent_ = 0;                    ///< largest coordinate, which bounds the rounding of a box test
};

}  // namespace penpose::geometry
