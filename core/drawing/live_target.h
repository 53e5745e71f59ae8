#pragma once

#include <optional>

#include "core/document/document.h"
#include "core/intent/problem.h"

namespace penpose::drawing {

/// What following a target asks for while it is being drawn in a view, as if it were there already: lines of the same
/// moment hold their curves, as the solve at pen-up will. `drawn.front()` is the curve; its line is not read
/// (intent::LivePoser). Nothing where the view cannot be or does not see the reference.
[[nodiscard]] std::optional<intent::IntentProblem> live_problem(const document::Document& document,
                                                                const document::PoseCurve& curve,
                                                                const document::View& view);

}  // namespace penpose::drawing
