#include <algorithm>

#include "tests/judges/cases/known_faces.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/measures/measure.h"
#include "tests/judges/measures/solver.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {
namespace {

/// The lines of known poses with the true place of each vertex as its target.
std::vector<KnownFace> exact_faces(const Rig& rig) {
  std::vector<KnownFace> faces;
  for (KnownFace& face : known_faces(rig, Extent::brief)) {
    const std::string name = face.asked.name.substr(0, face.asked.name.find('/'));
    if (name.starts_with("still_") || (!faces.empty() && faces.back().asked.name == name)) continue;
    const auto places = posed(rig.model, face.truth);
    for (io::CaseReference& reference : face.asked.references) {
      reference.target.clear();
      for (const std::uint32_t v : reference.vertices) reference.target.push_back(places[v]);
    }
    face.asked.name = name;
    face.hand.clear();
    faces.push_back(std::move(face));
  }
  return faces;
}

double rest_energy(const WholeFace& face, const io::PoseCase& one) {
  double sum = 0;
  for (const io::CaseReference& reference : one.references) {
    for (std::size_t i = 0; i < reference.vertices.size(); ++i)
      sum += geometry::distance(face.rest()[reference.vertices[i]], reference.target[i]);
  }
  return sum;
}

std::vector<Outcome> judge(const Rig& rig, bool by_sum) {
  const auto cases = exact_faces(rig);
  const io::CaseFile file = file_of(cases);
  const WholeFace face(rig.model, file);
  Solver solver(rig.model, file);
  std::vector<Outcome> outcomes;
  for (const KnownFace& one : cases) {
    Outcome outcome{.name = one.asked.name};
    Answer answer = by_sum ? solver.exact(one.asked) : solver.meant(one.asked, io::TargetForm::points);
    const bool refused = !answer.refused.empty();
    if (refused) answer.pose = rig::rest_pose(*rig.model.rig);
    if (by_sum) {
      // The true pose meets every target, so that the least energy is 0.
      const double rest = rest_energy(face, one.asked);
      outcome.error = 100 * (refused ? 1 : answer.energy / rest);
    } else {
      face.judge(face.moved(one.truth), face.moved(answer.pose), outcome);
    }
    face.count_controls(answer.pose, outcome);
    outcome.true_controls = one.true_controls;
    if (refused) outcome.note = answer.refused;
    outcome.ms = answer.ms;
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

bool is_face(const Rig& rig) { return !rig.lines.empty(); }

}  // namespace

Measure exact_measure() {
  return {"exact", is_face, [](const Rig& rig, Extent) { return judge(rig, true); }};
}
Measure meant_measure() {
  return {"meant", is_face, [](const Rig& rig, Extent) { return judge(rig, false); }};
}

}  // namespace penpose::judges
