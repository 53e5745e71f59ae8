#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::vector<Outcome> judge_gestures(const document::Model& model, const std::vector<Gesture>& cases) {
  const io::CaseFile file = file_of(cases);
  const WholeFace face(model, file);
  Solver solver(model, file);
  GestureJudge gesture_judge(face);
  return each_case(
      model, cases, [&](const Gesture& one) { return solver.meant(one.asked, io::TargetForm::drawn); },
      [&](const Gesture& one, const rig::Pose& pose, Outcome& outcome) { gesture_judge.judge(one, pose, outcome); });
}

Measure gesture_measure() {
  return {"gesture", [](const Rig& rig) { return !rig.lines.empty(); },
          [](const Rig& rig, Extent extent) { return judge_gestures(rig.model, gestures(rig, extent)); }};
}

}  // namespace penpose::judges
