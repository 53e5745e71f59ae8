#include "tests/judges/table/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/numbers.h"

namespace penpose::judges {
namespace {

using Values = std::vector<double>;

/// The value below which this share of them lies, between the two nearest.
std::optional<double> quantile(Values values, double share) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  const double next = values[std::min(i + 1, values.size() - 1)];
  return values[i] + (next - values[i]) * (at - static_cast<double>(i));
}
std::optional<double> mean(const Values& values) {
  if (values.empty()) return {};
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

Values all_of(const std::vector<Outcome>& outcomes, std::optional<double> Outcome::*member) {
  Values values;
  for (const Outcome& one : outcomes) {
    if (one.*member) values.push_back(*(one.*member));
  }
  return values;
}

std::string cell(const std::optional<double>& value, int digits) {
  return value ? base::format_fixed(*value, digits) : "";
}

}  // namespace

Row row_of(const Judged& judged) {
  Row row;
  row.measure = judged.measure;
  row.rig = judged.rig;
  row.group = judged.group;
  row.cases = judged.outcomes.size();
  Values times;
  for (const Outcome& one : judged.outcomes) {
    row.right += one.right;
    row.nothing += one.nothing;
    row.of += one.of;
    row.offered += one.offered.value_or(0);
    row.offered_of += one.offered ? 1 : 0;
    times.push_back(one.ms);
  }
  const Values errors = all_of(judged.outcomes, &Outcome::error);
  const Values strays = all_of(judged.outcomes, &Outcome::stray);
  row.error_median = quantile(errors, 0.5);
  row.error_worst = quantile(errors, 1);
  row.stray_95 = quantile(strays, 0.95);
  row.stray_worst = quantile(strays, 1);
  row.still_worst = quantile(all_of(judged.outcomes, &Outcome::still), 1);
  row.left_mean = mean(all_of(judged.outcomes, &Outcome::left));
  row.controls = mean(all_of(judged.outcomes, &Outcome::controls));
  row.true_controls = mean(all_of(judged.outcomes, &Outcome::true_controls));
  row.ms_median = quantile(times, 0.5).value_or(0);
  row.ms_worst = quantile(times, 1).value_or(0);
  return row;
}

std::vector<Row> table_of(std::span<const Judged> judged) {
  std::vector<Row> rows;
  std::vector<Judged> totals;
  for (const Judged& one : judged) {
    rows.push_back(row_of(one));
    auto total = std::find_if(totals.begin(), totals.end(),
                              [&](const Judged& t) { return t.measure == one.measure && t.group == one.group; });
    if (total == totals.end()) total = totals.insert(totals.end(), {one.measure, "all", one.group, {}});
    total->outcomes.insert(total->outcomes.end(), one.outcomes.begin(), one.outcomes.end());
  }
  for (const Judged& total : totals) rows.push_back(row_of(total));
  return rows;
}

std::string printed(std::span<const Row> rows) {
  const auto padded = [](std::string text, std::size_t width, bool left) {
    const std::string space(text.size() < width ? width - text.size() : 0, ' ');
    return left ? text + space : space + text;
  };
  const auto line = [&](std::span<const std::string> cells) {
    constexpr std::size_t k_text = 3;
    constexpr std::array<std::size_t, 12> k_widths{10, 16, 9, 6, 10, 8, 16, 14, 7, 7, 11, 14};
    std::string out;
    for (std::size_t i = 0; i < cells.size(); ++i) out += (i ? " " : "") + padded(cells[i], k_widths[i], i < k_text);
    return out + "\n";
  };
  const std::vector<std::string> head{"measure", "rig",     "group",   "cases",  "right",    "offered",
                                      "error %", "stray %", "still %", "left %", "controls", "time ms"};
  std::string text = line(head);
  for (const Row& row : rows) {
    const auto two = [](const std::string& a, const std::string& b) { return a.empty() ? a : a + " / " + b; };
    const std::vector<std::string> cells{
        row.measure,
        row.rig,
        row.group,
        std::to_string(row.cases),
        row.of > 0 ? base::format_fixed(row.right, 0) + "/" + base::format_fixed(row.of, 0) : "",
        row.offered_of > 0 ? base::format_fixed(row.offered, 0) + "/" + base::format_fixed(row.offered_of, 0) : "",
        two(cell(row.error_median, 2), cell(row.error_worst, 1)),
        two(cell(row.stray_95, 2), cell(row.stray_worst, 2)),
        cell(row.still_worst, 2),
        cell(row.left_mean, 2),
        two(cell(row.controls, 1), cell(row.true_controls, 1)),
        base::format_fixed(row.ms_median, 1) + " / " + base::format_fixed(row.ms_worst, 1)};
    text += line(cells);
  }
  return text;
}

namespace {

struct Member {
  const char* name;
  std::optional<double> Row::*value;
};
constexpr std::array<Member, 8> k_members{{{"error_median", &Row::error_median},
                                           {"error_worst", &Row::error_worst},
                                           {"stray_95", &Row::stray_95},
                                           {"stray_worst", &Row::stray_worst},
                                           {"still_worst", &Row::still_worst},
                                           {"left_mean", &Row::left_mean},
                                           {"controls", &Row::controls},
                                           {"true_controls", &Row::true_controls}}};

/// Files keep four digits behind the point.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

nlohmann::json row_to_json(const Row& row) {
  nlohmann::json json{{"measure", row.measure},
                      {"rig", row.rig},
                      {"group", row.group},
                      {"cases", row.cases},
                      {"ms_median", rounded(row.ms_median)},
                      {"ms_worst", rounded(row.ms_worst)}};
  if (row.of > 0) json.update({{"right", row.right}, {"nothing", row.nothing}, {"of", row.of}});
  if (row.offered_of > 0) json.update({{"offered", row.offered}, {"offered_of", row.offered_of}});
  for (const Member& member : k_members) {
    if (row.*member.value) json[member.name] = rounded(*(row.*member.value));
  }
  return json;
}

std::string lined(const nlohmann::json& value) {
  const bool list = value.is_array();
  std::string text = list ? "[" : "{";
  const char* before = "\n ";
  for (const auto& [name, member] : value.items()) {
    const bool rows = name == "rows" && member.is_array();
    text += before + (list ? "" : nlohmann::json(name).dump() + ": ") + (rows ? lined(member) : member.dump());
    before = ",\n ";
  }
  return text + (list ? "\n]" : "\n}");
}

Row row_from_json(const nlohmann::json& json) {
  Row row;
  row.measure = json.at("measure");
  row.rig = json.at("rig");
  row.group = json.at("group");
  row.cases = json.value("cases", std::size_t{0});
  row.right = json.value("right", 0.0);
  row.nothing = json.value("nothing", 0.0);
  row.of = json.value("of", 0.0);
  row.offered = json.value("offered", 0.0);
  row.offered_of = json.value("offered_of", 0.0);
  row.ms_median = json.value("ms_median", 0.0);
  row.ms_worst = json.value("ms_worst", 0.0);
  for (const Member& member : k_members) {
    if (json.contains(member.name)) row.*member.value = json.at(member.name).get<double>();
  }
  return row;
}

}  // namespace penpose::judges
