#pragma once

#include <cstdint>

#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// A check of an option's text: a finite number from `low` to `high`. The parser's own range lets NaN pass.
[[nodiscard]] Check number_range(double low, double high);

/// The same for a whole number.
[[nodiscard]] Check whole_range(std::int64_t low, std::int64_t high);

}  // namespace penpose::cli
