#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

/// Places by the cells of a grid, for finding those that are near another one.
class PlaceGrid {
 public:
  /// `reach`: how far away near ones may be. Places that are no numbers are near nothing.
  PlaceGrid(std::span<const geometry::ModelPoint> places, double reach);

  /// Calls `visit` with the number of every place nearer than the reach, and of some others; of those alone whose
  /// numbers are begin..end - 1.
  template <typename Visit>
  void visit_near(const geometry::ModelPoint& place, std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    const Cells first = cells_of(place - geometry::ModelVector(reach_));
    const Cells last = cells_of(place + geometry::ModelVector(reach_));
    for (std::size_t z = first[2]; z <= last[2]; ++z) {
      for (std::size_t y = first[1]; y <= last[1]; ++y) {
        for (std::size_t x = first[0]; x <= last[0]; ++x) {
          const std::size_t cell = number_of({x, y, z});
          const auto cell_end = numbers_.begin() + first_[cell + 1];
          for (auto at = std::lower_bound(numbers_.begin() + first_[cell], cell_end, begin);
               at != cell_end && *at < end; ++at)
            visit(*at);
        }
      }
    }
  }

 private:
  using Cells = std::array<std::size_t, 3>;  ///< along x, y, z

  /// Never falls where a coordinate grows, so that a place between two others is in a cell between theirs.
  [[nodiscard]] Cells cells_of(const geometry::ModelPoint& place) const;
  [[nodiscard]] std::size_t number_of(const Cells& cells) const {
    return (cells[2] * counts_[1] + cells[1]) * counts_[0] + cells[0];
  }

  double reach_;
  geometry::Box box_;
  geometry::ModelVector cell_{1};
  Cells counts_{1, 1, 1};
  std::vector<std::uint32_t> first_;    ///< one a cell, and the end
  std::vector<std::uint32_t> numbers_;  ///< of places by their cells, those of one ascending
};

}  // namespace penpose::intent
