#include "tests/judges/rigs/random/landmarks.h"

#include <algorithm>

namespace penpose::judges {

Landmarks landmarks_of(const Parts& parts) {
  const auto middle_of = [&](std::string_view name) {
    ModelPoint sum{0};
    const auto& line = parts.line(name);
    for (const std::uint32_t v : line) sum += parts.rest()[v] / static_cast<double>(line.size());
    return sum;
  };
  Landmarks marks;
  const auto& lip = parts.line("lip_upper");
  marks.corners[0] = parts.rest()[lip.back()];
  marks.corners[1] = parts.rest()[lip.front()];
  marks.mouth_w = 0.5 * geometry::distance(marks.corners[0], marks.corners[1]);
  marks.mouth = (middle_of("lip_upper") + middle_of("lip_lower")) * 0.5;
  const auto& jaw = parts.line("jaw");
  marks.chin = parts.rest()[jaw[jaw.size() / 2]];
  marks.nose = parts.rest()[parts.line("nose_bridge").back()];
  for (const std::size_t side : {0U, 1U}) {
    const std::string end = side == 0 ? "_L" : "_R";
    marks.eyes[side] = (middle_of("eyelid_upper" + end) + middle_of("eyelid_lower" + end)) * 0.5;
    marks.brows[side] = middle_of("brow" + end);
    const auto& lid = parts.line("eyelid_upper" + end);
    marks.eye = 0.5 * geometry::distance(parts.rest()[lid.front()], parts.rest()[lid.back()]);
  }
  marks.low = 1e300;
  marks.high = -1e300;
  for (const ModelPoint& p : parts.rest().first(parts.skin == 0 ? parts.rest().size() : parts.skin)) {
    marks.low = std::min(marks.low, p.y);
    marks.high = std::max(marks.high, p.y);
  }
  return marks;
}

}  // namespace penpose::judges
