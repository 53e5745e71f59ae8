#include "core/intent/model/places_moved.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace penpose::intent {
namespace {

/// What moves by less than this share of the most does not join places.
constexpr double k_moves_along = 0.15;
/// Samples are neighbours that are no farther from each other than this many times the usual distance between samples.
constexpr double k_apart = 3.0;

using Cell = std::array<std::int64_t, 3>;
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// The samples near each sample, by cells as large as the distance.
class Neighbours {
 public:
  Neighbours(std::span<const ModelPoint> places, double distance) : places_(places), distance_(distance) {
    for (std::uint32_t i = 0; i < places.size(); ++i) cells_[cell_of(places[i])].push_back(i);
  }
  template <typename Use>
  void each(std::uint32_t of, Use use) const {
    const Cell middle = cell_of(places_[of]);
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto cell = cells_.find({middle[0] + x, middle[1] + y, middle[2] + z});
          if (cell == cells_.end()) continue;
          for (const std::uint32_t other : cell->second) {
            if (other != of && square_of(places_[other] - places_[of]) <= distance_ * distance_) use(other);
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] Cell cell_of(const ModelPoint& at) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(at[k] / distance_));
    return cell;
  }
  std::span<const ModelPoint> places_;
  double distance_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

/// The median distance from a sample to the nearest other one; of a part of the samples where there are many.
double usual_distance(std::span<const ModelPoint> places) {
  constexpr std::size_t k_looked_at = 200;
  const std::size_t step = std::max<std::size_t>(1, places.size() / k_looked_at);
  std::vector<double> nearest;
  for (std::size_t i = 0; i < places.size(); i += step) {
    double least = -1;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double square = square_of(places[k] - places[i]);
      if (k != i && square > 0.0 && (least < 0.0 || square < least)) least = square;
    }
    if (least > 0.0) nearest.push_back(std::sqrt(least));
  }
  if (nearest.empty()) return 0.0;
  std::stable_sort(nearest.begin(), nearest.end());
  return nearest[nearest.size() / 2];
}

}  // namespace

std::vector<std::vector<WholeModel::PlaceMoved>> places_moved(const ControlFields& fields,
                                                              const std::vector<bool>& shapes) {
  std::vector<std::vector<WholeModel::PlaceMoved>> out(fields.control_count());
  const double usual = usual_distance(fields.places());
  if (!(usual > 0.0)) return out;
  const Neighbours neighbours(fields.places(), k_apart * usual);
  constexpr std::uint8_t k_still = 0, k_moves = 1, k_taken = 2;
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!shapes[p] || !(fields.square(p) > 0.0)) continue;
    const auto field = fields.field(p);
    double most = 0;
    for (const ModelVector& way : field) most = std::max(most, square_of(way));
    std::vector<std::uint8_t> state(field.size(), k_still);
    for (std::size_t i = 0; i < field.size(); ++i) {
      if (square_of(field[i]) >= k_moves_along * k_moves_along * most) state[i] = k_moves;
    }
    for (std::uint32_t i = 0; i < field.size(); ++i) {
      if (state[i] != k_moves) continue;
      WholeModel::PlaceMoved& place = out[p].emplace_back();
      place.samples.push_back(i);
      state[i] = k_taken;
      for (std::size_t next = 0; next < place.samples.size(); ++next) {
        neighbours.each(place.samples[next], [&](std::uint32_t other) {
          if (state[other] != k_moves) return;
          state[other] = k_taken;
          place.samples.push_back(other);
        });
        place.way = std::max(place.way, std::sqrt(square_of(field[place.samples[next]])));
      }
    }
  }
  return out;
}

}  // namespace penpose::intent
