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

constexpr std::array<std::string_view, 4> k_target_members = {"control", "gain", "offset", "response"};
constexpr std::size_t k_most_targets = 100;
constexpr std::size_t k_most_response = 1000;

MapProblem read_number(const json::Json& json, const char* name, const std::string& place, double& out) {
  const json::Json* number = json::find(json, name);
  if (number == nullptr) return std::nullopt;
  if (!number->is_number() || !std::isfinite(number->get<double>()))
    return wrong_map("a number was expected", json::child(place, name));
  out = number->get<double>();
  return std::nullopt;
}

MapProblem read_response(const json::Json& json, const std::string& place, MapTarget& out) {
  const json::Json* response = json::find(json, "response");
  if (response == nullptr) return std::nullopt;
  const std::string at = json::child(place, "response");
  if (!response->is_array() || response->empty() || response->size() > k_most_response)
    return wrong_map("a list of [value, share] was expected", at);
  for (const json::Json& pair : *response) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number())
      return wrong_map("a list of [value, share] was expected", at);
    const auto one = std::pair(pair[0].get<double>(), pair[1].get<double>());
    if (!out.response.empty() && !(one.first > out.response.back().first))
      return wrong_map("values do not ascend", at, "list them from the least on, each once");
    out.response.push_back(one);
  }
  return std::nullopt;
}

/// "NAME" or {"control": "NAME", "gain": 0.35, ...}.
MapProblem read_target(const json::Json& json, const std::string& place, MapTarget& out,
                       std::vector<std::string>& skipped) {
  if (json.is_string()) {
    out.control = json.get<std::string>();
    return std::nullopt;
  }
  const json::Json* control = json.is_object() ? json::find(json, "control") : nullptr;
  if (control == nullptr || !control->is_string())
    return wrong_map("a name was expected", place, R"(write "NAME", or {"control": "NAME", "gain": 1})");
  out.control = control->get<std::string>();
  json::list_unknown(json, place, k_target_members, skipped);
  if (auto problem = read_number(json, "gain", place, out.gain)) return problem;
  if (auto problem = read_number(json, "offset", place, out.offset)) return problem;
  return read_response(json, place, out);
}

MapProblem read_names(const json::Json& json, MapFile& out) {
  const json::Json* names = json::find(json, "names");
  if (names == nullptr) return std::nullopt;
  if (!names->is_object()) return wrong_map("an object of names was expected", "/names");
  for (const auto& [tracked, targets] : names->items()) {
    const std::string place = json::child("/names", tracked);
    auto& read = out.names.emplace_back(tracked, std::vector<MapTarget>()).second;
    if (!targets.is_array()) {
      if (auto problem = read_target(targets, place, read.emplace_back(), out.skipped)) return problem;
      continue;
    }
    if (targets.size() > k_most_targets) return wrong_map("a column drives at most 100 controls", place);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (auto problem = read_target(targets[i], json::child(place, i), read.emplace_back(), out.skipped))
        return problem;
    }
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
