#include "core/intent/model/place_grid.h"

#include <algorithm>
#include <cmath>

namespace penpose::intent {
namespace {

/// More cells than this along an axis cost more than they save.
constexpr double k_most_cells = 32.0;
/// What is nearer than the reach to the last bit is within this much of it, whatever is rounded.
constexpr double k_beyond = 1.001;

bool is_finite(const geometry::ModelPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

PlaceGrid::PlaceGrid(std::span<const geometry::ModelPoint> places, double reach) : reach_(k_beyond * reach) {
  for (const geometry::ModelPoint& p : places) {
    if (is_finite(p)) box_.add(p);
  }
  for (int axis = 0; axis < 3 && !box_.empty(); ++axis) {
    const double extent = box_.maximum[axis] - box_.minimum[axis];
    cell_[axis] = std::max(reach_, extent / k_most_cells);
    counts_[static_cast<std::size_t>(axis)] =
        std::isfinite(extent / cell_[axis]) ? static_cast<std::size_t>(extent / cell_[axis]) + 1 : 1;
  }
  first_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
  for (const geometry::ModelPoint& p : places) {
    if (is_finite(p)) ++first_[number_of(cells_of(p)) + 1];
  }
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
  numbers_.resize(first_.back());
  std::vector<std::uint32_t> next = first_;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (is_finite(places[i])) numbers_[next[number_of(cells_of(places[i]))]++] = i;
  }
}

PlaceGrid::Cells PlaceGrid::cells_of(const geometry::ModelPoint& place) const {
  Cells cells{0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t last = counts_[static_cast<std::size_t>(axis)] - 1;
    const double cell = (place[axis] - box_.minimum[axis]) / cell_[axis];
    if (cell > 0.0)
      cells[static_cast<std::size_t>(axis)] = cell < static_cast<double>(last) ? static_cast<std::size_t>(cell) : last;
  }
  return cells;
}

}  // namespace penpose::intent
