#include "core/io/gltf/internal/gltf_extras.h"

#include <algorithm>
#include <cmath>

#include "core/base/edition.h"
#include "core/io/project/internal/named_curve_json.h"
#include "core/io/project/internal/sketch_json.h"

namespace penpose::io {
namespace {

constexpr const char* k_write_again = "remove the extras or write the file again";

base::Error wrong_extras(std::string what, std::string pointer, std::string remedy = k_write_again) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

const json::Json* own_extras(const json::Json& object) {
  const json::Json* extras = json::find(object, "extras");
  return extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
}

/// `count` moderate numbers, or nothing.
std::optional<std::vector<double>> read_numbers(const json::Json& value, std::size_t count) {
  if (!value.is_array() || value.size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const json::Json& item : value) {
    const auto n = json::number(item);
    if (!n || std::abs(*n) > 1e15) return std::nullopt;
    numbers.push_back(*n);
  }
  return numbers;
}

std::optional<base::Error> read_shape(const json::Json& value, const std::string& pointer, rig::Parameter& out) {
  const json::Json* name = json::find(value, "name");
  if (name == nullptr || !name->is_string()) return wrong_extras("a name was expected", pointer);
  out.name = name->get<std::string>();
  const auto member = [&](const char* key) {
    const json::Json* found = json::find(value, key);
    return found == nullptr ? std::nullopt : json::number(*found);
  };
  const auto rest = member("rest");
  const auto minimum = member("minimum");
  const auto maximum = member("maximum");
  if (!rest || !minimum || !maximum || !(*minimum < *maximum) || !(*minimum <= *rest && *rest <= *maximum)) {
    return wrong_extras("numbers minimum <= rest <= maximum were expected", pointer);
  }
  out.rest = *rest;
  out.minimum = *minimum;
  out.maximum = *maximum;
  return std::nullopt;
}

std::optional<base::Error> read_curve(const json::Json& value, const std::string& pointer, document::NamedCurve& out) {
  return read_named_curve(value, pointer, k_write_again, out);
}

std::optional<base::Error> read_flag(const json::Json& object, const char* name, const std::string& pointer,
                                     std::optional<bool>& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return std::nullopt;
  if (!value->is_boolean()) return wrong_extras("true or false was expected", json::child(pointer, name));
  out = value->get<bool>();
  return std::nullopt;
}

std::optional<base::Error> read_vector(const json::Json& object, const char* name, const std::string& pointer,
                                       std::optional<glm::dvec3>& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return std::nullopt;
  const auto numbers = read_numbers(*value, 3);
  if (!numbers) return wrong_extras("three numbers were expected", json::child(pointer, name));
  out = glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  return std::nullopt;
}

std::optional<base::Error> read_node(const json::Json& object, const std::string& pointer, NodeExtras& out) {
  if (!object.is_object()) return wrong_extras("an object was expected", pointer);
  std::optional<bool> joint;
  std::optional<bool> carried;
  std::optional<bool> still;
  std::optional<bool> group;
  std::optional<glm::dvec3> values;
  if (auto error = read_flag(object, "joint", pointer, joint)) return error;
  if (auto error = read_flag(object, "carried_by_parent", pointer, carried)) return error;
  if (auto error = read_flag(object, "still", pointer, still)) return error;
  if (auto error = read_flag(object, "group", pointer, group)) return error;
  if (auto error = read_flag(object, "posable", pointer, out.posable)) return error;
  if (auto error = read_vector(object, "minimum", pointer, out.minimum)) return error;
  if (auto error = read_vector(object, "maximum", pointer, out.maximum)) return error;
  if (auto error = read_vector(object, "values", pointer, values)) return error;
  out.joint = joint.value_or(false);
  out.carried_by_parent = carried.value_or(false);
  out.still = still.value_or(false);
  out.group = group.value_or(false);
  out.values = values.value_or(glm::dvec3(0));
  if (const json::Json* bind = json::find(object, "inverse_bind")) {
    const auto m = read_numbers(*bind, 16);
    if (!m) return wrong_extras("a matrix of 16 numbers was expected", json::child(pointer, "inverse_bind"));
    out.inverse_bind.emplace(1);
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 3; ++r) (*out.inverse_bind)[c][r] = (*m)[static_cast<std::size_t>(4 * c + r)];
    }
  }
  if (const json::Json* rotation = json::find(object, "rest_rotation")) {
    const auto q = read_numbers(*rotation, 4);
    if (q) out.rest_rotation = glm::dquat((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    if (!q || !(glm::dot(*out.rest_rotation, *out.rest_rotation) > 1e-12)) {
      return wrong_extras("a rotation [x, y, z, w] was expected", json::child(pointer, "rest_rotation"));
    }
  }
  return std::nullopt;
}

std::optional<base::Error> read_one_way(const json::Json& value, const std::string& pointer, OneWayName& out) {
  const bool known = value.is_array() && value.size() == 3 && value[0].is_string() && value[1].is_string() &&
                     value[2].is_number() && (value[2] == 1.0 || value[2] == -1.0);
  if (!known) return wrong_extras("[name, target, 1 or -1] was expected", pointer);
  out = {value[0].get<std::string>(), value[1].get<std::string>(), value[2].get<double>()};
  return std::nullopt;
}

/// Calls `read` for every item of the list of that name; a list that is missing is empty.
template <typename Item, typename Read>
std::optional<base::Error> read_list(const json::Json& object, const char* name, const std::string& pointer, Read read,
                                     std::vector<Item>& out) {
  const json::Json* list = json::find(object, name);
  if (list == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, name);
  if (!list->is_array()) return wrong_extras("a list was expected", here);
  for (std::size_t i = 0; i < list->size(); ++i) {
    if (auto error = read((*list)[i], json::child(here, i), out.emplace_back())) return error;
  }
  return std::nullopt;
}

}  // namespace

base::Result<RootExtras> read_root_extras(const json::Json& document) {
  RootExtras extras;
  const json::Json* own = own_extras(document);
  if (own == nullptr) return extras;
  const std::string pointer = json::child("/extras", k_extras_key);
  extras.present = true;
  const json::Json* edition = json::find(*own, "edition");
  const bool drawn = json::find(*own, "project") != nullptr || json::find(*own, "deformers") != nullptr;
  const auto number = edition == nullptr ? std::nullopt : json::whole_number(*edition, 1, base::k_edition);
  extras.of_another_edition = drawn && !number;
  if (drawn && number && *number < base::k_edition) extras.older_edition = static_cast<std::uint32_t>(*number);
  if (auto error = read_list(*own, "shapes", pointer, read_shape, extras.shapes)) return *error;
  if (auto error = read_list(*own, "curves", pointer, read_curve, extras.curves)) return *error;
  if (auto error = read_list(*own, "features", pointer, read_curve, extras.features)) return *error;
  if (auto error = read_list(*own, "one_way", pointer, read_one_way, extras.one_way)) return *error;
  const auto read_index = [](const json::Json& value, const std::string& at,
                             std::size_t& out) -> std::optional<base::Error> {
    const auto index = json::whole_number(value, 0, 0xffffffffLL);
    if (!index) return wrong_extras("the number of an animation was expected", at);
    out = static_cast<std::size_t>(*index);
    return std::nullopt;
  };
  if (auto error = read_list(*own, "animation_order", pointer, read_index, extras.animation_order)) return *error;
  if (extras.of_another_edition) return extras;
  const json::Json* deformers = json::find(*own, "deformers");
  if (deformers != nullptr && deformers->size() > k_most_deformers) {
    return wrong_extras("a model has at most 1,000 deformers", json::child(pointer, "deformers"));
  }
  const auto read_deformer = [](const json::Json& value, const std::string& at, articulation::Sketch& out) {
    return read_sketch(value, at, std::nullopt, out);
  };
  if (auto error = read_list(*own, "deformers", pointer, read_deformer, extras.deformers)) return *error;
  const json::Json* corrections = json::find(*own, "corrections");
  if (corrections != nullptr && corrections->size() > k_most_corrections) {
    return wrong_extras("a model has at most 100 corrections", json::child(pointer, "corrections"));
  }
  const auto read_correction = [](const json::Json& value, const std::string& at, articulation::CorrectionSketch& out) {
    auto error = read_sketch(value, at, std::nullopt, out.sketch);
    return error ? error : read_drivers(value, at, out.drivers);
  };
  if (auto error = read_list(*own, "corrections", pointer, read_correction, extras.corrections)) return *error;
  const auto read_names = [](const json::Json& value, const std::string& at,
                             std::vector<std::string>& out) -> std::optional<base::Error> {
    if (!value.is_array()) return wrong_extras("a list of names was expected", at);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!value[i].is_string()) return wrong_extras("a name was expected", json::child(at, i));
      out.push_back(value[i].get<std::string>());
    }
    return std::nullopt;
  };
  if (auto error = read_list(*own, "baked", pointer, read_names, extras.baked)) return *error;
  extras.baked.resize(extras.deformers.size());
  return extras;
}

