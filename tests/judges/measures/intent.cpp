#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

std::vector<Outcome> judge_known_faces(const document::Model& model, const std::vector<KnownFace>& cases) {
  const io::CaseFile file = file_of(cases);
  const WholeFace face(model, file);
  Solver solver(model, file);
  return each_case(
      model, cases, [&](const KnownFace& one) { return solver.meant(one.asked, io::TargetForm::drawn); },
      [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
        const auto found = face.moved(pose);
        face.judge(face.moved(one.truth), found, outcome);
        face.count_controls(pose, outcome);
        outcome.true_controls = one.true_controls;
        outcome.left = face.left(one.asked, found);
      });
}

Measure intent_measure() {
  return {"intent", [](const Rig& rig) { return !rig.lines.empty(); },
          [](const Rig& rig, Extent extent) { return judge_known_faces(rig.model, known_faces(rig, extent)); }};
}

}  // namespace penpose::judges
