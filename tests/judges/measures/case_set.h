#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tests/judges/cases/known_faces.h"
#include "tests/judges/measures/solver.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {

/// How a case is put to the program: lines as drawn, or a target for each vertex, by the default preset or by `exact`.
enum class Ask : std::uint8_t { drawn, points, exact };

/// A set of cases of a model, with what it takes to solve and to judge them.
template <typename Case>
class CaseSet {
 public:
  /// Both outlive this.
  CaseSet(const document::Model& model, const std::vector<Case>& cases)
      : cases_(cases), file_(file_of(cases)), solver_(model, file_), whole_(model, file_) {}

  [[nodiscard]] const WholeFace& whole() const { return whole_; }

  /// What is offered beside the answer to a drawn case.
  [[nodiscard]] std::vector<rig::Pose> others(const Case& one) {
    return solver_.others(one.asked, io::TargetForm::drawn);
  }

  /// The outcomes of all cases, one after the other. `judge(one, pose, outcome)` fills in what the measure looks at. A
  /// case that is refused counts as if nothing had moved.
  template <typename Judge>
  [[nodiscard]] std::vector<Outcome> outcomes(Ask ask, const Judge& judge) {
    std::vector<Outcome> all;
    for (const Case& one : cases_) {
      Outcome outcome;
      outcome.name = one.asked.name;
      outcome.hand = one.hand;
      Answer answer = ask == Ask::exact ? solver_.exact(one.asked)
                                        : solver_.meant(one.asked, ask == Ask::drawn ? io::TargetForm::drawn
                                                                                     : io::TargetForm::points);
      outcome.ms = answer.ms;
      if (!answer.refused.empty()) answer.pose = rig::rest_pose(*whole_.model().rig);
      judge(one, answer.pose, outcome);
      if (!answer.refused.empty()) outcome.note = answer.refused;
      all.push_back(std::move(outcome));
    }
    return all;
  }

 private:
  const std::vector<Case>& cases_;
  io::CaseFile file_;
  Solver solver_;
  WholeFace whole_;
};

}  // namespace penpose::judges
