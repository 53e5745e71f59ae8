#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/articulation/sketch.h"
#include "core/base/json/json.h"
#include "core/document/drawing/pose_curve.h"

// What a line of a conversation holds. Readers end the line with an error whose place is a JSON pointer.

namespace penpose::serve {

using json::Json;

/// Ends a line: it has changed nothing.
struct Refusal {
  base::Error error;
};
[[noreturn]] void refuse(std::string what, std::string place, std::string remedy);
/// The value of a result, or the end of the line.
template <typename T>
T taken(base::Result<T> result) {
  if (!result) throw Refusal{result.error()};
  return std::move(result).value();
}

/// A JSON object and its place in the line.
struct Request {
  const json::Json& json;
  std::string place;

  /// Ends the line where it has a member that is none of these: a misspelt one would count for nothing.
  void allow(std::initializer_list<std::string_view> names) const;
  [[nodiscard]] bool has(const char* name) const { return json.contains(name); }
  [[nodiscard]] std::string at(std::string_view name) const { return json::child(place, name); }
  [[nodiscard]] const json::Json& need(const char* name) const;

  [[nodiscard]] std::string text(const char* name) const;
  [[nodiscard]] std::string text_or(const char* name, std::string_view fallback) const;
  [[nodiscard]] double number_or(const char* name, double fallback) const;
  [[nodiscard]] bool truth_or(const char* name, bool fallback) const;
  [[nodiscard]] std::uint32_t whole(const char* name) const;
  [[nodiscard]] std::uint32_t whole_or(const char* name, std::uint32_t fallback) const;
  /// A list of numbers; one of rows of so many numbers, all after each other.
  [[nodiscard]] std::vector<double> numbers(const char* name) const;
  [[nodiscard]] std::vector<double> rows(const char* name, std::size_t width) const;
  [[nodiscard]] std::vector<std::uint32_t> wholes(const char* name) const;
  [[nodiscard]] std::vector<geometry::PxPoint> line(const char* name) const;
  [[nodiscard]] std::vector<std::vector<geometry::PxPoint>> lines(const char* name) const;
  [[nodiscard]] std::vector<geometry::ModelPoint> points(const char* name) const;
  [[nodiscard]] document::View view(const char* name) const;
};

[[nodiscard]] json::Json to_json(const document::View& view);
[[nodiscard]] json::Json to_json(const geometry::ModelPoint& p);

}  // namespace penpose::serve
