#include "core/articulation/motion/attachment.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::articulation {
namespace {

/// Width over which segments are heard, as a share of the distance to the curve.
constexpr double k_width = 1.0;

}  // namespace

Attachment::Attachment(std::span<const ModelPoint> curve) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const ModelVector along = curve[k + 1] - curve[k];
    const double square = glm::dot(along, along);
    segments_.push_back({curve[k], along, square > 0.0 ? 1.0 / square : 0.0, std::sqrt(square)});
    length += segments_.back().length;
  }
  step_ = length / static_cast<double>(segments_.size());
  fractions_.resize(segments_.size());
  squares_.resize(segments_.size());
  shares_.resize(segments_.size());
}

void Attachment::attach(const ModelPoint& point) {
  double nearest = 0;
  std::size_t closest = 0;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const Segment& segment = segments_[k];
    const ModelVector to = point - segment.from;
    fractions_[k] = std::clamp(glm::dot(to, segment.along) * segment.inverse_square, 0.0, 1.0);
    const ModelVector off = to - segment.along * fractions_[k];
    squares_[k] = glm::dot(off, off);
    if (k == 0 || squares_[k] < nearest) {
      nearest = squares_[k];
      closest = k;
    }
  }
  distance_ = std::sqrt(nearest);
  std::fill(shares_.begin(), shares_.end(), 0.0);
  shares_[closest] = 1.0;
  const double width = k_width * k_width * nearest;
  // On the curve: the place itself, to the last bit.
  if (!(width > 1e-18 * step_ * step_)) return;
  double sum = 0;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const double x = (squares_[k] - nearest) / width + 1.0;
    shares_[k] = segments_[k].length / (x * x);
    sum += shares_[k];
  }
  const double scale = 1.0 / sum;
  for (double& share : shares_) share *= scale;
}

double Attachment::place() const {
  double place = 0;
  for (std::size_t k = 0; k < shares_.size(); ++k) place += shares_[k] * (static_cast<double>(k) + fractions_[k]);
  return place;
}

ModelVector Attachment::mean_of_points(std::span<const ModelVector> values) const {
  ModelVector mean{0};
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    mean += (values[k] * (1.0 - fractions_[k]) + values[k + 1] * fractions_[k]) * shares_[k];
  }
  return mean;
}

ModelVector Attachment::mean_of_segments(std::span<const ModelVector> values) const {
  ModelVector mean{0};
  for (std::size_t k = 0; k < shares_.size(); ++k) mean += values[k] * shares_[k];
  return mean;
}

}  // namespace penpose::articulation
