#include "core/curve/stroke.h"

namespace penpose::curve {

std::vector<PxPoint> positions_of(const Stroke& stroke) {
  std::vector<PxPoint> positions;
  positions.reserve(stroke.size());
  for (const StrokeSample& sample : stroke) positions.push_back(sample.position);
  return positions;
}

}  // namespace penpose::curve
