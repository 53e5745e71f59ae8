#include "ui/app/playback/curve_moments.h"

#include <algorithm>
#include <cmath>

namespace penpose::app {
namespace {

constexpr double k_one_moment_s = 1e-6;

}  // namespace

void CurveMoments::begin(const document::Document& document) {
  looked_at_s_ = document.time_s;
  follow(document);
}

bool CurveMoments::shows(double time_s) const {
  return looked_at_s_ && std::abs(time_s - *looked_at_s_) < k_one_moment_s;
}

bool CurveMoments::shows(document::CurveId curve) const {
  const auto found = std::find_if(curves_.begin(), curves_.end(), [&](const auto& one) { return one->id == curve; });
  return looked_at_s_ && (found == curves_.end() || shows((*found)->time_s));
}

}  // namespace penpose::app
