#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"

namespace penpose::io {

/// The error, or nothing. Its place is a JSON pointer.
using Problem = std::optional<base::Error>;

inline constexpr std::size_t k_most_curves = 10000;

/// With the remedy for projects.
[[nodiscard]] base::Error project_error(std::string what, std::string pointer);
/// A row of exactly `count` moderate numbers.
[[nodiscard]] Problem read_row(const json::Json& value, const std::string& pointer, std::size_t count,
                               std::vector<double>& out);
/// The member "view" of an object.
[[nodiscard]] Problem read_view(const json::Json& object, const std::string& pointer, document::View& out);

/// Calls `take(row)` for every row of a member; a member that is missing has none.
template <typename Take>
Problem read_rows(const json::Json& object, const char* name, const std::string& pointer, std::size_t width,
                  std::size_t most, Take take) {
  const json::Json* rows = json::find(object, name);
  if (rows == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, name);
  if (!rows->is_array() || rows->size() > most) return project_error("a list was expected", here);
  std::vector<double> row;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (auto problem = read_row((*rows)[i], json::child(here, i), width, row)) return problem;
    if (auto problem = take(row, json::child(here, i))) return problem;
  }
  return std::nullopt;
}

}  // namespace penpose::io
