#include "ui/app/view/ink.h"

#include <algorithm>
#include <cmath>

namespace penpose::app {
namespace {

constexpr double k_step_px = 2;
/// Deviation of the Gaussian that smooths pressure along the line.
constexpr double k_pressure_px = 8;
constexpr std::size_t k_most_points = 20000;

double usual_pressure(std::span<const double> pressures, std::size_t i) {
  return i < pressures.size() ? std::clamp(pressures[i], 0.0, 1.0) : 0.5;
}

/// Points at equal steps along the line, with the pressure there; the last one is its end.
struct Even {
  std::vector<PxPoint> points;
  std::vector<double> pressures;
};

Even evenly(std::span<const PxPoint> samples, std::span<const double> pressures, double step) {
  Even even;
  double left = 0;  // to the next point
  for (std::size_t i = 0; i + 1 < samples.size() && even.points.size() < k_most_points; ++i) {
    const PxPoint way = samples[i + 1] - samples[i];
    const double length = geometry::distance(samples[i], samples[i + 1]);
    double at = left;
    for (; at < length && even.points.size() < k_most_points; at += step) {
      const double share = at / length;
      even.points.push_back(samples[i] + way * share);
      even.pressures.push_back(usual_pressure(pressures, i) * (1 - share) + usual_pressure(pressures, i + 1) * share);
    }
    left = at - length;
  }
  if (even.points.empty() || !(even.points.back() == samples.back())) {
    even.points.push_back(samples.back());
    even.pressures.push_back(usual_pressure(pressures, samples.size() - 1));
  }
  return even;
}

/// Weights of a Gaussian up to three deviations, over steps.
std::vector<double> bell(double deviation) {
  std::vector<double> weights;
  for (int k = 0; k <= static_cast<int>(std::ceil(3 * deviation)); ++k) {
    weights.push_back(std::exp(-0.5 * (k / deviation) * (k / deviation)));
  }
  return weights;
}

/// The mean about a place. Near an end fewer are taken, as many on either side, so that ends stay where they are.
template <typename Value>
std::vector<Value> smoothed(const std::vector<Value>& values, double deviation) {
  if (deviation <= 0) return values;
  const std::vector<double> weights = bell(deviation);
  std::vector<Value> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t reach = std::min({weights.size() - 1, i, values.size() - 1 - i});
    Value sum = values[i] * weights[0];
    double total = weights[0];
    for (std::size_t k = 1; k <= reach; ++k) {
      sum = sum + (values[i - k] + values[i + k]) * weights[k];
      total += 2 * weights[k];
    }
    out[i] = sum * (1 / total);
  }
  return out;
}

/// Deviation of the Gaussian that smooths places along the line.
double deviation_px(Stabiliser stabiliser) {
  constexpr double k_light_px = 6;
  constexpr double k_strong_px = 16;
  return stabiliser == Stabiliser::off ? 0 : stabiliser == Stabiliser::light ? k_light_px : k_strong_px;
}

}  // namespace

std::vector<float> ink_widths(std::span<const PxPoint> points, std::span<const double> pressures, const InkLook& look) {
  std::vector<double> along(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    along[i] = along[i - 1] + geometry::distance(points[i - 1], points[i]);
  const double length = points.empty() ? 0 : along.back();
  constexpr double k_taper_px = 18;
  constexpr double k_tip = 0.35;  // width of a tapered end, as a share of what it would be
  // A short line is pointed over a third of it at either end.
  const double taper = std::min(k_taper_px * static_cast<double>(look.scale), length / 3);
  std::vector<float> widths(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double near = look.tapers_at_end ? std::min(along[i], length - along[i]) : along[i];
    const double full = taper > 0 ? std::clamp(near / taper, 0.0, 1.0) : 1.0;
    const double share = k_tip + (1 - k_tip) * std::sin(0.5 * 3.14159265358979 * full);
    const double pressure = usual_pressure(pressures, i);
    const double width =
        static_cast<double>(look.least_px) + static_cast<double>(look.most_px - look.least_px) * pressure;
    widths[i] = static_cast<float>(static_cast<double>(look.scale) * width * share);
  }
  return widths;
}

InkLine ink_line(std::span<const PxPoint> samples, std::span<const double> pressures, const InkLook& look) {
  if (samples.empty()) return {};
  const double step = k_step_px * static_cast<double>(look.scale);
  Even even = evenly(samples, pressures, step);
  const double scale = static_cast<double>(look.scale);
  InkLine line;
  line.points = smoothed(even.points, deviation_px(look.stabiliser) * scale / step);
  const std::vector<double> pressed = smoothed(even.pressures, k_pressure_px * scale / step);
  line.widths_px = ink_widths(line.points, pressed, look);
  return line;
}

}  // namespace penpose::app
