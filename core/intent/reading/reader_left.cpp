#include <algorithm>

#include "core/curve/distance.h"
#include "core/intent/reading/reader.h"

// What a pose leaves of the way from the curves to their lines.

namespace penpose::intent {

double Reader::beyond_at_start(std::size_t c) const {
  const std::vector<PxPoint> curve = seen_at_start(c);
  const auto line = blocks_[c].line->points();
  return std::max(curve::distance_to(curve, line.front()), curve::distance_to(curve, line.back()));
}

Reader::Left Reader::left(const rig::Pose& pose) {
  place(pose, positions_);
  Left left;
  for (Block& block : blocks_) {
    double px_sum = 0;
    double sum = 0;
    std::size_t count = 0;
    std::vector<PxPoint> px;
    Matching m;
    if (block.drawn) {
      px = seen(block, positions_);
      m = block.line->match(px, block.alignments[block.aligned], true, block.doubt);
      leave_still(block, m);
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      const ModelPoint& at = positions_[block.first + i];
      double distance = 0;
      if (block.drawn) {
        if (m.weight[i] == 0.0) continue;
        const double in_picture = geometry::distance(m.target[i], px[i]);
        px_sum += in_picture;
        distance = in_picture * block.drawn->camera.units_per_px(std::max(0.0, block.drawn->camera.depth(at)));
      } else {
        distance = geometry::distance(block.known->target[i], at);
      }
      ++count;
      sum += distance;
      left.longest = std::max(left.longest, distance);
    }
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    left.px.push_back(px_sum / n);
    left.units.push_back(sum / n);
    left.sum += sum;
  }
  return left;
}

double Reader::unlikeness(const rig::Pose& a, const rig::Pose& b) const {
  const ControlFields& fields = *whole_.fields;
  std::vector<ModelVector> to_a(fields.places().size(), ModelVector{0});
  std::vector<ModelVector> to_b = to_a;
  for (std::size_t p = 0; p < a.size(); ++p) {
    const rig::Parameter& parameter = rig_.parameters()[p];
    // Fields of shapes are those of the whole range, those of joints of a radian.
    const double range = whole_.joint[p] == k_no_partner ? parameter.maximum - parameter.minimum : 1.0;
    if (!(range > 0.0) || (a[p] == problem_.start[p] && b[p] == problem_.start[p])) continue;
    const auto field = fields.field(p);
    for (std::size_t i = 0; i < field.samples.size(); ++i) {
      to_a[field.samples[i]] += field.ways[i] * ((a[p] - problem_.start[p]) / range);
      to_b[field.samples[i]] += field.ways[i] * ((b[p] - problem_.start[p]) / range);
    }
  }
  double apart = 0, of_a = 0, of_b = 0;
  for (std::size_t i = 0; i < to_a.size(); ++i) {
    apart += square_of(to_a[i] - to_b[i]);
    of_a += square_of(to_a[i]);
    of_b += square_of(to_b[i]);
  }
  const double most = std::max(of_a, of_b);
  return most > 0.0 ? std::sqrt(apart / most) : 0.0;
}

}  // namespace penpose::intent
