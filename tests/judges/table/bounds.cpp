#include "tests/judges/table/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/numbers.h"

namespace penpose::judges {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 6> k_at_most{"error_median", "error_worst", "stray_95",
                                               "stray_worst",  "still_worst", "left_mean"};
/// Figures are the same on every machine; this is what rounding a bound to three digits and reading it back may cost.
constexpr double k_rounding = 1e-9;

std::string name_of(const Row& row) { return row.measure + "/" + row.group + "/" + row.rig; }

/// Never -0.
double rounded_up(double value) { return std::ceil(value * 1000 - 1e-6) / 1000 + 0.0; }

std::string shown(double value) { return base::format_fixed(value, 3); }

}  // namespace

std::vector<std::string> broken(const json& bounds, std::span<const Row> rows) {
  std::vector<std::string> lines;
  std::vector<std::string> seen;
  for (const Row& row : rows) {
    const std::string name = name_of(row);
    seen.push_back(name);
    if (!bounds.contains(name)) {
      lines.push_back(name + " has no bounds; judges --short --tighten BOUNDS adds them");
      continue;
    }
    const json& bound = bounds.at(name);
    const json figures = row_to_json(row);
    if (bound.value("cases", std::size_t{0}) != row.cases)
      lines.push_back(name + " has " + std::to_string(row.cases) + " cases, not " +
                      bound.value("cases", json(0)).dump() + "; remove its bounds where other cases are meant");
    if (bound.contains("right") && row.right < bound.at("right").get<double>() - k_rounding)
      lines.push_back(name + ": right in " + shown(row.right) + ", not in " + shown(bound.at("right")) + " or more");
    for (const char* member : k_at_most) {
      if (!figures.contains(member)) continue;
      const double is = figures.at(member);
      if (!bound.contains(member) || is > bound.at(member).get<double>() + k_rounding)
        lines.push_back(name + ": " + member + " is " + shown(is) + ", not " +
                        (bound.contains(member) ? shown(bound.at(member)) + " or less" : "bounded"));
    }
  }
  for (const auto& [name, bound] : bounds.items()) {
    if (std::find(seen.begin(), seen.end(), name) == seen.end()) lines.push_back(name + " has bounds but no row");
  }
  return lines;
}

json tightened(const json& bounds, std::span<const Row> rows) {
  json out = bounds;
  for (const Row& row : rows) {
    json& bound = out[name_of(row)];
    const json figures = row_to_json(row);
    if (!bound.contains("cases")) bound["cases"] = row.cases;
    if (row.of > 0) {
      // A share of labels may have a fraction; counts are whole.
      const double right = std::floor(row.right * 1000 + 1e-6) / 1000;
      if (!bound.contains("right") || bound.at("right").get<double>() < right) bound["right"] = right;
      if (!bound.contains("of")) bound["of"] = row.of;
    }
    for (const char* member : k_at_most) {
      if (!figures.contains(member)) continue;
      const double limit = rounded_up(figures.at(member));
      if (!bound.contains(member) || limit < bound.at(member).get<double>()) bound[member] = limit;
    }
  }
  return out;
}

}  // namespace penpose::judges
