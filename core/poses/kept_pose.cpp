#include "core/poses/kept_pose.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/json/json.h"
#include "core/poses/base64.h"

namespace penpose::poses {
namespace {

using json::Json;

constexpr const char* k_form = "penpose_pose";
constexpr std::size_t k_most_controls = 20000;
constexpr std::size_t k_most_features = 200;
constexpr std::size_t k_most_points = 200;
constexpr std::size_t k_most_name = 100;
/// No face goes farther than this, in its own units; what does is no pose.
constexpr double k_farthest = 1000;
constexpr std::size_t k_most_picture = std::size_t{1} << 20;

base::Error wrong(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), "keep the pose again, or see \"Poses\" in docs/formats.md"};
}

std::optional<ModelVector> vector_of(const Json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  ModelVector v(0);
  for (int k = 0; k < 3; ++k) {
    const auto value = json::number(json[k]);
    if (!value || std::abs(*value) > k_farthest) return std::nullopt;
    v[k] = *value;
  }
  return v;
}

std::optional<std::vector<ModelVector>> vectors_of(const Json* json) {
  if (json == nullptr || !json->is_array() || json->size() > k_most_points) return std::nullopt;
  std::vector<ModelVector> all;
  for (std::size_t i = 0; i < json->size(); ++i) {
    const auto v = vector_of((*json)[i]);
    if (!v) return std::nullopt;
    all.push_back(*v);
  }
  return all;
}

std::optional<std::string> text_of(const Json& object, const char* member) {
  const Json* text = json::find(object, member);
  if (text == nullptr || !text->is_string()) return std::nullopt;
  return text->get<std::string>();
}

std::optional<base::Error> read_rig(const Json& root, KeptPose& pose) {
  const Json* rig = json::find(root, "rig");
  if (rig == nullptr) return std::nullopt;
  if (!rig->is_object()) return wrong("an object was expected", "/rig");
  pose.model = text_of(*rig, "model").value_or("");
  const Json* controls = json::find(*rig, "controls");
  if (controls == nullptr) return std::nullopt;
  if (!controls->is_array() || controls->size() > k_most_controls)
    return wrong("a list of controls was expected", "/rig/controls");
  for (std::size_t i = 0; i < controls->size(); ++i) {
    if (!(*controls)[i].is_string()) return wrong("a name was expected", json::child("/rig/controls", i));
    pose.controls.push_back((*controls)[i].get<std::string>());
  }
  return std::nullopt;
}

std::optional<base::Error> read_values(const Json& root, KeptPose& pose) {
  const Json* values = json::find(root, "values");
  if (values == nullptr || !values->is_object() || values->size() > k_most_controls)
    return wrong("controls and their values were expected", "/values");
  for (const auto& [control, value] : values->items()) {
    const auto number = json::number(value);
    if (!number) return wrong("a number was expected", json::child("/values", control));
    pose.values.push_back({control, *number});
  }
  const Json* does = json::find(root, "does");
  if (does == nullptr) return std::nullopt;
  if (!does->is_object()) return wrong("an object of controls was expected", "/does");
  for (KeptValue& one : pose.values) {
    const Json* of_control = json::find(*does, one.control.c_str());
    if (of_control == nullptr) continue;
    const std::string here = json::child("/does", one.control);
    if (!of_control->is_object() || of_control->size() > k_most_features)
      return wrong("features and how far they go were expected", here);
    for (const auto& [feature, move] : of_control->items()) {
      const auto v = vector_of(move);
      if (!v) return wrong("[x, y, z] was expected", json::child(here, feature));
      one.does.emplace_back(feature, *v);
    }
  }
  return std::nullopt;
}

std::optional<base::Error> read_moves(const Json& root, KeptPose& pose) {
  const Json* moves = json::find(root, "moves");
  if (moves == nullptr) return std::nullopt;
  if (!moves->is_object() || moves->size() > k_most_features)
    return wrong("features and how far they go were expected", "/moves");
  for (const auto& [feature, list] : moves->items()) {
    auto all = vectors_of(&list);
    if (!all || all->size() != k_places)
      return wrong("nine times [x, y, z] was expected", json::child("/moves", feature));
    pose.moves.push_back({feature, std::move(*all)});
  }
  return std::nullopt;
}

std::optional<base::Error> read_lines(const Json& root, KeptPose& pose) {
  const Json* lines = json::find(root, "lines");
  if (lines == nullptr) return std::nullopt;
  if (!lines->is_array() || lines->size() > k_most_features) return wrong("a list of lines was expected", "/lines");
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const Json& one = (*lines)[i];
    const std::string here = json::child("/lines", i);
    KeptLine line;
    line.feature = text_of(one, "feature").value_or("");
    const Json* from = json::find(one, "from");
    const auto direction = from != nullptr ? vector_of(*from) : std::nullopt;
    if (line.feature.empty()) return wrong("the name of a feature was expected", json::child(here, "feature"));
    if (!direction || !(geometry::length(*direction) > 1e-6))
      return wrong("a direction [x, y, z] was expected", json::child(here, "from"));
    line.from = geometry::normalized(*direction);
    const Json* at = json::find(one, "at");
    auto moves = vectors_of(json::find(one, "moves"));
    if (!moves || moves->size() < 2) return wrong("two [x, y, z] or more were expected", json::child(here, "moves"));
    if (at == nullptr || !at->is_array() || at->size() != moves->size())
      return wrong("as many numbers as moves were expected", json::child(here, "at"));
    for (std::size_t k = 0; k < at->size(); ++k) {
      const auto share = json::number((*at)[k]);
      const bool inside = share && *share >= 0 && *share <= 1;
      if (!inside || (!line.at.empty() && *share < line.at.back()))
        return wrong("ascending numbers of 0 to 1 were expected", json::child(here, "at"));
      line.at.push_back(*share);
    }
    line.moves = std::move(*moves);
    pose.lines.push_back(std::move(line));
  }
  return std::nullopt;
}

