#include "core/io/gltf/write/internal/glb_weights.h"

#include <algorithm>

namespace penpose::io {
namespace {

bool is_last(const OneWayTarget& one, double weight) { return (one.turned ? -weight : weight) <= one.from + 1; }

}  // namespace

bool GlbWeights::is_weight_channel(const document::Channel& channel) const {
  const std::size_t rows = channel.interpolation == document::Interpolation::cubic_spline ? 3 : 1;
  return channel.target == document::ChannelTarget::weights && !channel.times_s.empty() && morphs_.own_count() > 0 &&
         channel.values.size() == channel.times_s.size() * rows * morphs_.own_count();
}

/// The keys of all weights, before the targets are written, which depend on them.
void GlbWeights::find_keys() {
  for (const document::Animation& animation : model_.animations) {
    for (const document::Channel& channel : animation.channels) {
      if (!is_weight_channel(channel)) continue;
      keys_.push_back({&channel, dense_keys(channel, morphs_, morphs_.between_tolerance())});
    }
  }
}

void GlbWeights::find_one_way_targets() {
  pose_weights_ = morphs_.weights(model_.pose);
  std::vector<double> low = pose_weights_;
  for (std::size_t t = 0; t < written_.size(); ++t) {
    if (!written_[t]) low[t] = std::clamp(low[t], 0.0, 1.0);
  }
  std::vector<double> high = low;
  for (const auto& [channel, keys] : keys_) {
    const bool cubic = is_cubic(*channel, keys);
    for (std::size_t row = 0; row < keys.rows.size(); ++row) {
      if (cubic && row % 3 != 1) continue;
      for (std::size_t t = 0; t < low.size(); ++t) {
        low[t] = std::min(low[t], keys.rows[row][t]);
        high[t] = std::max(high[t], keys.rows[row][t]);
      }
    }
  }
  one_way_ = one_way_targets(morphs_.all(), low, high);
  targets_.assign(morphs_.all().begin(), morphs_.all().end());
  helped_.assign(targets_.size(), false);
  for (const OneWayTarget& one : one_way_) {
    targets_.push_back(&one.shape);
    helped_[one.of] = true;
  }
}

bool GlbWeights::is_cubic(const document::Channel& channel, const DenseKeys& keys) {
  return channel.interpolation == document::Interpolation::cubic_spline && !keys.straightened;
}

std::vector<OneWayName> GlbWeights::one_way_names() const {
  std::vector<OneWayName> names;
  for (const OneWayTarget& one : one_way_) {
    names.push_back({targets_[one.of]->parameter.name, one.shape.parameter.name, one.turned ? -1.0 : 1.0});
  }
  return names;
}

/// The weight of a target where the targets' weights, before some were parted, are these.
double GlbWeights::weight_of(std::size_t target, const std::vector<double>& weights) const {
  if (target >= weights.size()) {
    const OneWayTarget& one = one_way_[target - weights.size()];
    return one.part(weights[one.of]);
  }
  return helped_[target] ? std::clamp(weights[target], 0.0, 1.0) : weights[target];
}

/// The same of a tangent: all of it is that of the part in which the weight is.
double GlbWeights::tangent_of(std::size_t target, const std::vector<double>& tangents,
                              const std::vector<double>& weights) const {
  if (target >= weights.size()) {
    const OneWayTarget& one = one_way_[target - weights.size()];
    const double part = one.part(weights[one.of]);
    return part > 0 && (part < 1 || is_last(one, weights[one.of])) ? (one.turned ? -1 : 1) * tangents[one.of] : 0.0;
  }
  return !helped_[target] || (weights[target] >= 0 && weights[target] <= 1) ? tangents[target] : 0.0;
}

const DenseKeys& GlbWeights::keys_of(const document::Channel& channel) const {
  return std::find_if(keys_.begin(), keys_.end(), [&](const KeysOf& one) { return one.channel == &channel; })->keys;
}

std::vector<float> GlbWeights::values_of(const std::vector<std::vector<double>>& rows, bool cubic,
                                         std::span<const std::size_t> shapes) const {
  std::vector<float> values;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::size_t s : shapes) {
      if (s == k_no_target) {
        values.push_back(0.0F);
        continue;
      }
      const bool tangent = cubic && row % 3 != 1;
      values.push_back(
          static_cast<float>(tangent ? tangent_of(s, rows[row], rows[row - row % 3 + 1]) : weight_of(s, rows[row])));
    }
  }
  return values;
}

}  // namespace penpose::io
