#include "core/io/project/internal/sketch_json.h"

#include <cmath>

#include "core/base/members.h"

namespace penpose::io {
namespace {

using articulation::Mode;
using articulation::Sketch;
using geometry::ModelPoint;
using geometry::PxPoint;
using SketchProblem = std::optional<base::Error>;

constexpr const char* k_see_sketch_format = "see the format of sketch files in the manual";
constexpr std::int64_t k_largest_viewport = 100000;
constexpr std::int64_t k_most_pieces = 1000000;
constexpr const char* k_modes[] = {"auto", "translate", "rotate"};

base::Error wrong_sketch(std::string what, std::string pointer, std::string remedy = k_see_sketch_format) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

base::Error missing(const char* name, const std::string& pointer) {
  return wrong_sketch("the key \"" + std::string(name) + "\" is missing", pointer.empty() ? "/" : pointer);
}

/// The member of that name; null when it is missing or written as null.
const json::Json* given(const json::Json& object, const char* name) {
  const json::Json* value = json::find(object, name);
  return value == nullptr || value->is_null() ? nullptr : value;
}

/// A coordinate of world space: finite with room for squares.
std::optional<double> coordinate(const json::Json& value) {
  const auto n = json::number(value);
  return n && std::abs(*n) < 1e30 ? n : std::nullopt;
}

SketchProblem read_vector(const json::Json& value, const std::string& pointer, glm::dvec3& out) {
  if (!value.is_array() || value.size() != 3) return wrong_sketch("a list of three numbers was expected", pointer);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto n = coordinate(value[i]);
    if (!n) return wrong_sketch("a number was expected", json::child(pointer, i));
    out[static_cast<int>(i)] = *n;
  }
  return std::nullopt;
}

SketchProblem read_camera(const json::Json& value, const std::string& pointer, geometry::CameraPose& out) {
  if (!value.is_object()) return wrong_sketch("a camera was expected", pointer);
  for (const auto& [name, place] : {std::pair{"eye", &out.eye}, {"look_at", &out.look_at}, {"up", &out.up}}) {
    const json::Json* vector = given(value, name);
    if (vector == nullptr && place == &out.up) continue;
    if (vector == nullptr) return missing(name, pointer);
    if (auto problem = read_vector(*vector, json::child(pointer, name), *place)) return problem;
  }
  if (const json::Json* angle = given(value, "vertical_fov_degrees")) {
    const auto n = json::number(*angle);
    if (!n) return wrong_sketch("a number was expected", json::child(pointer, "vertical_fov_degrees"));
    out.vertical_fov_degrees = *n;
  }
  auto camera = geometry::Camera::make(out, {});
  if (camera) return std::nullopt;
  base::Error error = camera.error();
  error.place = error.place == "camera" ? pointer : json::child(pointer, error.place);
  return error;
}

SketchProblem read_own_camera(const json::Json& value, const char* name, const std::string& pointer,
                              std::optional<geometry::CameraPose>& out) {
  const json::Json* camera = given(value, name);
  if (camera == nullptr) return std::nullopt;
  return read_camera(*camera, json::child(pointer, name), out.emplace());
}

SketchProblem read_curve(const json::Json& value, const char* name, const std::string& pointer,
                         std::vector<PxPoint>& out) {
  const json::Json* list = given(value, name);
  if (list == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, name);
  if (!list->is_array()) return wrong_sketch("a list of points was expected", here);
  for (std::size_t i = 0; i < list->size(); ++i) {
    const json::Json& point = (*list)[i];
    const auto x = point.is_array() && point.size() == 2 ? json::number(point[0]) : std::nullopt;
    const auto y = x ? json::number(point[1]) : std::nullopt;
    if (!y) return wrong_sketch("a point [x, y] in px was expected", json::child(here, i));
    out.push_back({*x, *y});
  }
  return std::nullopt;
}

SketchProblem read_mode(const json::Json& value, const std::string& pointer, Mode& out) {
  const json::Json* mode = given(value, "mode");
  if (mode == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (mode->is_string() && mode->get_ref<const std::string&>() == k_modes[i]) {
      out = static_cast<Mode>(i);
      return std::nullopt;
    }
  }
  return wrong_sketch("the mode is not known", json::child(pointer, "mode"), R"(use "auto", "translate" or "rotate")");
}

SketchProblem read_member(const json::Json& value, const std::string& pointer, ModelPoint& out) {
  return read_vector(value, pointer, out);
}
SketchProblem read_member(const json::Json& value, const std::string& pointer, double& out) {
  const auto n = coordinate(value);
  if (!n) return wrong_sketch("a number was expected", pointer);
  out = *n;
  return std::nullopt;
}
SketchProblem read_member(const json::Json& value, const std::string& pointer, std::string& out) {
  if (!value.is_string()) return wrong_sketch("the name of a mesh was expected", pointer);
  out = value.get<std::string>();
  return std::nullopt;
}

/// One member stands alone, more are an object.
template <typename Kind>
SketchProblem read_kind(const json::Json& value, const std::string& pointer, articulation::Surface& out) {
  Kind kind;
  constexpr bool k_alone = decltype(Kind::members(kind))::k_count == 1;
  SketchProblem problem;
  base::each_member(kind, [&](std::string_view name, auto& member) {
    if (problem) return;
    if (k_alone) {
      problem = read_member(value, pointer, member);
      return;
    }
    const std::string key(name);
    const json::Json* found = given(value, key.c_str());
    problem = found == nullptr ? missing(key.c_str(), pointer) : read_member(*found, json::child(pointer, key), member);
  });
  out = std::move(kind);
  return problem;
}

SketchProblem read_surface(const json::Json& value, const std::string& pointer, articulation::Surface& out) {
  const json::Json* surface = given(value, "surface");
  if (surface == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "surface");
  std::string forms;
  std::optional<SketchProblem> problem;
  articulation::each_surface_kind([&]<typename Kind>() {
    const std::string key(Kind::k_key);
    const json::Json* one = given(*surface, key.c_str());
    if (one != nullptr)
      problem = problem ? wrong_sketch("a second surface is given", here)
                        : read_kind<Kind>(*one, json::child(here, key), out);
    forms += (forms.empty() ? "give " : " or ") + std::string(Kind::k_form);
  });
  return problem ? *problem : wrong_sketch("the surface is not known", here, forms);
}

SketchProblem read_range(const json::Json& value, const std::string& pointer, Sketch& out) {
  const json::Json* range = given(value, "range");
  if (range == nullptr) return std::nullopt;
  const auto minimum = range->is_array() && range->size() == 2 ? json::number((*range)[0]) : std::nullopt;
  const auto maximum = minimum ? json::number((*range)[1]) : std::nullopt;
  if (!maximum) return wrong_sketch("a range [minimum, maximum] was expected", json::child(pointer, "range"));
  out.minimum = *minimum;
  out.maximum = *maximum;
  return std::nullopt;
}

SketchProblem read_taken(const json::Json& value, const std::string& pointer, Sketch& out) {
  if (const json::Json* reach = given(value, "reach")) {
    const bool front = reach->is_string() && reach->get<std::string>() == "front";
    if (!front && !(reach->is_string() && reach->get<std::string>() == "through")) {
      return wrong_sketch("'through' or 'front' was expected", json::child(pointer, "reach"));
    }
    out.reach = front ? articulation::Reach::front : articulation::Reach::through;
  }
  if (const json::Json* piece = given(value, "piece")) {
    const auto n = json::whole_number(*piece, 0, k_most_pieces);
    if (!n) return wrong_sketch("the number of a piece, from 0, was expected", json::child(pointer, "piece"));
    out.piece = static_cast<std::uint32_t>(*n);
  }
  return std::nullopt;
}

SketchProblem read_betweens(const json::Json& value, const std::string& pointer, Sketch& out) {
  const json::Json* list = given(value, "betweens");
  if (list == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "betweens");
  if (!list->is_array()) return wrong_sketch("a list of targets was expected", here);
  if (list->size() > articulation::k_most_betweens)
    return wrong_sketch("there are too many targets", here, "use at most 64");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string at = json::child(here, i);
    const json::Json& one = (*list)[i];
    const json::Json* amount = one.is_object() ? given(one, "value") : nullptr;
    const auto n = amount == nullptr ? std::nullopt : json::number(*amount);
    if (!n) return wrong_sketch("a target with its \"value\" was expected", at);
    articulation::Between& between = out.betweens.emplace_back();
    between.value = *n;
    if (given(one, "target") == nullptr) return missing("target", at);
    if (auto problem = read_curve(one, "target", at, between.target)) return problem;
    if (auto problem = read_own_camera(one, "camera", at, between.camera)) return problem;
  }
  return std::nullopt;
}

