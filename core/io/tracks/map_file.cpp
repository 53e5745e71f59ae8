#include "core/io/tracks/map_file.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/json/json.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

using MapProblem = std::optional<base::Error>;

base::Error wrong_map(std::string what, std::string pointer, std::string remedy = "see the format of map files") {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

template <typename Number>
MapProblem read_numbers_or_name(const json::Json& value, const std::string& pointer,
                                std::variant<std::vector<Number>, std::string>& out) {
  if (value.is_string()) {
    out = value.get<std::string>();
    return std::nullopt;
  }
  if (!value.is_array()) return wrong_map("a list of numbers or a name was expected", pointer);
  std::vector<Number> numbers;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto n = json::whole_number(value[i], 0, 0xffffffffLL);
    if (!n) return wrong_map("a number of 0 or more was expected", json::child(pointer, i));
    numbers.push_back(static_cast<Number>(*n));
  }
  if (numbers.size() < 2) return wrong_map("a curve needs at least two points", pointer);
  out = std::move(numbers);
  return std::nullopt;
}

MapProblem read_factor(const json::Json& object, const char* name, const std::string& pointer, double& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return std::nullopt;
  const auto n = json::number(*value);
  if (!n || !(*n > 0) || !(*n <= 1000)) {
    return wrong_map("a number above 0 and up to 1000 was expected", json::child(pointer, name));
  }
  out = *n;
  return std::nullopt;
}

MapProblem read_points(const json::Json& list, const std::string& pointer, MapPoints& out) {
  if (!list.is_array()) return wrong_map("a list was expected", pointer);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].is_string()) {
      out.emplace_back(list[i].get<std::string>());
      continue;
    }
    const auto n = json::whole_number(list[i], 0, 0xffffffffLL);
    if (!n) return wrong_map("a point number or the name of a tracked curve was expected", json::child(pointer, i));
    out.emplace_back(static_cast<std::size_t>(*n));
  }
  return std::nullopt;
}

MapProblem read_curve(const json::Json& value, const std::string& pointer, MapCurve& out) {
  if (!value.is_object()) return wrong_map("an object was expected", pointer);
  const json::Json* track = json::find(value, "track");
  const json::Json* reference = json::find(value, "reference");
  if (track == nullptr) return wrong_map("the key \"track\" is missing", pointer);
  if (reference == nullptr) return wrong_map("the key \"reference\" is missing", pointer);
  if (auto problem = read_numbers_or_name(*track, json::child(pointer, "track"), out.track)) return problem;
  if (auto problem = read_numbers_or_name(*reference, json::child(pointer, "reference"), out.reference)) return problem;
  for (const auto& [name, to] : {std::pair{"meets", &out.meets}, std::pair{"touches", &out.touches}}) {
    const json::Json* other = json::find(value, name);
    if (other == nullptr) continue;
    if (!other->is_string())
      return wrong_map("the name of another curve's reference was expected", json::child(pointer, name));
    *to = other->get<std::string>();
  }
  if (const json::Json* anchor = json::find(value, "anchor")) {
    if (auto problem = read_points(*anchor, json::child(pointer, "anchor"), out.anchor)) return problem;
  }
  if (auto problem = read_factor(value, "weight", pointer, out.weight)) return problem;
  return read_factor(value, "gain", pointer, out.gain);
}

constexpr std::array<std::string_view, 7> k_map_members = {"format", "curves", "stable", "turning",
                                                           "head",   "free",   "names"};
constexpr std::array<std::string_view, 7> k_curve_members = {"track",   "reference", "anchor", "meets",
                                                             "touches", "weight",    "gain"};

MapProblem read_curves(const json::Json& json, MapFile& out) {
  const json::Json* curves = json::find(json, "curves");
  if (curves == nullptr) {
    if (out.format->has_values) return std::nullopt;
    return wrong_map("the key \"curves\" is missing", "/");
  }
  if (!curves->is_array()) return wrong_map("a list was expected", "/curves");
  if (curves->empty() && !out.format->has_values) {
    return wrong_map("there is no curve", "/curves", "map at least one tracked curve to a curve of the model");
  }
  if (curves->size() > 1000) return wrong_map("a map has at most 1,000 curves", "/curves");
  for (std::size_t i = 0; i < curves->size(); ++i) {
    if (auto problem = read_curve((*curves)[i], json::child("/curves", i), out.curves.emplace_back())) return problem;
    json::list_unknown((*curves)[i], json::child("/curves", i), k_curve_members, out.skipped);
  }
  return std::nullopt;
}

MapProblem read_free(const json::Json& json, MapFile& out) {
  const json::Json* free = json::find(json, "free");
  if (free == nullptr) return std::nullopt;
  if (!free->is_array()) return wrong_map("a list of names was expected", "/free");
  for (std::size_t i = 0; i < free->size(); ++i) {
    if (!(*free)[i].is_string()) return wrong_map("a name was expected", json::child("/free", i));
    out.free.push_back((*free)[i].get<std::string>());
  }
  return std::nullopt;
}

MapProblem read_names(const json::Json& json, MapFile& out) {
  const json::Json* names = json::find(json, "names");
  if (names == nullptr) return std::nullopt;
  if (!names->is_object()) return wrong_map("an object of names was expected", "/names");
  for (const auto& [tracked, control] : names->items()) {
    if (!control.is_string()) return wrong_map("a name was expected", json::child("/names", tracked));
    out.names.emplace_back(tracked, control.get<std::string>());
  }
  return std::nullopt;
}

}  // namespace

base::Result<MapFile> read_map_file(base::Bytes bytes) {
  const auto json = json::parse_json(bytes);
  if (!json) return json.error();
  if (!json->is_object()) return wrong_map("an object was expected", "/");
  MapFile map;
  const json::Json* format = json::find(*json, "format");
  if (format == nullptr) return wrong_map("the key \"format\" is missing", "/");
  map.format = format->is_string() ? track_format_named(format->get<std::string>()) : nullptr;
  if (map.format == nullptr) {
    return wrong_map("the format is not known", "/format", std::string("use ").append(track_format_names("or")));
  }
  json::list_unknown(*json, "", k_map_members, map.skipped);
  if (auto problem = read_curves(*json, map)) return *problem;
  for (const auto& [name, points] : {std::pair("stable", &map.stable), std::pair("turning", &map.turning)}) {
    const json::Json* list = json::find(*json, name);
    if (list == nullptr) continue;
    if (auto problem = read_points(*list, json::child("", name), *points)) return *problem;
  }
  if (auto problem = read_free(*json, map)) return *problem;
  if (auto problem = read_names(*json, map)) return *problem;
  if (const json::Json* head = json::find(*json, "head")) {
    if (*head != "drop" && *head != "apply") return wrong_map("drop or apply was expected", "/head");
    map.apply_head = *head == "apply";
  }
  return map;
}

base::Result<MapFile> read_bundled_map(const TrackFormat& format) {
  const std::string_view text = bundled_map(format.name);
  if (text.empty()) {
    return base::Error{std::string("the program has no map for ").append(format.name), "", "write one"};
  }
  auto map = read_map_file(base::as_bytes(text));
  if (map) map->bundled = true;
  return map;
}

}  // namespace penpose::io
