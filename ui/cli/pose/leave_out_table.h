#pragma once

#include <span>
#include <string>

#include "core/document/time/timeline.h"
#include "core/prior/leave_one_out.h"

namespace penpose::cli {

/// What `penpose suggest --leave-one-out` prints: one row a key, errors of the whole model in percent of how far the
/// key's own pose moves it, then their median, and all keys together (root of the sum of squares by that of the ways).
void print_left_out(std::span<const document::PoseKey> keys, std::span<const prior::LeftOut> rows);

/// The same as one JSON object: {"model", "keys": [{"time_s", "name", "held", "not_moving", "mean", "suggested",
/// "strength"}], "median": {"not_moving", "mean", "suggested"}, "all": {...}}.
void print_left_out_json(const std::string& model, std::span<const document::PoseKey> keys,
                         std::span<const prior::LeftOut> rows);

}  // namespace penpose::cli
