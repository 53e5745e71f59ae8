#pragma once

#include <vector>

#include "tests/judges/cases/gestures.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/cases/limbs.h"
#include "tests/judges/measures/case_set.h"

namespace penpose::judges {

/// Outcomes of sets of cases, whoever made them. The cases of a set are one picture by one artist.
[[nodiscard]] std::vector<Outcome> judge_known_faces(const document::Model& model, const std::vector<KnownFace>& cases);
[[nodiscard]] std::vector<Outcome> judge_gestures(const document::Model& model, const std::vector<Gesture>& cases);
[[nodiscard]] std::vector<Outcome> judge_limbs(const document::Model& model, const std::vector<Limb>& cases);
/// Targets in the points form, by the preset `exact`: the gap to the optimum, per cent of what there was to gain.
[[nodiscard]] std::vector<Outcome> judge_exact(const document::Model& model, const std::vector<KnownFace>& cases);
/// The same targets by the default preset: whole faces.
[[nodiscard]] std::vector<Outcome> judge_meant(const document::Model& model, const std::vector<KnownFace>& cases);

}  // namespace penpose::judges
