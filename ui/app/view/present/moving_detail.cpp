#include "ui/app/view/present/moving_detail.h"

#include <algorithm>

namespace penpose::app {

bool MovingDetail::begin(bool moved, std::int64_t now_us) {
  began_us_ = now_us;
  if (moved) moved_us_ = now_us;
  const bool was_coarse = coarse_;
  const bool moves = moved || (was_coarse && now_us - moved_us_ < k_rest_us);
  coarse_ = moves && slow_ >= k_slow_pictures;
  tells_ = !coarse_ && (moved || was_coarse);
  return coarse_;
}

void MovingDetail::end(std::int64_t now_us) {
  if (!tells_) return;
  slow_ = now_us - began_us_ > k_most_us ? std::min(slow_ + 1, k_slow_pictures) : 0;
}

}  // namespace penpose::app