base::Result<std::vector<NodeExtras>> read_node_extras(const json::Json& document, const RootExtras& root) {
  const json::Json* nodes = json::find(document, "nodes");
  std::vector<NodeExtras> extras(nodes == nullptr ? 0 : nodes->size());
  if (!root.present) return extras;
  for (std::size_t i = 0; i < extras.size(); ++i) {
    const json::Json* own = own_extras((*nodes)[i]);
    if (own == nullptr) continue;
    const std::string pointer = json::child(json::child("/nodes", i), "extras");
    if (auto error = read_node(*own, json::child(pointer, k_extras_key), extras[i])) return *error;
  }
  return extras;
}

base::Status check_curves(const RootExtras& root, std::size_t triangle_count) {
  const std::string own = json::child("/extras", k_extras_key);
  for (const auto& [member, curves] : {std::pair{"curves", &root.curves}, std::pair{"features", &root.features}}) {
    if (auto error = check_named_curves(*curves, triangle_count, json::child(own, member), k_write_again))
      return *error;
  }
  return base::Done{};
}

json::Json write_root_extras(const document::Model& model, const std::vector<std::vector<std::string>>& baked,
                             const std::vector<OneWayName>& one_way, const json::Json& project) {
  json::Json own = {{"edition", base::k_edition}};
  if (!project.is_null()) own["project"] = project;
  if (model.shapes) {
    json::Json shapes = json::Json::array();
    for (const rig::Parameter& p : model.shapes->parameters()) {
      shapes.push_back({{"name", p.name}, {"rest", p.rest}, {"minimum", p.minimum}, {"maximum", p.maximum}});
    }
    own["shapes"] = std::move(shapes);
  }
  if (model.deformers) {
    json::Json deformers = json::Json::array();
    for (const auto& deformer : model.deformers->deformers()) {
      deformers.push_back(to_json(deformer->sketch(), Viewports::each));
    }
    own["deformers"] = std::move(deformers);
    const bool any = std::any_of(baked.begin(), baked.end(), [](const auto& names) { return !names.empty(); });
    if (any) own["baked"] = baked;
  }
  if (model.corrections) {
    for (const auto& one : model.corrections->all()) {
      own["corrections"].push_back(to_json(one->drawn, Viewports::each));
    }
  }
  for (const OneWayName& one : one_way) own["one_way"].push_back({one.name, one.target, one.factor});
  for (const document::Expression& one : model.expressions) {
    json::Json values = json::Json::object();
    for (const auto& [parameter, value] : one.values) values[model.rig->parameters()[parameter].name] = value;
    json::Json kept = {{"name", one.name}, {"values", std::move(values)}};
    if (one.is_binary) kept["isBinary"] = true;
    for (const auto& [name, does] : {std::pair("overrideMouth", one.mouth), std::pair("overrideBlink", one.blink),
                                     std::pair("overrideLookAt", one.look)}) {
      if (does != document::ExpressionOverride::none)
        kept[name] = does == document::ExpressionOverride::block ? "block" : "blend";
    }
    own["expressions"].push_back(std::move(kept));
  }
  for (std::size_t b = 0; b < document::k_human_bones; ++b) {
    const auto bone = static_cast<document::HumanBone>(b);
    if (const auto joint = model.humanoid.joint(bone)) own["humanoid"][document::name_of(bone)] = *joint;
  }
  if (model.front_yaw_degrees != 0) own["front_yaw_degrees"] = model.front_yaw_degrees;
  if (!model.curves.empty()) own["curves"] = to_json(std::span(model.curves));
  if (!model.features.empty()) own["features"] = to_json(std::span(model.features));
  return {{k_extras_key, std::move(own)}};
}

}  // namespace penpose::io
