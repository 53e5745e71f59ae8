#include "core/intent/model/places_moved.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace penpose::intent {
namespace {

/// What moves by less than this share of the most does not join places.
constexpr double k_moves_along = 0.3;
/// A sample's neighbours are so many, the nearest.
constexpr std::size_t k_nearest = 10;
/// A place of fewer samples than this share of what moves is the edge of another one.
constexpr double k_least_share = 0.03;

/// For each sample those that are among the nearest of it, or it among theirs.
std::vector<std::vector<std::uint32_t>> neighbours_of(std::span<const ModelPoint> places) {
  std::vector<std::vector<std::uint32_t>> out(places.size());
  std::vector<std::pair<double, std::uint32_t>> nearest;  // the nearest first
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    nearest.clear();
    for (std::uint32_t k = 0; k < places.size(); ++k) {
      const std::pair<double, std::uint32_t> one{square_of(places[k] - places[i]), k};
      if (k == i || (nearest.size() == k_nearest && one > nearest.back())) continue;
      nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), one), one);
      if (nearest.size() > k_nearest) nearest.pop_back();
    }
    for (const auto& [distance, other] : nearest) {
      out[i].push_back(other);
      out[other].push_back(i);
    }
  }
  return out;
}

}  // namespace

std::vector<std::vector<WholeModel::PlaceMoved>> places_moved(const ControlFields& fields,
                                                              const std::vector<bool>& shapes) {
  std::vector<std::vector<WholeModel::PlaceMoved>> out(fields.control_count());
  if (std::find(shapes.begin(), shapes.end(), true) == shapes.end()) return out;
  const auto neighbours = neighbours_of(fields.places());
  for (std::size_t p = 0; p < out.size(); ++p) {
    if (!shapes[p] || !(fields.square(p) > 0.0)) continue;
    const ControlField field = fields.field(p);
    double most = 0;
    for (const ModelVector& way : field.ways) most = std::max(most, square_of(way));
    std::vector<double> moves(fields.places().size(), 0.0);  // squares of ways; 0: still, or in a place already
    double count = 0;
    for (std::size_t i = 0; i < field.samples.size(); ++i) {
      const double square = square_of(field.ways[i]);
      if (square < k_moves_along * k_moves_along * most) continue;
      moves[field.samples[i]] = square;
      count += 1.0;
    }
    for (const std::uint32_t first : field.samples) {
      if (moves[first] == 0.0) continue;
      WholeModel::PlaceMoved place;
      double farthest = std::exchange(moves[first], 0.0);
      place.samples.push_back(first);
      for (std::size_t next = 0; next < place.samples.size(); ++next) {
        for (const std::uint32_t other : neighbours[place.samples[next]]) {
          if (moves[other] == 0.0) continue;
          farthest = std::max(farthest, std::exchange(moves[other], 0.0));
          place.samples.push_back(other);
        }
      }
      place.way = std::sqrt(farthest);
      if (static_cast<double>(place.samples.size()) >= k_least_share * count) out[p].push_back(std::move(place));
    }
  }
  return out;
}

}  // namespace penpose::intent
