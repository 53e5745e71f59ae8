#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/judges/table/outcome.h"

namespace penpose::judges {

/// A line of the table: the figures of one measure on one rig, or on all rigs of a group.
struct Row {
  std::string measure, rig, group;
  std::size_t cases = 0;
  double right = 0, nothing = 0, of = 0;
  double offered = 0, offered_of = 0;  ///< wrong cases in which a right reading is offered, and all of them
  std::optional<double> error_median, error_worst;  ///< per cent
  std::optional<double> stray_95, stray_worst;      ///< per cent
  std::optional<double> still_worst;                ///< per cent
  std::optional<double> left_mean;                  ///< per cent
  std::optional<double> controls, true_controls;    ///< mean of a case
  double ms_median = 0, ms_worst = 0;
};

[[nodiscard]] Row row_of(const Judged& judged);

/// All rows in the order of measures and rigs, then the totals: for each measure a row of each group, rig "all".
[[nodiscard]] std::vector<Row> table_of(std::span<const Judged> judged);

/// For people.
[[nodiscard]] std::string printed(std::span<const Row> rows);

/// Members that have no value are left out.
[[nodiscard]] nlohmann::json row_to_json(const Row& row);
[[nodiscard]] Row row_from_json(const nlohmann::json& json);
/// JSON with a line for each member, and for each of its "rows".
[[nodiscard]] std::string lined(const nlohmann::json& value);

}  // namespace penpose::judges
