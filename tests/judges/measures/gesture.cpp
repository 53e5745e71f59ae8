#include "tests/judges/cases/known_faces.h"
#include "tests/judges/measures/gesture_judge.h"
#include "tests/judges/measures/measure.h"
#include "tests/judges/measures/solver.h"

namespace penpose::judges {
namespace {

std::vector<Outcome> judge(const Rig& rig, Extent extent) {
  const auto cases = gestures(rig, extent);
  const io::CaseFile file = file_of(cases);
  const WholeFace face(rig.model, file);
  Solver solver(rig.model, file);
  GestureJudge judge_of(face);
  std::vector<Outcome> outcomes;
  for (const Gesture& one : cases) {
    Outcome outcome{.name = one.asked.name, .hand = one.hand};
    Answer answer = solver.meant(one.asked, io::TargetForm::drawn);
    if (!answer.refused.empty()) answer.pose = rig::rest_pose(*rig.model.rig);
    judge_of.judge(one, answer.pose, outcome);
    if (!answer.refused.empty()) outcome.note = answer.refused;
    outcome.ms = answer.ms;
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace

Measure gesture_measure() {
  return {"gesture", [](const Rig& rig) { return !rig.lines.empty(); }, judge};
}

}  // namespace penpose::judges
