#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::vector<Outcome> judge_known_faces(const document::Model& model, const std::vector<KnownFace>& cases) {
  CaseSet set(model, cases);
  return set.outcomes(Ask::drawn, [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
    const auto found = set.whole().moved(pose);
    set.whole().judge(set.whole().moved(one.truth), found, outcome);
    set.whole().count_controls(pose, outcome);
    outcome.true_controls = one.true_controls;
    outcome.left = set.whole().left(one.asked, found);
  });
}

Measure intent_measure() {
  return {"intent", [](const Rig& rig) { return !rig.lines.empty(); },
          [](const Rig& rig, Extent extent) { return judge_known_faces(rig.model, known_faces(rig, extent)); }};
}

}  // namespace penpose::judges
