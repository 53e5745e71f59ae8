#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

[[nodiscard]] inline double square_of(const geometry::ModelVector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

/// Spatial index of a model's vertices at rest.
class Surroundings {
 public:
  /// `pieces`: for each vertex the number of the connected piece of the surface that it belongs to; empty: one piece.
  explicit Surroundings(std::vector<geometry::ModelPoint> rest, std::vector<std::uint32_t> pieces = {});

  [[nodiscard]] std::span<const geometry::ModelPoint> rest() const { return rest_; }
  /// The vertices within `reach` (model units) of one of the places, ascending; where there are more than `most`, that
  /// many of them, evenly by number. `pieces`: only vertices of these, ascending; empty: all.
  [[nodiscard]] std::vector<std::uint32_t> near(std::span<const geometry::ModelPoint> places, double reach,
                                                std::size_t most, std::span<const std::uint32_t> pieces = {}) const;
  /// The piece of a vertex; 0 where it is not known.
  [[nodiscard]] std::uint32_t piece(std::uint32_t vertex) const { return pieces_.empty() ? 0 : pieces_[vertex]; }

 private:
  std::vector<geometry::ModelPoint> rest_;
  std::vector<std::uint32_t> pieces_;
  std::vector<std::uint32_t> by_x_;            ///< finite ones, ascending by x, then by number
  std::vector<geometry::ModelPoint> ordered_;  ///< their positions, in that order
};

}  // namespace penpose::intent
