#pragma once

#include <cstddef>

#include "core/intent/reading/reader.h"
#include "core/posing/simplex.h"

namespace penpose::intent {

/// Searches the values of a choice by downhill simplex, on the energy itself with its logarithms, from the
/// least-squares values; the better result is kept. For linear rigs the simplex updates the curves' images along with
/// its vertices; other rigs are evaluated for each trial. `most`: evaluations at most. Returns how many were used.
std::size_t search_values(Reader& reader, const Quadratic& quadratic, const ChoiceCosts& costs, Choice& choice,
                          std::size_t most, posing::SimplexWorkspace& work);

}  // namespace penpose::intent
