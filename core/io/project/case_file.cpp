#include "core/io/project/case_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/json/json.h"

namespace penpose::io {
namespace {

constexpr const char* k_see_case_format = "see the format of pose cases in the manual";

base::Error wrong_case(std::string what, std::string pointer, std::string remedy = k_see_case_format) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

// Each of these fills `out` from the member of that name, leaves it alone when the member is missing and optional, and
// returns the error otherwise.
using CaseProblem = std::optional<base::Error>;
enum class Need : std::uint8_t { required, optional };

CaseProblem missing(const char* name, const std::string& pointer, Need need) {
  if (need == Need::optional) return std::nullopt;
  return wrong_case("the key \"" + std::string(name) + "\" is missing", pointer.empty() ? "/" : pointer);
}

CaseProblem read_text(const json::Json& object, const char* name, const std::string& pointer, Need need,
                      std::string& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return missing(name, pointer, need);
  if (!value->is_string()) return wrong_case("a text was expected", json::child(pointer, name));
  out = value->get<std::string>();
  return std::nullopt;
}

CaseProblem read_number(const json::Json& object, const char* name, const std::string& pointer,
                        std::optional<double>& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return std::nullopt;
  out = json::number(*value);
  if (!out) return wrong_case("a number was expected", json::child(pointer, name));
  return std::nullopt;
}

/// The array of that name; null through `out` when it is missing and optional.
CaseProblem read_array(const json::Json& object, const char* name, const std::string& pointer, Need need,
                       const json::Json*& out) {
  out = json::find(object, name);
  if (out == nullptr) return missing(name, pointer, need);
  if (!out->is_array()) return wrong_case("a list was expected", json::child(pointer, name));
  return std::nullopt;
}

CaseProblem read_vertices(const json::Json& object, const std::string& pointer, std::vector<std::uint32_t>& out) {
  const json::Json* list = nullptr;
  if (auto problem = read_array(object, "vertices", pointer, Need::required, list)) return problem;
  const std::string here = json::child(pointer, "vertices");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto vertex = json::whole_number((*list)[i], 0, 0xffffffffLL);
    if (!vertex) return wrong_case("a vertex number (0 or more) was expected", json::child(here, i));
    out.push_back(static_cast<std::uint32_t>(*vertex));
  }
  if (out.size() < 2) return wrong_case("a curve needs at least two points", here, "list the vertices along the curve");
  return std::nullopt;
}

CaseProblem read_target(const json::Json& object, const std::string& pointer, std::vector<geometry::ModelPoint>& out) {
  const json::Json* list = nullptr;
  if (auto problem = read_array(object, "target", pointer, Need::required, list)) return problem;
  const std::string here = json::child(pointer, "target");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const json::Json& point = (*list)[i];
    if (!point.is_array() || point.size() != 3)
      return wrong_case("a point [x, y, z] was expected", json::child(here, i));
    geometry::ModelPoint p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto coordinate = json::number(point[axis]);
      // The square of a coordinate has to stay finite, or distances mean nothing.
      if (!coordinate || !(std::abs(*coordinate) < 1e100)) {
        return wrong_case("a coordinate was expected", json::child(json::child(here, i), axis));
      }
      p[static_cast<int>(axis)] = *coordinate;
    }
    out.push_back(p);
  }
  if (out.size() < 2) return wrong_case("a curve needs at least two points", here, "list the points along the target");
  if (std::all_of(out.begin(), out.end(), [&](const auto& p) { return p == out.front(); })) {
    return wrong_case("the target has no length", here, "give points at different places");
  }
  return std::nullopt;
}

/// A yaw in degrees, or an object of yaw_degrees and pitch_degrees.
CaseProblem read_case_view(const json::Json& object, const std::string& pointer, std::optional<CaseView>& out) {
  const json::Json* value = json::find(object, "view");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "view");
  CaseView view;
  if (value->is_object()) {
    std::optional<double> yaw;
    std::optional<double> pitch;
    if (auto problem = read_number(*value, "yaw_degrees", here, yaw)) return problem;
    if (auto problem = read_number(*value, "pitch_degrees", here, pitch)) return problem;
    view = {yaw.value_or(0), pitch.value_or(0)};
  } else if (const auto yaw = json::number(*value)) {
    view.yaw_degrees = *yaw;
  } else {
    return wrong_case("a view was expected", here, "give its yaw in degrees, or {\"yaw_degrees\", \"pitch_degrees\"}");
  }
  if (!(std::abs(view.yaw_degrees) <= 360.0 && std::abs(view.pitch_degrees) <= 90.0))
    return wrong_case("a view that cannot be", here, "give a yaw of -360 to 360 and a pitch of -90 to 90 degrees");
  out = view;
  return std::nullopt;
}

