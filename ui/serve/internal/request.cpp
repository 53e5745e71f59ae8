#include "ui/serve/internal/request.h"

#include <algorithm>

namespace penpose::serve {
namespace {

/// Of a list in a line; what a command may hold is less.
constexpr std::size_t k_most_entries = 4'000'000;

double number_at(const Json& value, const std::string& place) {
  const auto number = json::number(value);
  if (!number) refuse("a number was expected", place, "give one");
  return *number;
}

std::uint32_t whole_at(const Json& value, const std::string& place) {
  const auto number = json::whole_number(value, 0, 0xffffffffLL);
  if (!number) refuse("a whole number was expected", place, "give one from 0 to 4294967295");
  return static_cast<std::uint32_t>(*number);
}

const Json& list_at(const Json& value, const std::string& place) {
  if (!value.is_array() || value.size() > k_most_entries) refuse("a list was expected", place, "give one in [ ]");
  return value;
}

std::vector<double> rows_at(const Json& value, const std::string& place, std::size_t width) {
  std::vector<double> out;
  const Json& list = list_at(value, place);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string where = json::child(place, i);
    if (!list[i].is_array() || list[i].size() != width)
      refuse("a list of " + std::to_string(width) + " numbers was expected", where, "give one");
    for (const Json& number : list[i]) out.push_back(number_at(number, where));
  }
  return out;
}

std::vector<geometry::PxPoint> line_at(const Json& value, const std::string& place) {
  const auto numbers = rows_at(value, place, 2);
  std::vector<geometry::PxPoint> out;
  for (std::size_t i = 0; i < numbers.size(); i += 2) out.push_back({numbers[i], numbers[i + 1]});
  return out;
}

geometry::ModelPoint point_at(const Request& request, const char* name) {
  const auto numbers = request.numbers(name);
  if (numbers.size() != 3) refuse("three numbers were expected", request.at(name), "give [x, y, z]");
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

void refuse(std::string what, std::string place, std::string remedy) {
  throw Refusal{{std::move(what), std::move(place), std::move(remedy)}};
}

void Request::allow(std::initializer_list<std::string_view> names) const {
  for (const auto& [name, value] : json.items()) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    std::string known;
    for (const std::string_view one : names) known += (known.empty() ? "" : ", ") + std::string(one);
    refuse("there is no such member", at(name), "known are: " + known);
  }
}

const Json& Request::need(const char* name) const {
  const auto found = json.find(name);
  if (found == json.end()) refuse("it is missing", at(name), "add it");
  return *found;
}

std::string Request::text(const char* name) const {
  const Json& value = need(name);
  if (!value.is_string()) refuse("a text was expected", at(name), "give one in quotation marks");
  return value.get<std::string>();
}

std::string Request::text_or(const char* name, std::string_view fallback) const {
  return has(name) ? text(name) : std::string(fallback);
}

double Request::number_or(const char* name, double fallback) const {
  return has(name) ? number_at(need(name), at(name)) : fallback;
}

bool Request::truth_or(const char* name, bool fallback) const {
  if (!has(name)) return fallback;
  if (!need(name).is_boolean()) refuse("true or false was expected", at(name), "give one");
  return need(name).get<bool>();
}

std::uint32_t Request::whole(const char* name) const { return whole_at(need(name), at(name)); }

std::uint32_t Request::whole_or(const char* name, std::uint32_t fallback) const {
  return has(name) ? whole(name) : fallback;
}

std::vector<double> Request::numbers(const char* name) const {
  std::vector<double> out;
  const Json& list = list_at(need(name), at(name));
  for (std::size_t i = 0; i < list.size(); ++i) out.push_back(number_at(list[i], json::child(at(name), i)));
  return out;
}

std::vector<double> Request::rows(const char* name, std::size_t width) const {
  return rows_at(need(name), at(name), width);
}

std::vector<std::uint32_t> Request::wholes(const char* name) const {
  std::vector<std::uint32_t> out;
  const Json& list = list_at(need(name), at(name));
  for (std::size_t i = 0; i < list.size(); ++i) out.push_back(whole_at(list[i], json::child(at(name), i)));
  return out;
}

std::vector<geometry::PxPoint> Request::line(const char* name) const { return line_at(need(name), at(name)); }

std::vector<std::vector<geometry::PxPoint>> Request::lines(const char* name) const {
  std::vector<std::vector<geometry::PxPoint>> out;
  const Json& list = list_at(need(name), at(name));
  for (std::size_t i = 0; i < list.size(); ++i) out.push_back(line_at(list[i], json::child(at(name), i)));
  return out;
}

std::vector<geometry::ModelPoint> Request::points(const char* name) const {
  const auto numbers = rows(name, 3);
  std::vector<geometry::ModelPoint> out;
  for (std::size_t i = 0; i < numbers.size(); i += 3) out.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return out;
}

document::View Request::view(const char* name) const {
  const Json& value = need(name);
  if (!value.is_object())
    refuse("a view was expected", at(name), "give eye, look_at, up, vertical_fov_degrees, viewport");
  const Request request{value, at(name)};
  request.allow({"eye", "look_at", "up", "vertical_fov_degrees", "viewport"});
  document::View view;
  view.camera = {
      point_at(request, "eye"), point_at(request, "look_at"), {0, 1, 0}, request.number_or("vertical_fov_degrees", 30)};
  if (request.has("up")) view.camera.up = point_at(request, "up");
  if (request.has("viewport")) {
    const auto sides = request.wholes("viewport");
    constexpr std::uint32_t k_longest_px = 32768;
    const bool fits = sides.size() == 2 && std::max(sides[0], sides[1]) <= k_longest_px;
    if (!fits) refuse("the size of a picture was expected", request.at("viewport"), "give [width, height] in px");
    view.viewport = {static_cast<int>(sides[0]), static_cast<int>(sides[1])};
  }
  return view;
}

Json to_json(const geometry::ModelPoint& p) { return {p.x, p.y, p.z}; }

Json to_json(const document::View& view) {
  return {{"eye", to_json(view.camera.eye)},
          {"look_at", to_json(view.camera.look_at)},
          {"up", to_json(view.camera.up)},
          {"vertical_fov_degrees", view.camera.vertical_fov_degrees},
          {"viewport", {view.viewport.width, view.viewport.height}}};
}

}  // namespace penpose::serve
