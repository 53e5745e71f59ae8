#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/curve/polyline.h"
#include "core/intent/reading/reader.h"

// What controls do beside what was drawn, and what that costs.

namespace penpose::intent {
namespace {

/// Which of the places is nearest by its distance as rounded, the first of equals. Roots are taken only where squares
/// are too near each other to tell.
std::size_t nearest_of(std::span<const ModelPoint> places, const ModelPoint& p) {
  constexpr double k_clear = 1e-12;
  std::size_t nearest = 0;
  double least = square_of(p - places[0]);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double square = square_of(p - places[k]);
    if (!(square < least)) continue;
    if (square > least * (1.0 - k_clear) && !(std::sqrt(square) < std::sqrt(least))) continue;
    nearest = k;
    least = square;
  }
  return nearest;
}

}  // namespace

void Reader::measure_side_effects() {
  const std::size_t n = start_.size();
  const auto apart = surrounding_displacements();
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    double most = 0;
    double around = 0;  // of the curve that it moves most
    double aside = 0;
    // What has to stay where it is says nothing.
    for (std::size_t c = 0; c < problem_.drawn.size() + problem_.known.size(); ++c) {
      const Block& block = blocks_[c];
      double sum = 0;
      double along = 0;
      for (std::size_t i = block.first; i < block.first + block.count; ++i) {
        ModelVector way = columns_[j * n + i];
        if (block.drawn != nullptr) {
          const ModelVector& ray = block.drawn->camera.forward();
          way -= ray * glm::dot(ray, way);
          ModelVector chord = start_[block.first + block.count - 1] - start_[block.first];
          chord -= ray * glm::dot(ray, chord);
          const double length = geometry::length(chord);
          if (length > 0.0 && !block.alignments.front().closed) along += glm::dot(chord, way) / length;
        }
        // What the pen left out by its pressure is not seen.
        const bool weighs = block.drawn != nullptr && !block.drawn->weights.empty();
        sum += glm::dot(way, way) * (weighs ? block.drawn->weights[i - block.first] : 1.0);
      }
      const double way = std::sqrt(sum / static_cast<double>(block.count));
      if (!(way > most)) continue;
      most = way;
      aside = std::sqrt(std::max(0.0, sum - along * along / static_cast<double>(block.count)) /
                        static_cast<double>(block.count));
      around = apart.empty() ? 0.0 : apart[c][j];
    }
    const double stride = whole_.stride[parameters_[j]];
    side_effect_ratios_.push_back(most > 0.0 ? std::max(1.0, stride / most) : 1e3);
    curve_displacements_.push_back(most);
    tangential_ratios_.push_back(aside > 0.0 ? std::min(10.0, most / aside) : 10.0);
    surrounding_ratios_.push_back(most > 0.0 ? std::max(1.0, around / most) : 1e3);
  }
}

std::vector<std::vector<double>> Reader::curve_displacements() const {
  const std::size_t n = start_.size();
  std::vector<std::vector<double>> ways;
  for (std::size_t c = 0; c < problem_.drawn.size(); ++c) {
    const Block& block = blocks_[c];
    const ModelVector& ray = block.drawn->camera.forward();
    auto& row = ways.emplace_back();
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      double sum = 0;
      for (std::size_t i = block.first; i < block.first + block.count; ++i) {
        const ModelVector way = columns_[j * n + i] - ray * glm::dot(ray, columns_[j * n + i]);
        sum += glm::dot(way, way);
      }
      row.push_back(std::sqrt(sum / static_cast<double>(block.count)));
    }
  }
  return ways;
}

double Reader::side_effect_cost(std::size_t variable) const {
  return costs_.side_effect * base::log(side_effect_ratios_[variable]) +
         costs_.surrounding * base::log(surrounding_ratios_[variable]) +
         costs_.tangential * base::log(tangential_ratios_[variable]);
}

std::vector<std::uint32_t> Reader::pieces_of(std::span<const posing::CurvePoint> reference) const {
  std::vector<std::uint32_t> pieces;
  for (const posing::CurvePoint& point : reference) pieces.push_back(whole_.surroundings->piece(point.vertex[0]));
  std::stable_sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  return pieces;
}

std::vector<std::vector<double>> Reader::surrounding_displacements() const {
  // Of a curve's length: what lies as near as that is drawn with it.
  constexpr double k_near = 0.05;
  constexpr std::size_t k_most_near = 64;
  std::vector<std::vector<double>> ways;
  if (!whole_.surroundings || !linear_) return ways;
  const std::size_t n = start_.size();
  const std::span<const ModelPoint> rest = whole_.surroundings->rest();
  const auto ways_of = [&](const Block& block, std::span<const posing::CurvePoint> reference) {
    std::vector<double> out(parameters_.size(), 0.0);
    std::vector<ModelPoint> places;
    for (const posing::CurvePoint& point : reference) {
      ModelPoint at{0};
      for (std::size_t k = 0; k < 3; ++k) at += rest[point.vertex[k]] * point.weight[k];
      places.push_back(at);
    }
    // A lid glides over an eye that is another thing.
    const std::vector<std::uint32_t> pieces = pieces_of(reference);
    const auto near =
        whole_.surroundings->near(places, k_near * curve::arc_length<ModelPoint>(places), k_most_near, pieces);
    if (near.empty()) return out;
    const auto form = rig_.bind(near)->linearize(problem_.start, parameters_);
    if (!form) return out;
    std::vector<std::size_t> nearest(near.size(), 0);
    for (std::size_t i = 0; i < near.size(); ++i) nearest[i] = nearest_of(places, rest[near[i]]);
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      double sum = 0;
      for (std::size_t i = 0; i < near.size(); ++i) {
        ModelVector way = form->columns[j * near.size() + i] * ranges_[j] - columns_[j * n + block.first + nearest[i]];
        if (block.drawn != nullptr) {
          const ModelVector& ray = block.drawn->camera.forward();
          way -= ray * glm::dot(ray, way);
        }
        sum += glm::dot(way, way);
      }
      out[j] = std::sqrt(sum / static_cast<double>(near.size()));
    }
    return out;
  };
  for (std::size_t c = 0; c < problem_.drawn.size(); ++c)
    ways.push_back(ways_of(blocks_[c], problem_.drawn[c].reference));
  for (std::size_t c = 0; c < problem_.known.size(); ++c)
    ways.push_back(ways_of(blocks_[problem_.drawn.size() + c], problem_.known[c].reference));
  return ways;
}

}  // namespace penpose::intent
