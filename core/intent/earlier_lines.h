#pragma once

#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"
#include "core/intent/reading/reader.h"

// Lines drawn earlier, and which of them are read again.

namespace penpose::intent {

/// The problem started from the pose of an earlier solve, with the references of earlier lines constrained to where
/// they are in it. The problem itself where there is no such pose. Precondition: check_problem passed.
[[nodiscard]] IntentProblem with_earlier_constrained(const rig::Rig& rig, const IntentProblem& problem);

/// The same without the earlier lines.
[[nodiscard]] IntentProblem without_earlier(const IntentProblem& problem);

/// The part of a problem that is read again: the new lines, and those earlier lines that involve the same controls.
/// Their controls start where they started; all others stay as posed, and their references stay where they are.
/// Precondition: the problem has the pose of an earlier solve; the reader is that of the problem and has no chain.
[[nodiscard]] IntentProblem with_unrelated_constrained(const rig::Rig& rig, const Reader& reader,
                                                       const IntentProblem& problem);

/// How well a pose fits a problem, with each line in its best alignment.
struct Fit {
  double energy = 0;
  std::vector<double> squares;       ///< of each drawn curve
  std::vector<std::size_t> aligned;  ///< and how it is aligned (Reader::align)
};
/// `as`: earlier lines keep the alignment that they have there.
[[nodiscard]] Fit fit_of(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                         const rig::Pose& pose, const Fit* as = nullptr);

}  // namespace penpose::intent
