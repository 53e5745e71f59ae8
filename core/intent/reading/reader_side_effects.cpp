#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/intent/reading/reader.h"

// How far controls move the curves that were drawn, and what limbs are charged for what else they do.

namespace penpose::intent {

void Reader::measure_side_effects() {
  const std::size_t n = start_.size();
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    double most = 0;
    double aside = 0;
    // What has to stay where it is says nothing.
    for (std::size_t c = 0; c < told_count(); ++c) {
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
      const double count = static_cast<double>(block.count);
      const double way = std::sqrt(sum / count);
      if (!(way > most)) continue;
      most = way;
      aside = std::sqrt(std::max(0.0, sum - along * along / count) / count);
    }
    const double stride = whole_.stride[parameters_[j]];
    side_effect_ratios_.push_back(most > 0.0 ? std::max(1.0, stride / most) : 1e3);
    curve_displacements_.push_back(most);
    tangential_ratios_.push_back(aside > 0.0 ? std::min(10.0, most / aside) : 10.0);
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
         costs_.tangential * base::log(tangential_ratios_[variable]);
}

bool Reader::bears_face(std::size_t joint) const {
  for (std::size_t p = 0; p < whole_.joint.size(); ++p) {
    if (whole_.joint[p] == joint && whole_.bears[p] > weights_.borne) return true;
  }
  return false;
}

void Reader::forgive_carriers() {
  using inference::Term;
  const auto borne = [](double share) { return share > 0; };
  if (choices_.units.empty() || std::any_of(whole_.bears.begin(), whole_.bears.end(), borne)) return;
  const auto carried = [](const Unit& unit) { return unit.terms[Term::carried]; };
  double least = carried(choices_.units.front());
  double most = least;
  for (const Unit& unit : choices_.units) {
    least = std::min(least, carried(unit));
    most = std::max(most, carried(unit));
  }
  // Where one joint carries much less than another, the lines may mean it alone.
  if (least < 0.5 * most) return;
  for (Unit& unit : choices_.units) {
    unit.terms[Term::carried] -= least;
    unit.charge = weights_.by.dot(unit.terms);
  }
}

}  // namespace penpose::intent
