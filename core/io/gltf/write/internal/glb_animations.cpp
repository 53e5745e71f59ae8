#include "core/io/gltf/write/internal/glb_animations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/animation/track.h"
#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {

void GlbAnimations::write(const document::Animation& animation, json::Json& channels, json::Json& samplers) {
  for (const document::Channel& channel : animation.channels) write_channel(channel, channels, samplers);
}

double GlbAnimations::rate_of(const document::Animation& animation) {
  std::vector<double> times_s;
  for (const document::Channel& channel : animation.channels) {
    times_s.insert(times_s.end(), channel.times_s.begin(), channel.times_s.end());
  }
  std::stable_sort(times_s.begin(), times_s.end());
  times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
  constexpr double k_whole = 1e-3;  // of a frame
  return animation::whole_frame_rate(times_s, k_whole);
}

GlbAnimations::Times GlbAnimations::write_times(std::vector<float> times_s, const document::Channel& channel) {
  // Moments that are too close for floats must still ascend (glTF 2.0, section 3.11).
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (!(times_s[i] > times_s[i - 1]))
      times_s[i] = std::nextafter(times_s[i - 1], std::numeric_limits<float>::infinity());
  }
  return {builder_.add_floats(times_s, "SCALAR", BufferUse::plain, true), channel.interpolation, {}, {}};
}
void GlbAnimations::write_sampler(const Times& times, std::size_t node, const char* path, std::span<const float> values,
                                  const char* type, json::Json& channels, json::Json& samplers) {
  constexpr std::array<const char*, 3> k_interpolations = {"STEP", "LINEAR", "CUBICSPLINE"};
  json::Json sampler = {{"input", times.input},
                        {"interpolation", k_interpolations[static_cast<std::size_t>(times.interpolation)]},
                        {"output", builder_.add_floats(values, type, BufferUse::plain, false)}};
  if (!times.spline.is_null()) {
    sampler["extras"] = {{k_extras_key, {{"spline", times.spline}}}};
  } else if (!times.added.empty()) {
    sampler["extras"] = {{k_extras_key, {{"added", times.added}}}};
  }
  samplers.push_back(std::move(sampler));
  channels.push_back({{"sampler", samplers.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

void GlbAnimations::write_channel(const document::Channel& channel, json::Json& channels, json::Json& samplers) {
  if (channel.times_s.empty()) return;
  if (channel.target == document::ChannelTarget::weights) {
    if (weights_.is_weight_channel(channel)) write_weight_keys(channel, channels, samplers);
    return;
  }
  const auto node = node_of_joint_(channel.joint);
  if (!node) return;
  const Times times = write_times({channel.times_s.begin(), channel.times_s.end()}, channel);
  const std::vector<float> values(channel.values.begin(), channel.values.end());
  const bool rotation = channel.target == document::ChannelTarget::rotation;
  const bool translation = channel.target == document::ChannelTarget::translation;
  write_sampler(times, *node,
                rotation      ? "rotation"
                : translation ? "translation"
                              : "scale",
                values, rotation ? "VEC4" : "VEC3", channels, samplers);
}

void GlbAnimations::write_weight_keys(const document::Channel& channel, json::Json& channels, json::Json& samplers) {
  const DenseKeys& keys = weights_.keys_of(channel);
  between_error_ = std::max(between_error_, keys.error);
  std::optional<Times> times;
  for (const WeightNode& to : weight_nodes_) {
    if (!times) {
      times = write_times(keys.times_s, channel);
      times->added = keys.added;
      if (keys.straightened) times->interpolation = document::Interpolation::linear;
    }
    const std::vector<float> values = weights_.values_of(keys.rows, GlbWeights::is_cubic(channel, keys), to.targets);
    if (keys.straightened) {
      times->spline = {{"times", keys.spline.times_s},
                       {"values", weights_.values_of(keys.spline.rows, true, to.targets)}};
    }
    write_sampler(*times, to.node, "weights", values, "SCALAR", channels, samplers);
  }
}

}  // namespace penpose::io
