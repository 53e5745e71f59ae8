#include <algorithm>

#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::vector<Outcome> judge_gestures(const document::Model& model, const std::vector<Gesture>& cases) {
  CaseSet set(model, cases);
  GestureJudge gesture_judge(set.whole());
  return set.outcomes(Ask::drawn, [&](const Gesture& one, const rig::Pose& pose, Outcome& outcome) {
    gesture_judge.judge(one, pose, outcome);
    if (outcome.right == 1) return;
    outcome.offered = 0;
    for (const rig::Pose& other : set.others(one)) {
      Outcome offered;
      gesture_judge.judge(one, other, offered);
      outcome.offered = std::max(*outcome.offered, offered.right);
    }
  });
}

Measure gesture_measure() {
  return {"gesture", [](const Rig& rig) { return !rig.lines.empty(); },
          [](const Rig& rig, Extent extent) { return judge_gestures(rig.model, gestures(rig, extent)); }};
}

}  // namespace penpose::judges
