#include "core/animation/track.h"

namespace penpose::animation {

double frames_per_second(double first_s, double last_s, std::size_t frames) {
  if (frames < 2 || !(last_s > first_s)) return 0;
  return static_cast<double>(frames - 1) / (last_s - first_s);
}

}  // namespace penpose::animation
