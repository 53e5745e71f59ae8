#include "tests/judges/cases/known_faces.h"
#include "tests/judges/measures/measure.h"
#include "tests/judges/measures/solver.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {
namespace {

std::vector<Outcome> judge(const Rig& rig, Extent extent) {
  const auto cases = known_faces(rig, extent);
  const io::CaseFile file = file_of(cases);
  const WholeFace face(rig.model, file);
  Solver solver(rig.model, file);
  std::vector<Outcome> outcomes;
  for (const KnownFace& one : cases) {
    Outcome outcome{.name = one.asked.name, .hand = one.hand};
    Answer answer = solver.meant(one.asked, io::TargetForm::drawn);
    if (!answer.refused.empty()) {
      outcome.note = answer.refused;
      answer.pose = rig::rest_pose(*rig.model.rig);
    }
    const auto found = face.moved(answer.pose);
    face.judge(face.moved(one.truth), found, outcome);
    face.count_controls(answer.pose, outcome);
    outcome.true_controls = one.true_controls;
    outcome.left = face.left(one.asked, found);
    outcome.ms = answer.ms;
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace

Measure intent_measure() {
  return {"intent", [](const Rig& rig) { return !rig.lines.empty(); }, judge};
}

}  // namespace penpose::judges
