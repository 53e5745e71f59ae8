#include "core/io/project/internal/project_bookmarks.h"

#include <cmath>
#include <optional>
#include <utility>

namespace penpose::io {
namespace {

std::optional<double> bookmark_number(const json::Json& object, const char* name, double most) {
  const json::Json* value = json::find(object, name);
  const auto number = value == nullptr ? std::nullopt : json::number(*value);
  return number && *number >= 0 && *number <= most ? number : std::nullopt;
}

Problem read_bookmark(const json::Json& value, const std::string& here, document::Bookmark& out) {
  const auto time = bookmark_number(value, "time_s", document::k_latest_key_s);
  if (!time) return project_error("seconds from 0 to 36000 were expected", json::child(here, "time_s"));
  out.time_s = *time;
  const json::Json* name = json::find(value, "name");
  if (name == nullptr || !name->is_string() || name->get<std::string>().size() > document::k_longest_bookmark)
    return project_error("a name of at most 200 bytes was expected", json::child(here, "name"));
  out.name = name->get<std::string>();
  const auto color = bookmark_number(value, "color", document::k_bookmark_colors - 1);
  if (!color || std::floor(*color) != *color)
    return project_error("the number of a colour was expected, 0 to 5", json::child(here, "color"));
  out.color = static_cast<std::uint32_t>(*color);
  return std::nullopt;
}

}  // namespace

json::Json bookmarks_to_json(const document::Bookmarks& bookmarks) {
  json::Json list = json::Json::array();
  for (const document::Bookmark& one : bookmarks)
    list.push_back({{"time_s", one.time_s}, {"name", one.name}, {"color", std::size_t{one.color}}});
  return list;
}

Problem read_bookmarks(const json::Json& object, const std::string& pointer,
                       std::shared_ptr<const document::Bookmarks>& out) {
  const json::Json* value = json::find(object, "bookmarks");
  if (value == nullptr) return std::nullopt;
  const std::string list = json::child(pointer, "bookmarks");
  if (!value->is_array() || value->empty() || value->size() > document::k_most_bookmarks)
    return project_error("a list of 1 to 1000 bookmarks was expected", list);
  document::Bookmarks bookmarks;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string here = json::child(list, i);
    document::Bookmark one;
    if (auto problem = read_bookmark((*value)[i], here, one)) return problem;
    if (!bookmarks.empty() && one.time_s <= bookmarks.back().time_s)
      return project_error("moments were expected that ascend", json::child(here, "time_s"));
    bookmarks.push_back(std::move(one));
  }
  out = document::shared_bookmarks(std::move(bookmarks));
  return std::nullopt;
}

Problem read_project_bookmarks(const json::Json& project, const std::string& pointer, document::Document& out) {
  return read_bookmarks(project, pointer, out.bookmarks);
}

}  // namespace penpose::io