CaseProblem read_references(const json::Json& object, const std::string& pointer, std::vector<CaseReference>& out) {
  const json::Json* list = nullptr;
  if (auto problem = read_array(object, "references", pointer, Need::required, list)) return problem;
  const std::string here = json::child(pointer, "references");
  if (list->empty()) return wrong_case("there is no reference curve", here, "give at least one curve and its target");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = json::child(here, i);
    CaseReference reference;
    if (!(*list)[i].is_object()) return wrong_case("an object was expected", place);
    if (auto problem = read_text((*list)[i], "curve", place, Need::optional, reference.curve)) return problem;
    if (auto problem = read_vertices((*list)[i], place, reference.vertices)) return problem;
    if (auto problem = read_target((*list)[i], place, reference.target)) return problem;
    if (auto problem = read_case_view((*list)[i], place, reference.view)) return problem;
    out.push_back(std::move(reference));
  }
  return std::nullopt;
}

CaseProblem read_constraints(const json::Json& object, const std::string& pointer, std::vector<CaseConstraint>& out) {
  const json::Json* list = nullptr;
  if (auto problem = read_array(object, "constraints", pointer, Need::optional, list)) return problem;
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const std::string place = json::child(json::child(pointer, "constraints"), i);
    CaseConstraint constraint;
    if (!(*list)[i].is_object()) return wrong_case("an object was expected", place);
    if (auto problem = read_text((*list)[i], "curve", place, Need::optional, constraint.curve)) return problem;
    if (auto problem = read_vertices((*list)[i], place, constraint.vertices)) return problem;
    out.push_back(std::move(constraint));
  }
  return std::nullopt;
}

CaseProblem read_case_names(const json::Json& object, const char* member, const std::string& pointer,
                            std::vector<std::string>& out) {
  const json::Json* list = nullptr;
  if (auto problem = read_array(object, member, pointer, Need::optional, list)) return problem;
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if (!(*list)[i].is_string())
      return wrong_case("a parameter name was expected", json::child(json::child(pointer, member), i));
    out.push_back((*list)[i].get<std::string>());
  }
  return std::nullopt;
}

CaseProblem read_weights(const json::Json& object, const std::string& pointer,
                         std::vector<std::pair<std::string, double>>& out) {
  const json::Json* weights = json::find(object, "weights");
  if (weights == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "weights");
  if (!weights->is_object()) return wrong_case("an object of parameter values was expected", here);
  for (const auto& [name, value] : weights->items()) {
    const auto weight = json::number(value);
    if (!weight) return wrong_case("a number was expected", json::child(here, name));
    out.emplace_back(name, *weight);
  }
  return std::nullopt;
}

CaseProblem read_case(const json::Json& object, const std::string& pointer, PoseCase& out) {
  if (!object.is_object()) return wrong_case("an object was expected", pointer);
  if (auto problem = read_text(object, "name", pointer, Need::required, out.name)) return problem;
  if (auto problem = read_case_names(object, "free", pointer, out.free)) return problem;
  if (auto problem = read_case_names(object, "locked", pointer, out.locked)) return problem;
  if (auto problem = read_references(object, pointer, out.references)) return problem;
  if (auto problem = read_constraints(object, pointer, out.constraints)) return problem;
  if (auto problem = read_weights(object, pointer, out.weights)) return problem;
  if (auto problem = read_number(object, "rest_energy", pointer, out.rest_energy)) return problem;
  if (auto problem = read_number(object, "optimum_energy", pointer, out.optimum_energy)) return problem;
  std::optional<double> yaw;
  if (auto problem = read_number(object, "view_yaw_degrees", pointer, yaw)) return problem;
  if (std::abs(yaw.value_or(0)) > 360) {
    return wrong_case("the angle is out of range", json::child(pointer, "view_yaw_degrees"), "use -360 to 360 degrees");
  }
  out.view_yaw_degrees = yaw.value_or(0);
  return std::nullopt;
}

