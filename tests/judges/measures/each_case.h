#pragma once

#include <utility>
#include <vector>

#include "tests/judges/measures/solver.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {

/// Asks the program every case and judges its answer, a case for each outcome. A case that is refused counts as if
/// nothing had moved. `ask(one)` gives the Answer, `judge(one, pose, outcome)` fills the outcome.
template <typename Case, typename Ask, typename Judge>
[[nodiscard]] std::vector<Outcome> each_case(const document::Model& model, const std::vector<Case>& cases,
                                             const Ask& ask, const Judge& judge) {
  std::vector<Outcome> outcomes;
  for (const Case& one : cases) {
    Outcome outcome;
    outcome.name = one.asked.name;
    outcome.hand = one.hand;
    const Answer answer = ask(one);
    outcome.ms = answer.ms;
    if (answer.refused.empty()) {
      judge(one, answer.pose, outcome);
    } else {
      judge(one, rig::rest_pose(*model.rig), outcome);
      outcome.note = answer.refused;
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace penpose::judges
