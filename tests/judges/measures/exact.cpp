#include <algorithm>

#include "tests/judges/cases/picture.h"
#include "tests/judges/measures/judged_sets.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {
namespace {

/// The lines of known poses with the true place of each vertex as its target, met by the true pose.
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
    face.asked.optimum_energy = 0;
    face.hand.clear();
    faces.push_back(std::move(face));
  }
  return faces;
}

/// The sum of distances, recomputed.
double energy_of(const WholeFace& face, const io::PoseCase& one, const std::vector<ModelVector>& moved) {
  double sum = 0;
  for (const io::CaseReference& reference : one.references) {
    for (std::size_t i = 0; i < reference.vertices.size(); ++i) {
      const std::uint32_t v = reference.vertices[i];
      sum += geometry::distance(face.rest()[v] + moved[v], reference.target[i]);
    }
  }
  for (const io::CaseConstraint& constraint : one.constraints) {
    for (const std::uint32_t v : constraint.vertices) sum += geometry::length(moved[v]);
  }
  return sum;
}

bool is_face(const Rig& rig) { return !rig.lines.empty(); }

}  // namespace

std::vector<Outcome> judge_exact(const document::Model& model, const std::vector<KnownFace>& cases) {
  const io::CaseFile file = file_of(cases);
  const WholeFace face(model, file);
  Solver solver(model, file);
  return each_case(
      model, cases, [&](const KnownFace& one) { return solver.exact(one.asked); },
      [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
        const std::vector<ModelVector> still(face.rest().size(), ModelVector{0});
        const double rest = one.asked.rest_energy.value_or(energy_of(face, one.asked, still));
        const double least = one.asked.optimum_energy.value_or(0);
        outcome.error = 100 * (energy_of(face, one.asked, face.moved(pose)) - least) / (rest - least);
        face.count_controls(pose, outcome);
      });
}

std::vector<Outcome> judge_meant(const document::Model& model, const std::vector<KnownFace>& cases) {
  const io::CaseFile file = file_of(cases);
  const WholeFace face(model, file);
  Solver solver(model, file);
  return each_case(
      model, cases, [&](const KnownFace& one) { return solver.meant(one.asked, io::TargetForm::points); },
      [&](const KnownFace& one, const rig::Pose& pose, Outcome& outcome) {
        face.judge(face.moved(one.truth), face.moved(pose), outcome);
        face.count_controls(pose, outcome);
        outcome.true_controls = one.true_controls;
      });
}

Measure exact_measure() {
  return {"exact", is_face, [](const Rig& rig, Extent) { return judge_exact(rig.model, exact_faces(rig)); }};
}
Measure meant_measure() {
  return {"meant", is_face, [](const Rig& rig, Extent) { return judge_meant(rig.model, exact_faces(rig)); }};
}

}  // namespace penpose::judges
