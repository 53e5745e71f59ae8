#include "core/intent/model/doubles.h"

namespace penpose::intent {
namespace {

/// Two controls do the same where one of them, as far as it fits best, leaves less than this share of the other's
/// squares: as much as sums may leave.
constexpr double k_same_leaves = 0.012;

bool do_the_same(const ControlFields& fields, std::size_t a, std::size_t b) {
  const double product = fields.product(a, b);
  const double squares = fields.square(a) * fields.square(b);
  return product > 0.0 && squares > 0.0 && product * product > (1.0 - k_same_leaves) * squares;
}

}  // namespace

std::vector<DoubleControl> doubles_of(const WholeModel& whole) {
  std::vector<DoubleControl> out;
  for (std::size_t i = 0; i < whole.composites.size(); ++i) {
    if (whole.joint[i] != k_no_partner) continue;
    if (!whole.composites[i].of.empty()) {
      out.push_back({i, whole.composites[i].of});
      continue;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (whole.joint[k] != k_no_partner || !do_the_same(*whole.fields, i, k)) continue;
      out.push_back({i, {k}});
      break;
    }
  }
  return out;
}

}  // namespace penpose::intent
