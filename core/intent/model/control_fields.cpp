#include "core/intent/model/control_fields.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::intent {
namespace {

constexpr std::size_t k_most_samples = 3000;

}  // namespace

ControlFields::ControlFields(std::span<const ModelPoint> rest) {
  const std::size_t step = std::max<std::size_t>(1, (rest.size() + k_most_samples - 1) / k_most_samples);
  for (std::size_t v = 0; v < rest.size(); v += step) {
    if (!std::isfinite(rest[v].x + rest[v].y + rest[v].z)) continue;
    samples_.push_back(static_cast<std::uint32_t>(v));
    places_.push_back(rest[v]);
  }
}

void ControlFields::add(std::span<const ModelPoint> rest, std::span<const ModelPoint> moved, double per) {
  auto& field = fields_.emplace_back(samples_.size(), ModelVector{0});
  double sum = 0;
  double fourth = 0;
  for (std::size_t i = 0; i < samples_.size() && !moved.empty(); ++i) {
    const ModelVector way = (moved[samples_[i]] - rest[samples_[i]]) * per;
    if (!std::isfinite(way.x + way.y + way.z)) continue;
    field[i] = way;
    sum += square_of(way);
    fourth += square_of(way) * square_of(way);
  }
  squares_.push_back(sum);
  usual_ways_.push_back(sum > 0.0 ? std::sqrt(fourth / sum) : 0.0);
  auto& last = last_products_.emplace_back();
  const std::size_t own = fields_.size() - 1;
  for (std::size_t back = 1; back <= std::min<std::size_t>(2, own); ++back) last[back - 1] = product(own, own - back);
}

double ControlFields::product(std::size_t a, std::size_t b) const {
  double sum = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) sum += glm::dot(fields_[a][i], fields_[b][i]);
  return sum;
}

}  // namespace penpose::intent
