#pragma once

#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"
#include "core/intent/reading/reader.h"

// Lines that were drawn before, and what of them is read anew.

namespace penpose::intent {

/// The problem from the pose that an earlier solve came to: the references of what was drawn before stay where they are
/// there. The problem itself where there is no such pose. Precondition: check_problem passed.
[[nodiscard]] IntentProblem with_the_rest_held(const rig::Rig& rig, const IntentProblem& problem);

/// The same without what was drawn before.
[[nodiscard]] IntentProblem without_the_rest(const IntentProblem& problem);

/// The part of a problem that is read anew: what is new, and of what was drawn before those lines that tell of the same
/// controls. Their controls start where they started; the rest stays as posed, its references where they are.
/// Precondition: a pose that an earlier solve came to; the reader is that of the problem and has no chain.
[[nodiscard]] IntentProblem with_others_held(const rig::Rig& rig, const Reader& reader, const IntentProblem& problem);

/// What a pose comes to in a problem, each line aligned as the pose fits it best. Lines that were drawn before give way
/// to those that are new.
struct Fit {
  double energy = 0;
  std::vector<double> squares;       ///< of each drawn curve
  std::vector<std::size_t> aligned;  ///< and how it is aligned (Reader::align)
};
/// `as`: lines that were drawn before are aligned as there.
[[nodiscard]] Fit fit_of(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                         const rig::Pose& pose, Quadratic& quadratic, const Fit* as = nullptr);

}  // namespace penpose::intent
