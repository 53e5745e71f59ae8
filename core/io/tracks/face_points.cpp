#include "core/io/tracks/face_points.h"

#include <array>
#include <cmath>

namespace penpose::io {
namespace {

/// In distances between the outer corners of the eyes (about 9 cm), towards the viewer: proportions of a common face,
/// rounded. The nose is what tells a nod from a pulled face, and there faces differ least from each other.
constexpr std::array<double, k_ibug_points> k_depths = {
    -0.75, -0.73, -0.68, -0.59, -0.45, -0.25, -0.03, 0.12, 0.17, 0.12, -0.03, -0.25, -0.45, -0.59,
    -0.68, -0.73, -0.75, 0.00,  0.13,  0.20,  0.24,  0.26, 0.26, 0.24, 0.20,  0.13,  0.00,  // brows
    0.22,  0.30,  0.38,  0.45,  0.22,  0.27,  0.31,  0.27, 0.22,                            // nose
    0.00,  0.07,  0.10,  0.09,  0.09,  0.06,  0.09,  0.10, 0.07, 0.00, 0.06,  0.09,         // eyes
    0.17,  0.25,  0.32,  0.34,  0.32,  0.25,  0.17,  0.23, 0.29, 0.31, 0.29,  0.23,         // outer lip
    0.17,  0.28,  0.31,  0.28,  0.17,  0.27,  0.29,  0.27};                                 // inner lip

}  // namespace

std::vector<double> common_depths(std::span<const animation::PxPoint> points) {
  const double eyes = geometry::distance(points[36], points[45]);
  if (!(eyes > 0) || !std::isfinite(eyes)) return {};
  std::vector<double> depths;
  for (const double depth : k_depths) depths.push_back(depth * eyes);
  return depths;
}

}  // namespace penpose::io