CaseProblem check_vertices(const std::vector<std::uint32_t>& vertices, const std::string& pointer,
                           std::span<const geometry::ModelPoint> positions) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] < positions.size()) continue;
    return wrong_case("vertex " + std::to_string(vertices[i]) + " does not exist; the model has " +
                          std::to_string(positions.size()) + " vertices",
                      json::child(pointer, i), "check that the cases belong to this model");
  }
  const auto at_start = [&](std::uint32_t v) { return positions[v] == positions[vertices.front()]; };
  if (std::all_of(vertices.begin(), vertices.end(), at_start)) {
    return wrong_case("the curve has no length", pointer, "list vertices at different places");
  }
  return std::nullopt;
}

/// `rest`: where the rig has its vertices. A mesh that several nodes share lies in one place before they carry it.
CaseProblem check_case(const PoseCase& pose_case, const std::string& pointer, const document::Model& model,
                       std::span<const geometry::ModelPoint> rest, TargetForm form) {
  const auto parameters = model.rig->parameters();
  for (const auto& [member, names] : {std::pair{"free", &pose_case.free}, std::pair{"locked", &pose_case.locked}}) {
    for (std::size_t i = 0; i < names->size(); ++i) {
      if (rig::find_parameter(parameters, (*names)[i])) continue;
      return wrong_case("the model has no parameter \"" + (*names)[i] + "\"",
                        json::child(json::child(pointer, member), i), "`penpose info` lists the parameters of a model");
    }
  }
  for (const auto& [name, value] : pose_case.weights) {
    if (rig::find_parameter(parameters, name)) continue;
    return wrong_case("the model has no parameter \"" + name + "\"", json::child(json::child(pointer, "weights"), name),
                      "`penpose info` lists the parameters of a model");
  }
  for (std::size_t i = 0; i < pose_case.references.size(); ++i) {
    const CaseReference& reference = pose_case.references[i];
    const std::string here = json::child(json::child(pointer, "references"), i);
    if (auto problem = check_vertices(reference.vertices, json::child(here, "vertices"), rest)) return problem;
    if (form == TargetForm::points && reference.target.size() != reference.vertices.size()) {
      return wrong_case("the target has " + std::to_string(reference.target.size()) + " points for " +
                            std::to_string(reference.vertices.size()) + " vertices",
                        json::child(here, "target"), "give one point a vertex, or use the drawn form");
    }
  }
  for (std::size_t i = 0; i < pose_case.constraints.size(); ++i) {
    const std::string here = json::child(json::child(json::child(pointer, "constraints"), i), "vertices");
    if (auto problem = check_vertices(pose_case.constraints[i].vertices, here, rest)) return problem;
  }
  return std::nullopt;
}

}  // namespace

base::Result<CaseFile> read_cases(base::Bytes bytes) {
  const auto json = json::parse_json(bytes);
  if (!json) return json.error();
  if (!json->is_object()) return wrong_case("an object was expected", "/");
  CaseFile file;
  if (auto problem = read_text(*json, "mesh", "", Need::optional, file.mesh)) return *problem;
  const json::Json* list = nullptr;
  if (auto problem = read_array(*json, "cases", "", Need::required, list)) return *problem;
  if (list->empty()) return wrong_case("there is no case", "/cases");
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string pointer = json::child("/cases", i);
    PoseCase pose_case;
    if (auto problem = read_case((*list)[i], pointer, pose_case)) return *problem;
    if (!names.insert(pose_case.name).second) {
      return wrong_case("two cases have the name \"" + pose_case.name + "\"", json::child(pointer, "name"),
                        "rename one of them");
    }
    file.cases.push_back(std::move(pose_case));
  }
  return file;
}

base::Status check_cases(const CaseFile& file, const document::Model& model, TargetForm form) {
  std::vector<geometry::ModelPoint> rest(model.rig->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  for (std::size_t i = 0; i < file.cases.size(); ++i) {
    if (auto problem = check_case(file.cases[i], json::child("/cases", i), model, rest, form)) return *problem;
  }
  return base::Done{};
}

}  // namespace penpose::io
