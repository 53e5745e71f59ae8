#pragma once

#include <span>
#include <string>

#include "core/base/json/json.h"
#include "core/intent/solve.h"

namespace penpose::cli {

/// Readings of a case as a table for people: a column for each of the best, a row for each term of its energy that
/// differs from 0, by its weight, then the sum and the probability.
[[nodiscard]] std::string explained_table(std::span<const intent::ExplainedReading> readings, const rig::Rig& rig,
                                          const inference::Weights& weights);

/// The same for scripts: {"energy", "probability", "parameters": {NAME: VALUE}, "terms": {TERM: [VALUE, WEIGHT]}}.
[[nodiscard]] json::Json explained_json(std::span<const intent::ExplainedReading> readings, const rig::Rig& rig,
                                        const inference::Weights& weights);

}  // namespace penpose::cli