json::Json to_json(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }

json::Json to_json(const geometry::CameraPose& camera) {
  return {{"eye", to_json(camera.eye)},
          {"look_at", to_json(camera.look_at)},
          {"up", to_json(camera.up)},
          {"vertical_fov_degrees", camera.vertical_fov_degrees}};
}

json::Json to_json(const std::vector<PxPoint>& curve) {
  json::Json points = json::Json::array();
  for (const PxPoint& p : curve) points.push_back(json::Json::array({p.x, p.y}));
  return points;
}

json::Json to_json(double value) { return value; }
json::Json to_json(const std::string& text) { return text; }

/// Null where there is none.
json::Json surface_json(const articulation::Surface& surface) {
  return of_surface(surface, json::Json(), [](const auto& one) {
    json::Json members = json::Json::object();
    base::each_member(one,
                      [&](std::string_view name, const auto& value) { members[std::string(name)] = to_json(value); });
    const bool alone = members.size() == 1;
    return json::Json{{std::string(one.k_key), alone ? json::Json(*members.begin()) : std::move(members)}};
  });
}

}  // namespace

std::optional<base::Error> read_viewport(const json::Json& object, const std::string& pointer,
                                         std::optional<geometry::Viewport>& out) {
  const json::Json* size = given(object, "viewport");
  if (size == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "viewport");
  if (!size->is_array() || size->size() != 2) return wrong_sketch("a size [width, height] in px was expected", here);
  std::int64_t sizes[2] = {0, 0};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto n = json::whole_number((*size)[i], 1, k_largest_viewport);
    if (!n) return wrong_sketch("a whole number of px, 1 to 100000, was expected", json::child(here, i));
    sizes[i] = *n;
  }
  out = geometry::Viewport{static_cast<int>(sizes[0]), static_cast<int>(sizes[1])};
  return std::nullopt;
}

