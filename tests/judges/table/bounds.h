#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "tests/judges/table/table.h"

namespace penpose::judges {

/// Bounds of the rows of a table: {"MEASURE/GROUP/RIG": {"right": at least, "of": exactly, "error_median": at most,
/// ...}}. Times have none. A bound is the figure rounded to the third digit, to its worse side.

/// What breaks them, one line each: a figure beyond its bound, another number of cases, a row without bounds, bounds
/// without a row.
[[nodiscard]] std::vector<std::string> broken(const nlohmann::json& bounds, std::span<const Row> rows);

/// The bounds with those of better figures and of rows that had none. A worse figure leaves its bound as it is. Bounds
/// of rows that are not in the table stay.
[[nodiscard]] nlohmann::json tightened(const nlohmann::json& bounds, std::span<const Row> rows);

}  // namespace penpose::judges