std::optional<base::Error> read_pictures(const Json& root, KeptPose& pose) {
  const Json* pictures = json::find(root, "pictures");
  if (pictures == nullptr) return std::nullopt;
  for (const auto& [name, text] : pictures->items()) {
    const std::string here = json::child("/pictures", name);
    const auto part = part_named(name);
    if (!part) return wrong("all, brows, eyes or mouth was expected", here);
    if (!text.is_string() || text.get_ref<const std::string&>().size() > k_most_picture)
      return wrong("a picture of at most a megabyte was expected", here);
    auto bytes = base64_bytes(text.get_ref<const std::string&>());
    if (!bytes) return wrong("base64 was expected", here);
    pose.pictures[static_cast<std::size_t>(*part)] = std::move(*bytes);
  }
  return std::nullopt;
}

/// Six places: a face's size in millionths, less than any file of a model tells.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json json_of(const ModelVector& v) {
  Json out = Json::array();
  for (int k = 0; k < 3; ++k) out.push_back(rounded(v[k]));
  return out;
}

Json json_of(const std::vector<ModelVector>& all) {
  Json out = Json::array();
  for (const ModelVector& v : all) out.push_back(json_of(v));
  return out;
}

Json json_of(const KeptLine& line) {
  Json out = Json::object();
  out["feature"] = line.feature;
  out["from"] = json_of(line.from);
  Json at = Json::array();
  for (const double share : line.at) at.push_back(rounded(share));
  out["at"] = std::move(at);
  out["moves"] = json_of(line.moves);
  return out;
}

}  // namespace

bool is_pose_name(const std::string& name) {
  return !name.empty() && name.size() <= k_most_name && std::none_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
}

base::Result<KeptPose> read_kept_pose(base::Bytes bytes) {
  const auto root = json::parse_json(bytes);
  if (!root) return root.error();
  const Json* form = json::find(*root, k_form);
  if (form == nullptr) return base::Error{"this is no pose", "", "a pose has \"penpose_pose\": 1"};
  const auto number = json::whole_number(*form, 1, 1'000'000);
  if (!number) return wrong("the number of a format was expected", std::string("/") + k_form);
  if (*number != k_pose_format) {
    return base::Error{
        "a pose of format " + std::to_string(*number) + ", this program reads " + std::to_string(k_pose_format),
        std::string("/") + k_form, "keep it with the same version of penpose"};
  }
  KeptPose pose;
  pose.name = text_of(*root, "name").value_or("");
  if (!is_pose_name(pose.name)) return wrong("a name of 1 to 100 characters was expected", "/name");
  for (const auto read : {read_rig, read_values, read_moves, read_lines, read_pictures}) {
    if (auto error = read(*root, pose)) return *error;
  }
  return pose;
}

std::string write_kept_pose(const KeptPose& pose) {
  Json root = Json::object();
  root[k_form] = k_pose_format;
  root["name"] = pose.name;
  Json rig = Json::object();
  rig["model"] = pose.model;
  rig["controls"] = Json(pose.controls);
  root["rig"] = std::move(rig);
  Json values = Json::object();
  Json does = Json::object();
  for (const KeptValue& one : pose.values) {
    values[one.control] = one.value;
    Json of_control = Json::object();
    for (const auto& [feature, move] : one.does) of_control[feature] = json_of(move);
    if (!one.does.empty()) does[one.control] = std::move(of_control);
  }
  root["values"] = std::move(values);
  root["does"] = std::move(does);
  Json moves = Json::object();
  for (const FeatureMoves& one : pose.moves) moves[one.feature] = json_of(one.moves);
  root["moves"] = std::move(moves);
  Json lines = Json::array();
  for (const KeptLine& line : pose.lines) lines.push_back(json_of(line));
  root["lines"] = std::move(lines);
  Json pictures = Json::object();
  for (std::size_t p = 0; p < pose.pictures.size(); ++p) {
    if (!pose.pictures[p].empty()) pictures[name_of(static_cast<FacePart>(p))] = base64_text(pose.pictures[p]);
  }
  root["pictures"] = std::move(pictures);
  // A member a line: short enough to be looked at, and without a line for every number.
  std::string text = "{\n";
  for (const auto* member : root.members_as_made()) {
    if (text.size() > 2) text += ",\n";
    json::append_text(text, member->first);
    text += ": " + member->second.dump_as_made();
  }
  return text + "\n}\n";
}

}  // namespace penpose::poses