std::optional<base::Error> read_sketch(const json::Json& value, const std::string& pointer,
                                       std::optional<geometry::Viewport> viewport, Sketch& out) {
  if (!value.is_object()) return wrong_sketch("a deformer was expected", pointer);
  const json::Json* name = given(value, "name");
  if (name == nullptr) return missing("name", pointer);
  if (!name->is_string()) return wrong_sketch("a text was expected", json::child(pointer, "name"));
  out.name = name->get<std::string>();
  if (auto problem = read_viewport(value, pointer, viewport)) return problem;
  if (!viewport) return missing("viewport", pointer);
  out.viewport = *viewport;
  const json::Json* camera = given(value, "camera");
  if (camera == nullptr) return missing("camera", pointer);
  if (auto problem = read_camera(*camera, json::child(pointer, "camera"), out.camera)) return problem;
  if (auto problem = read_own_camera(value, "reference_camera", pointer, out.reference_camera)) return problem;
  if (auto problem = read_own_camera(value, "target_camera", pointer, out.target_camera)) return problem;
  for (const char* curve : {"general", "specific", "target"}) {
    if (given(value, curve) == nullptr) return missing(curve, pointer);
  }
  if (auto problem = read_curve(value, "general", pointer, out.general)) return problem;
  if (auto problem = read_curve(value, "specific", pointer, out.specific)) return problem;
  if (auto problem = read_curve(value, "reference", pointer, out.reference)) return problem;
  if (auto problem = read_curve(value, "target", pointer, out.target)) return problem;
  if (auto problem = read_mode(value, pointer, out.mode)) return problem;
  if (auto problem = read_surface(value, pointer, out.surface)) return problem;
  if (auto problem = read_range(value, pointer, out)) return problem;
  if (const json::Json* paper = given(value, "paper")) {
    if (!paper->is_boolean()) return wrong_sketch("true or false was expected", json::child(pointer, "paper"));
    out.paper = paper->get<bool>();
  }
  if (const json::Json* sheet = given(value, "sheet")) {
    const bool other = sheet->is_string() && sheet->get<std::string>() == "other";
    if (!other && !(sheet->is_string() && sheet->get<std::string>() == "nearer")) {
      return wrong_sketch("'nearer' or 'other' was expected", json::child(pointer, "sheet"));
    }
    out.other_sheet = other;
  }
  if (auto problem = read_taken(value, pointer, out)) return problem;
  if (auto problem = read_betweens(value, pointer, out)) return problem;
  const auto checked = articulation::check_sketch(out);
  if (checked) return std::nullopt;
  base::Error error = checked.error();
  error.place = pointer + "/" + error.place;
  return error;
}

