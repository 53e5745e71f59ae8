#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "core/articulation/region/patch.h"

namespace penpose::articulation {

/// Relaxes a moved patch where it is torn. There are two steps, both on the positions of its nodes, and neither moves a
/// fixed node: `limit_stretch` pulls together the ends of edges that are too long (strain limiting after Provot 1995,
/// position based dynamics of Mueller et al. 2007); `unfold` brings the surroundings of folds as near to a rigid motion
/// of their rest shape as their neighbours allow (Sorkine and Alexa 2007), which removes the folds.
class Relaxation {
 public:
  /// `give` 0..1, one an inner node: how much it yields to stretch, 0 for fixed nodes. Nodes of the rim are fixed.
  Relaxation(const Patch& patch, std::vector<double> give);

  /// Sweeps over the edges until none is longer than `bound` times its length at rest, at most `sweeps` times. True
  /// when none is.
  bool limit_stretch(double bound, int sweeps, std::span<ModelPoint> places);
  /// Brings the marked nodes (1) as near to rigid motions of their rest shape as may be, in `sweeps` sweeps; `stiff`
  /// nodes (1) have priority.
  void unfold(std::span<const std::uint8_t> stiff, std::span<const std::uint8_t> marked, int sweeps,
              std::span<ModelPoint> places);

 private:
  struct Neighbour {
    std::uint32_t node = 0;
    double says = 1;  ///< the shorter the edge the more
  };
  struct Edge {
    std::array<std::uint32_t, 2> ends{};
    double length = 0;
  };
  [[nodiscard]] std::span<const Neighbour> around(std::uint32_t node) const {
    return std::span(neighbours_).subspan(begins_[node], begins_[node + 1] - begins_[node]);
  }

  const Patch& patch_;
  std::vector<double> give_;  ///< one a node
  std::vector<Edge> edges_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> edges_about_;  ///< those of every node, beginning at edge_begins_
  std::vector<std::uint32_t> edge_begins_;
  /// Edges to check, a bit each: in a sweep only edges with a moved end can have become too long.
  std::vector<std::uint64_t> waiting_;
  // Of `unfold`, kept for their memory: the rotation of every node, and whether it has been found.
  std::vector<glm::dquat> turns_;
  std::vector<glm::dmat3> matrices_;
  std::vector<std::uint8_t> turned_;
  std::vector<std::uint32_t> found_;
};

}  // namespace penpose::articulation
