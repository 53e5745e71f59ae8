#include <algorithm>
#include <cmath>

#include "tests/judges/measures/body_judge.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

void judge_body(const WholeFace& figure, const rig::Pose& truth, const rig::Pose& found, Outcome& outcome) {
  constexpr double k_stays = 0.005;
  const double height = height_of(figure.model());
  const auto should = figure.moved(truth);
  const auto does = figure.moved(found);
  double square = 0;
  double stray = 0;
  for (std::size_t v = 0; v < should.size(); ++v) {
    const double off = geometry::length(does[v] - should[v]);
    square += off * off;
    if (geometry::length(should[v]) < k_stays * height) stray = std::max(stray, geometry::length(does[v]));
  }
  outcome.error = 100 * std::sqrt(square / static_cast<double>(should.size())) / height;
  outcome.stray = 100 * stray / height;
  figure.count_controls(found, outcome);
}

std::vector<Outcome> judge_limbs(const document::Model& model, const std::vector<Limb>& cases) {
  CaseSet set(model, cases);
  return set.outcomes(Ask::drawn, [&](const Limb& one, const rig::Pose& pose, Outcome& outcome) {
    judge_body(set.whole(), one.truth, pose, outcome);
  });
}

Measure body_measure() {
  return {"body", [](const Rig& rig) { return !rig.moves.empty(); },
          [](const Rig& rig, Extent extent) { return judge_limbs(rig.model, limbs(rig, extent)); }};
}

}  // namespace penpose::judges