std::optional<base::Error> read_drivers(const json::Json& value, const std::string& pointer,
                                        std::vector<articulation::Driver>& out) {
  const json::Json* drivers = given(value, "drivers");
  if (drivers == nullptr) return missing("drivers", pointer);
  const std::string here = json::child(pointer, "drivers");
  if (!drivers->is_array()) return wrong_sketch("a list of [control, value] was expected", here);
  if (drivers->size() < articulation::k_fewest_drivers || drivers->size() > articulation::k_most_drivers) {
    return wrong_sketch("a correction is for a pose of 2 to 8 controls", here);
  }
  for (std::size_t i = 0; i < drivers->size(); ++i) {
    const json::Json& one = (*drivers)[i];
    const auto n = one.is_array() && one.size() == 2 && one[0].is_string() ? json::number(one[1]) : std::nullopt;
    if (!n) return wrong_sketch("[control, value] was expected", json::child(here, i));
    out.push_back({one[0].get<std::string>(), *n});
  }
  return std::nullopt;
}

json::Json to_json(const articulation::CorrectionSketch& correction, Viewports viewports) {
  json::Json value = to_json(correction.sketch, viewports);
  json::Json drivers = json::Json::array();
  for (const articulation::Driver& one : correction.drivers)
    drivers.push_back(json::Json::array({one.control, one.value}));
  value["drivers"] = std::move(drivers);
  return value;
}

json::Json to_json(const geometry::Viewport& viewport) { return json::Json::array({viewport.width, viewport.height}); }

json::Json to_json(const Sketch& sketch, Viewports viewports) {
  json::Json value = {{"name", sketch.name},
                      {"camera", to_json(sketch.camera)},
                      {"general", to_json(sketch.general)},
                      {"specific", to_json(sketch.specific)},
                      {"target", to_json(sketch.target)},
                      {"mode", k_modes[static_cast<std::size_t>(sketch.mode)]}};
  if (viewports == Viewports::each) value["viewport"] = to_json(sketch.viewport);
  if (!sketch.reference.empty()) value["reference"] = to_json(sketch.reference);
  if (sketch.reference_camera) value["reference_camera"] = to_json(*sketch.reference_camera);
  if (sketch.target_camera) value["target_camera"] = to_json(*sketch.target_camera);
  json::Json surface = surface_json(sketch.surface);
  if (!surface.is_null()) value["surface"] = std::move(surface);
  if (sketch.minimum != 0.0 || sketch.maximum != 1.0)
    value["range"] = json::Json::array({sketch.minimum, sketch.maximum});
  if (sketch.paper) value["paper"] = true;
  if (sketch.other_sheet) value["sheet"] = "other";
  if (sketch.reach == articulation::Reach::front) value["reach"] = "front";
  if (sketch.piece != 0) value["piece"] = sketch.piece;
  for (const articulation::Between& one : sketch.betweens) {
    json::Json between = {{"value", one.value}, {"target", to_json(one.target)}};
    if (one.camera) between["camera"] = to_json(*one.camera);
    value["betweens"].push_back(std::move(between));
  }
  return value;
}

}  // namespace penpose::io
