#include "core/io/gltf/read/internal/gltf_weight_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penpose::io {
namespace {

/// More than any weight that shows a face; beyond it shapes could not be evaluated.
constexpr double k_most_weight = 1e9;

void widen(double value, rig::Parameter& range) {
  if (!std::isfinite(value)) return;
  range.minimum = std::min(range.minimum, std::max(value, -k_most_weight));
  range.maximum = std::max(range.maximum, std::min(value, k_most_weight));
}

/// The cubic from a to b with these tangents (times the span) turns where its derivative, a quadratic, is zero.
void widen_between(double a, double out_tangent, double b, double in_tangent, rig::Parameter& range) {
  const double cubed = 2 * a + out_tangent - 2 * b + in_tangent;
  const double squared = -3 * a - 2 * out_tangent + 3 * b - in_tangent;
  const double half = squared / 3;  // of the quadratic 3 (cubed t^2 + 2 half t) + out_tangent
  const double root = std::sqrt(std::max(0.0, half * half - cubed * out_tangent / 3));
  // The form of the solution that neither divides by nothing nor takes equals from each other.
  const double sum = -half - (half < 0 ? -root : root);
  const std::array<double, 2> turns{sum / cubed, out_tangent / 3 / sum};
  for (const double t : turns) {
    if (t > 0 && t < 1) widen(((cubed * t + squared) * t + out_tangent) * t + a, range);
  }
}

void widen_to(const document::Channel& channel, std::size_t shape, std::size_t shapes, rig::Parameter& range) {
  const bool cubic = channel.interpolation == document::Interpolation::cubic_spline;
  const std::size_t rows = cubic ? 3 : 1;
  const auto at = [&](std::size_t key, std::size_t row) { return channel.values[(key * rows + row) * shapes + shape]; };
  for (std::size_t k = 0; k < channel.times_s.size(); ++k) {
    widen(at(k, cubic ? 1 : 0), range);
    if (!cubic || k == 0) continue;
    const double span_s = channel.times_s[k] - channel.times_s[k - 1];
    widen_between(at(k - 1, 1), span_s * at(k - 1, 2), at(k, 1), span_s * at(k, 0), range);
  }
}

}  // namespace

void widen_ranges(const std::vector<document::Animation>& animations, const RootExtras& extras, GltfShapes& shapes) {
  for (std::size_t s = 0; s < shapes.shapes.size(); ++s) {
    rig::Parameter& range = shapes.shapes[s].parameter;
    const bool known = std::any_of(extras.shapes.begin(), extras.shapes.end(),
                                   [&](const rig::Parameter& listed) { return listed.name == range.name; });
    if (known) continue;
    for (const document::Animation& animation : animations) {
      for (const document::Channel& channel : animation.channels) {
        if (channel.target == document::ChannelTarget::weights) widen_to(channel, s, shapes.shapes.size(), range);
      }
    }
  }
}

}  // namespace penpose::io
