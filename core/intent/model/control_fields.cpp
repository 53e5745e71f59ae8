#include "core/intent/model/control_fields.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace penpose::intent {
namespace {

constexpr std::size_t k_most_samples = 3000;
constexpr std::uint32_t k_no_sample = static_cast<std::uint32_t>(-1);

}  // namespace

ControlFields::ControlFields(std::span<const ModelPoint> rest)
    : step_(std::max<std::size_t>(1, (rest.size() + k_most_samples - 1) / k_most_samples)) {
  for (std::size_t v = 0; v < rest.size(); v += step_) {
    const bool finite = std::isfinite(rest[v].x + rest[v].y + rest[v].z);
    sample_at_.push_back(finite ? static_cast<std::uint32_t>(samples_.size()) : k_no_sample);
    if (!finite) continue;
    samples_.push_back(static_cast<std::uint32_t>(v));
    places_.push_back(rest[v]);
  }
}

void ControlFields::add(std::span<const std::uint32_t> vertices, std::span<const ModelPoint> rest,
                        std::span<const ModelPoint> moved, double per) {
  Moved field;
  double sum = 0;
  double fourth = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (vertices[k] % step_ != 0) continue;
    const std::uint32_t sample = sample_at_[vertices[k] / step_];
    const ModelVector way = (moved[k] - rest[k]) * per;
    if (sample == k_no_sample || !std::isfinite(way.x + way.y + way.z) || way == ModelVector{0}) continue;
    field.samples.push_back(sample);
    field.ways.push_back(way);
    sum += square_of(way);
    fourth += square_of(way) * square_of(way);
  }
  field.samples.shrink_to_fit();
  field.ways.shrink_to_fit();
  fields_.push_back(std::move(field));
  squares_.push_back(sum);
  usual_ways_.push_back(sum > 0.0 ? std::sqrt(fourth / sum) : 0.0);
  auto& last = last_products_.emplace_back();
  const std::size_t own = fields_.size() - 1;
  for (std::size_t back = 1; back <= std::min<std::size_t>(2, own); ++back) last[back - 1] = product(own, own - back);
}

double ControlFields::product(std::size_t a, std::size_t b) const {
  const Moved& first = fields_[a];
  const Moved& second = fields_[b];
  double sum = 0;
  for (std::size_t i = 0, k = 0; i < first.samples.size() && k < second.samples.size();) {
    if (first.samples[i] == second.samples[k]) {
      sum += glm::dot(first.ways[i++], second.ways[k++]);
    } else if (first.samples[i] < second.samples[k]) {
      ++i;
    } else {
      ++k;
    }
  }
  return sum;
}

void ControlFields::spread(std::span<const std::size_t> controls, Spread& ways) const {
  ways.assign(samples_.size(), {});
  for (std::size_t c = 0; c < std::min(controls.size(), k_together); ++c) {
    const Moved& field = fields_[controls[c]];
    for (std::size_t i = 0; i < field.samples.size(); ++i) ways[field.samples[i]][c] = field.ways[i];
  }
}

// Sums side by side do not wait for each other.
std::array<double, ControlFields::k_together> ControlFields::products(const Spread& ways, std::size_t other) const {
  const Moved& field = fields_[other];
  std::array<double, k_together> sums{};
  for (std::size_t k = 0; k < field.samples.size(); ++k) {
    const auto& here = ways[field.samples[k]];
    for (std::size_t c = 0; c < k_together; ++c) sums[c] += glm::dot(here[c], field.ways[k]);
  }
  return sums;
}

}  // namespace penpose::intent
