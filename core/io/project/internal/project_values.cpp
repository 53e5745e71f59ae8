#include "core/io/project/internal/project_values.h"

#include <cmath>

#include "core/document/commands/command_text.h"

namespace penpose::io {
namespace {

constexpr double k_largest_number = 1e15;

}  // namespace

base::Error project_error(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer),
          "open an earlier copy of the project, or remove this part of its extras"};
}

Problem read_row(const json::Json& value, const std::string& pointer, std::size_t count, std::vector<double>& out) {
  if (!value.is_array() || value.size() != count) {
    return project_error("a list of " + std::to_string(count) + " numbers was expected", pointer);
  }
  out.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = json::number(value[i]);
    if (!n || !(std::abs(*n) <= k_largest_number))
      return project_error("a number was expected", json::child(pointer, i));
    out.push_back(*n);
  }
  return std::nullopt;
}

Problem read_view(const json::Json& object, const std::string& pointer, document::View& out) {
  const json::Json* value = json::find(object, "view");
  const std::string here = json::child(pointer, "view");
  if (value == nullptr || !value->is_string()) return project_error("a view was expected", here);
  const auto view = document::parse_view(value->get<std::string>());
  if (!view || !geometry::Camera::make(view->camera, view->viewport)) return project_error("a view was expected", here);
  out = *view;
  return std::nullopt;
}

}  // namespace penpose::io
