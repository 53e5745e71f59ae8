#pragma once

#include <cstddef>

#include "core/intent/reading/reader.h"
#include "core/posing/simplex.h"

namespace penpose::intent {

/// Searches the values of what is chosen by downhill simplex, on the energy itself with its logarithms, from the values
/// that least squares found; the better one stays. For rigs that are linear the curves' images are carried along with
/// the simplex; others are evaluated for each trial. `most`: evaluations at most. Returns how many were used.
std::size_t search_values(Reader& reader, const Quadratic& quadratic, const Selection& selection, Choice& choice,
                          std::size_t most, posing::SimplexWorkspace& work);

}  // namespace penpose::intent
