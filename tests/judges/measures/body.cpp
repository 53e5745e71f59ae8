#include <cmath>

#include "tests/judges/cases/known_faces.h"
#include "tests/judges/cases/limbs.h"
#include "tests/judges/measures/body_judge.h"
#include "tests/judges/measures/solver.h"

namespace penpose::judges {
namespace {

std::vector<Outcome> judge(const Rig& rig, Extent extent) {
  const auto cases = limbs(rig, extent);
  const io::CaseFile file = file_of(cases);
  const WholeFace figure(rig.model, file);
  Solver solver(rig.model, file);
  std::vector<Outcome> outcomes;
  for (const Limb& one : cases) {
    Outcome outcome{.name = one.asked.name, .hand = one.hand};
    Answer answer = solver.meant(one.asked, io::TargetForm::drawn);
    if (!answer.refused.empty()) answer.pose = rig::rest_pose(*rig.model.rig);
    judge_body(figure, one.truth, answer.pose, outcome);
    if (!answer.refused.empty()) outcome.note = answer.refused;
    outcome.ms = answer.ms;
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace

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

Measure body_measure() {
  return {"body", [](const Rig& rig) { return !rig.moves.empty(); }, judge};
}

}  // namespace penpose::judges
