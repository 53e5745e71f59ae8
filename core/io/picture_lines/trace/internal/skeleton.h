#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/io/picture_lines/trace/internal/bitmap.h"

namespace penpose::io {

/// A place of a skeleton that is no part of a line's middle: an end, or where several lines meet.
struct SkeletonNode {
  geometry::PxPoint place;
  double radius = 0;       ///< half of the width of the ink there (px)
  double reach = 0;        ///< how far (px) from the place the ink is shared by the lines that meet
  std::size_t degree = 0;  ///< how many ends of edges are here; an edge may have both
};

/// A line between two nodes, or a loop without any.
struct SkeletonEdge {
  static constexpr std::size_t k_none = static_cast<std::size_t>(-1);

  std::vector<geometry::PxPoint> points;  ///< from the first node to the second
  double radius = 0;                      ///< half of the width of the ink, the mean along it
  std::array<std::size_t, 2> nodes{k_none, k_none};

  [[nodiscard]] bool is_loop() const { return nodes[0] == k_none; }
  [[nodiscard]] double length() const;
  /// The point so far (px) along it from one of its ends, at the most its other end.
  [[nodiscard]] geometry::PxPoint along(std::size_t side, double distance) const;
};

struct Skeleton {
  std::vector<SkeletonNode> nodes;
  std::vector<SkeletonEdge> edges;
};

/// The direction, of length one, in which an edge leaves the node at one of its ends, taken outside of the ink that it
/// shares there.
[[nodiscard]] geometry::PxPoint leaving_direction(const Skeleton& skeleton, const SkeletonEdge& edge, std::size_t side);

/// The lines in the middle of what is not 0, as they are.
[[nodiscard]] Skeleton find_skeleton(Bitmap ink);

/// Takes away what comes from the width of lines alone: branches and loops that are shorter than it, and the bridges
/// between the two branchings that a crossing of wide lines becomes, as long as the ink that two lines share where they
/// cross at that angle.
void clean_up(Skeleton& skeleton);

}  // namespace penpose::io
