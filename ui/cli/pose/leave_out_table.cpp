#include "ui/cli/pose/leave_out_table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"

namespace penpose::cli {
namespace {

using json::Json;

struct Column {
  const char* title;
  const char* key;
  double prior::LeftOut::*left;
};

constexpr Column k_columns[] = {{"not moving", "not_moving", &prior::LeftOut::still},
                                {"mean", "mean", &prior::LeftOut::mean},
                                {"suggested", "suggested", &prior::LeftOut::suggested}};

/// Of a key at rest there are no percents.
double percent(double left, double way) { return way > 0 ? 100 * left / way : 0; }

double median(std::span<const prior::LeftOut> rows, double prior::LeftOut::*left) {
  std::vector<double> errors;
  for (const prior::LeftOut& row : rows) {
    if (row.way > 0) errors.push_back(percent(row.*left, row.way));
  }
  if (errors.empty()) return 0;
  std::sort(errors.begin(), errors.end());
  const std::size_t half = errors.size() / 2;
  return errors.size() % 2 == 1 ? errors[half] : 0.5 * (errors[half - 1] + errors[half]);
}

double together(std::span<const prior::LeftOut> rows, double prior::LeftOut::*left) {
  double sum = 0;
  double ways = 0;
  for (const prior::LeftOut& row : rows) {
    sum += row.*left * row.*left;
    ways += row.way * row.way;
  }
  return percent(std::sqrt(sum), std::sqrt(ways));
}

std::string cell(double value) { return base::format_fixed(value, 1) + " %"; }

template <typename Value>
void print_summary(const char* title, const Value& value) {
  std::cout << std::left << std::setw(36) << title << std::right;
  for (const Column& column : k_columns) std::cout << std::setw(12) << cell(value(column));
  std::cout << '\n';
}

}  // namespace

void print_left_out(std::span<const document::PoseKey> keys, std::span<const prior::LeftOut> rows) {
  std::cout << std::setw(10) << "time"
            << "  " << std::left << std::setw(16) << "name" << std::right << std::setw(8) << "held";
  for (const Column& column : k_columns) std::cout << std::setw(12) << column.title;
  std::cout << "  strength\n";
  for (const prior::LeftOut& row : rows) {
    const document::PoseKey& key = keys[row.key];
    std::cout << std::setw(8) << base::format_fixed(key.time_s, 2) << " s  " << std::left << std::setw(16)
              << base::shown_name(key.name) << std::right << std::setw(8) << row.held;
    for (const Column& column : k_columns) {
      std::cout << std::setw(12) << (row.way > 0 ? cell(percent(row.*column.left, row.way)) : "at rest");
    }
    std::cout << std::setw(10) << base::format_fixed(row.strength, 2) << '\n';
  }
  print_summary("median", [&](const Column& column) { return median(rows, column.left); });
  print_summary("all keys together", [&](const Column& column) { return together(rows, column.left); });
}

void print_left_out_json(const std::string& model, std::span<const document::PoseKey> keys,
                         std::span<const prior::LeftOut> rows) {
  Json list = Json::array();
  for (const prior::LeftOut& row : rows) {
    Json one = {{"time_s", keys[row.key].time_s}, {"name", keys[row.key].name}, {"held", row.held}};
    for (const Column& column : k_columns) {
      one[column.key] = row.way > 0 ? Json(percent(row.*column.left, row.way)) : Json(nullptr);
    }
    one["strength"] = row.strength;
    list.push_back(std::move(one));
  }
  Json medians = Json::object();
  Json all = Json::object();
  for (const Column& column : k_columns) {
    medians[column.key] = median(rows, column.left);
    all[column.key] = together(rows, column.left);
  }
  const Json out = {{"model", model}, {"keys", std::move(list)}, {"median", medians}, {"all", all}};
  std::cout << out.dump_as_made() << '\n';
}

}  // namespace penpose::cli
