#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

/// The vertices of a model as they rest, found by where they are.
class Surroundings {
 public:
  explicit Surroundings(std::vector<geometry::ModelPoint> rest);

  [[nodiscard]] std::span<const geometry::ModelPoint> rest() const { return rest_; }
  /// The vertices within `reach` (model units) of one of the places, ascending; where there are more than `most`, that
  /// many of them, evenly by number.
  [[nodiscard]] std::vector<std::uint32_t> near(std::span<const geometry::ModelPoint> places, double reach,
                                                std::size_t most) const;

 private:
  std::vector<geometry::ModelPoint> rest_;
  std::vector<std::uint32_t> by_x_;  ///< finite ones, ascending by x, then by number
};

}  // namespace penpose::intent
