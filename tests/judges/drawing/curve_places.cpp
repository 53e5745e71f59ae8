#include "tests/judges/drawing/curve_places.h"

#include <algorithm>

namespace penpose::judges::drawn {

using geometry::ModelPoint;

CurvePlaces places_of(std::span<const portrait::FeatureCurve> curves, std::span<const ModelPoint> positions) {
  CurvePlaces places;
  for (const portrait::FeatureCurve& curve : curves) {
    std::vector<ModelPoint> line;
    for (const posing::CurvePoint& point : curve.points) {
      ModelPoint sum(0);
      for (std::size_t k = 0; k < point.vertex.size(); ++k) {
        if (point.weight[k] != 0.0) sum += positions[point.vertex[k]] * point.weight[k];
      }
      line.push_back(sum);
    }
    places.push_back(std::move(line));
  }
  return places;
}

double largest_move(std::span<const ModelPoint> from, std::span<const ModelPoint> to) {
  double most = 0;
  for (std::size_t v = 0; v < from.size(); ++v) most = std::max(most, geometry::distance(from[v], to[v]));
  return most;
}

}  // namespace penpose::judges::drawn
