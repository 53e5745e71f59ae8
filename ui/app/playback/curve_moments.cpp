#include "ui/app/playback/curve_moments.h"

#include <cmath>
#include <utility>

namespace penpose::app {
namespace {

constexpr double k_one_moment_s = 1e-6;

}  // namespace

void CurveMoments::begin(const document::Document& document) {
  drawn_.clear();
  timeline_ = document.timeline;
  time_s_ = document.time_s;
  looked_at_s_ = time_s_;
  follow(document);
}

void CurveMoments::follow(const document::Document& document) {
  // A pose that is keyed elsewhere than where it was drawn takes its lines along.
  const bool carried = timeline_ != document.timeline && time_s_ != document.time_s;
  const double was_s = std::exchange(time_s_, document.time_s);
  timeline_ = document.timeline;
  for (auto& [id, drawn] : drawn_) {
    if (carried && std::abs(drawn.time_s - was_s) < k_one_moment_s) drawn.time_s = time_s_;
  }
  for (const auto& curve : document.curves) {
    const auto found = drawn_.find(curve->id.value);
    if (found == drawn_.end()) {
      drawn_.emplace(curve->id.value, Drawn{curve, time_s_});
      continue;
    }
    Drawn& known = found->second;
    if (known.curve == curve) continue;
    const bool anew = known.curve->role != curve->role || known.curve->target != curve->target;
    known.curve = curve;
    if (anew) known.time_s = time_s_;
  }
}

bool CurveMoments::shows(double time_s) const {
  return looked_at_s_ && std::abs(time_s - *looked_at_s_) < k_one_moment_s;
}

bool CurveMoments::shows(document::CurveId curve) const {
  const auto found = drawn_.find(curve.value);
  return looked_at_s_ && (found == drawn_.end() || shows(found->second.time_s));
}

}  // namespace penpose::app
