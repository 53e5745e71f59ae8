#pragma once

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/intent/problem.h"
#include "core/io/project/case_file.h"
#include "core/posing/problem.h"

namespace penpose::tracking {

/// Which parameters a case leaves to the solver.
enum class FreeSet : std::uint8_t { all, of_case };

/// The camera through which a case's targets were drawn: the whole model at rest, 1000 by 1000 px.
[[nodiscard]] geometry::Camera case_camera(const document::Model& model, const io::PoseCase& pose_case);

/// The problem that a case states, with its constraints where they are at its start: what is free is at rest, all else
/// as the model's pose has it. In the drawn form the target is a line seen through case_camera: ordered,
/// reparameterised and lifted as a stroke would be. Precondition: io::check_cases passed for this form. Errors (place:
/// case and reference) of pairing.
[[nodiscard]] base::Result<posing::PoseProblem> problem_of_case(const document::Model& model,
                                                                const io::PoseCase& pose_case, FreeSet free,
                                                                io::TargetForm form);

/// How far a hand strays that draws what a case file draws, model units: its view shows the curves of all its cases.
[[nodiscard]] double hand_doubt(const document::Model& model, const io::CaseFile& file);

/// What a case means (core/intent), from the same start. In the drawn form each target is a line in a picture of its
/// own view, seen from afar, so that nothing is nearer; in the points form it is known where each vertex goes, next to
/// exactly. `doubt`: of the hand, model units. Precondition: io::check_cases passed for this form. Errors: too many
/// controls.
[[nodiscard]] base::Result<intent::IntentProblem> intent_of_case(const document::Model& model,
                                                                 const io::PoseCase& pose_case, FreeSet free,
                                                                 io::TargetForm form, double doubt);

}  // namespace penpose::tracking
