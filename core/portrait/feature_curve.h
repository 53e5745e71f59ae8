#pragma once

#include <string>
#include <vector>

#include "core/posing/problem.h"

namespace penpose::portrait {

/// A line of the model that an artist would draw: a lip, a lid, a brow, the jaw.
struct FeatureCurve {
  std::string name;                        ///< unique within a model
  std::vector<posing::CurvePoint> points;  ///< at least two, in order along the curve
};

}  // namespace penpose::portrait
