#pragma once

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// An animation of more moments is not opened.
inline constexpr std::size_t k_most_opened_moments = 20'000;

/// The keys of an animation, each control's by itself. Weights are exact: a cubic spline becomes free keys, and a key
/// between two of the same value is left out. Turns of joints become angles about the axes of their controls, with more
/// keys where these would be off by more than 0.2 degrees between two, within the ranges of the controls. What no
/// control is for (translations, scales) is left out. Errors: too many moments, none that can be shown.
[[nodiscard]] base::Result<Timeline> keys_of(const Model& model, const Animation& animation);

}  // namespace penpose::document
