#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/portrait/feature_curve.h"

// How far found curves are from those that a file gives.

namespace penpose::tests {

using Line = std::vector<geometry::ModelPoint>;

inline Line places_of(const portrait::FeatureCurve& curve, std::span<const geometry::ModelPoint> rest) {
  Line line;
  for (const posing::CurvePoint& point : curve.points) {
    geometry::ModelPoint sum{0};
    for (std::size_t i = 0; i < 3; ++i) sum += rest[point.vertex[i]] * point.weight[i];
    line.push_back(sum);
  }
  return line;
}

inline double distance_to(const geometry::ModelPoint& p, const Line& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const geometry::ModelVector along = line[i + 1] - line[i];
    const geometry::ModelVector from = p - line[i];
    const double square = along.x * along.x + along.y * along.y + along.z * along.z;
    const double share = square > 0.0 ? (from.x * along.x + from.y * along.y + from.z * along.z) / square : 0.0;
    least = std::min(least, geometry::distance(p, line[i] + along * std::clamp(share, 0.0, 1.0)));
  }
  return least;
}

/// The mean distance along one line to the other, both ways.
inline double mean_distance(const Line& a, const Line& b) {
  constexpr int k_samples = 8;
  const auto one_way = [](const Line& from, const Line& to) {
    double sum = 0;
    double length = 0;
    for (std::size_t i = 0; i + 1 < from.size(); ++i) {
      const double part = geometry::distance(from[i], from[i + 1]) / k_samples;
      for (int s = 0; s < k_samples; ++s) {
        sum += part * distance_to(from[i] + (from[i + 1] - from[i]) * ((s + 0.5) / k_samples), to);
        length += part;
      }
    }
    return length > 0.0 ? sum / length : 1e300;
  };
  return (one_way(a, b) + one_way(b, a)) / 2.0;
}

/// Between the middles of both eyes' corners.
inline double eye_distance(const std::map<std::string, Line>& curves) {
  const Line& left = curves.at("eyelid_upper_L");
  const Line& right = curves.at("eyelid_upper_R");
  return geometry::distance((left.front() + left.back()) * 0.5, (right.front() + right.back()) * 0.5);
}

}  // namespace penpose::tests
