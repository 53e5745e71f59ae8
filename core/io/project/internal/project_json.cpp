#include "core/io/project/internal/project_json.h"

#include <algorithm>
#include <cmath>

#include "core/document/commands/apply.h"
#include "core/document/commands/command_text.h"

namespace penpose::io {
namespace {

using document::Document;
using document::PoseCurve;
using document::PoseCurveRole;
using Problem = std::optional<base::Error>;

constexpr std::size_t k_most_curves = 10000;
constexpr double k_largest_number = 1e15;

base::Error wrong(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer),
          "open an earlier copy of the project, or remove this part of its extras"};
}

/// A row of exactly `count` moderate numbers.
Problem read_row(const json::Json& value, const std::string& pointer, std::size_t count, std::vector<double>& out) {
  if (!value.is_array() || value.size() != count) {
    return wrong("a list of " + std::to_string(count) + " numbers was expected", pointer);
  }
  out.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = json::number(value[i]);
    if (!n || !(std::abs(*n) <= k_largest_number)) return wrong("a number was expected", json::child(pointer, i));
    out.push_back(*n);
  }
  return std::nullopt;
}

/// Calls `take(row)` for every row of a member; a member that is missing has none.
template <typename Take>
Problem read_rows(const json::Json& object, const char* name, const std::string& pointer, std::size_t width,
                  std::size_t most, Take take) {
  const json::Json* rows = json::find(object, name);
  if (rows == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, name);
  if (!rows->is_array() || rows->size() > most) return wrong("a list was expected", here);
  std::vector<double> row;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (auto problem = read_row((*rows)[i], json::child(here, i), width, row)) return problem;
    if (auto problem = take(row, json::child(here, i))) return problem;
  }
  return std::nullopt;
}

Problem read_view(const json::Json& object, const std::string& pointer, document::View& out) {
  const json::Json* value = json::find(object, "view");
  const std::string here = json::child(pointer, "view");
  if (value == nullptr || !value->is_string()) return wrong("a view was expected", here);
  const auto view = document::parse_view(value->get<std::string>());
  if (!view || !geometry::Camera::make(view->camera, view->viewport)) return wrong("a view was expected", here);
  out = *view;
  return std::nullopt;
}

Problem read_target(const json::Json& value, const std::string& pointer, std::size_t points,
                    document::DrawnTarget& out) {
  if (auto problem = read_view(value, pointer, out.view)) return problem;
  const auto line = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    out.line.push_back({row[0], row[1]});
    if (!(row[2] >= 0 && row[2] <= 1)) return wrong("a pressure from 0 to 1 was expected", at);
    out.pressure.push_back(row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "line", pointer, 3, articulation::k_most_points, line)) return problem;
  const auto point = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    if (row[3] < 0) return wrong("a weight is negative", at);
    out.points.emplace_back(row[0], row[1], row[2]);
    out.weights.push_back(row[3]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "points", pointer, 4, articulation::k_most_points, point)) return problem;
  if (out.points.size() != points || out.line.size() == 1) {
    return wrong("a target with one point for each of its reference was expected", pointer);
  }
  const bool pulls = std::any_of(out.weights.begin(), out.weights.end(), [](double w) { return w > 0; });
  if (!pulls) return wrong("weights that are not all zero were expected", pointer);
  return std::nullopt;
}

Problem read_curve(const json::Json& value, const std::string& pointer, std::size_t triangles, PoseCurve& out) {
  const json::Json* id = json::find(value, "id");
  const auto number_of = id == nullptr ? std::nullopt : json::whole_number(*id, 1, 0xffffffffLL);
  if (!number_of) return wrong("a curve's number was expected", json::child(pointer, "id"));
  out.id = document::CurveId{static_cast<std::uint32_t>(*number_of)};
  const json::Json* role = json::find(value, "role");
  if (role == nullptr || (*role != "reference" && *role != "constraint")) {
    return wrong("\"reference\" or \"constraint\" was expected", json::child(pointer, "role"));
  }
  out.role = *role == "reference" ? PoseCurveRole::reference : PoseCurveRole::constraint;
  const auto point = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    const bool on_mesh = row[0] >= 0 && row[0] < static_cast<double>(triangles) && row[0] == std::floor(row[0]);
    const double least = std::min({row[1], row[2], row[3]});
    if (!on_mesh || !(least >= -1e-6) || !(std::abs(row[1] + row[2] + row[3] - 1.0) < 1e-6)) {
      return wrong("the point is not on the mesh", at);
    }
    out.points.push_back({static_cast<std::uint32_t>(row[0]), {row[1], row[2], row[3]}});
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "points", pointer, 4, articulation::k_most_points, point)) return problem;
  const auto kept = [&](const std::vector<double>& row, const std::string&) -> Problem {
    out.kept.emplace_back(row[0], row[1], row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "kept", pointer, 3, articulation::k_most_points, kept)) return problem;
  const auto aside = [&](const std::vector<double>& row, const std::string&) -> Problem {
    out.aside.emplace_back(row[0], row[1], row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "aside", pointer, 3, articulation::k_most_points, aside)) return problem;
  if (!out.aside.empty() && out.aside.size() != out.points.size())
    return wrong("as many vectors as points were expected", json::child(pointer, "aside"));
  const bool fits = out.kept.size() == (out.role == PoseCurveRole::constraint ? out.points.size() : 0);
  if (out.points.empty() || !fits) return wrong("the curve's lists do not fit each other", pointer);
  if (const json::Json* target = json::find(value, "target"); target != nullptr) {
    if (out.role == PoseCurveRole::constraint)
      return wrong("a constraint has no target", json::child(pointer, "target"));
    out.target.emplace();
    return read_target(*target, json::child(pointer, "target"), out.points.size(), *out.target);
  }
  return std::nullopt;
}

Problem read_curves(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* last = json::find(project, "last_curve");
  if (last != nullptr) {
    const auto n = json::whole_number(*last, 0, 0xffffffffLL);
    if (!n) return wrong("a curve's number was expected", json::child(pointer, "last_curve"));
    out.last_curve = static_cast<std::uint32_t>(*n);
  }
  const json::Json* curves = json::find(project, "curves");
  if (curves == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "curves");
  if (!curves->is_array() || curves->size() > k_most_curves) return wrong("a list of curves was expected", here);
  for (std::size_t i = 0; i < curves->size(); ++i) {
    if (!(*curves)[i].is_object()) return wrong("an object was expected", json::child(here, i));
    PoseCurve curve;
    if (auto problem = read_curve((*curves)[i], json::child(here, i), out.model->mesh->triangle_count(), curve)) {
      return problem;
    }
    if (curve.id.value > out.last_curve || find_curve(out, curve.id) != nullptr) {
      return wrong("a curve's number is used twice or above the last one", json::child(json::child(here, i), "id"));
    }
    out.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  }
  return std::nullopt;
}

Problem read_timeline(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* value = json::find(project, "timeline");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "timeline");
  if (!value->is_object()) return wrong("an object was expected", here);
  document::Timeline timeline;
  const json::Json* interpolation = json::find(*value, "interpolation");
  if (interpolation == nullptr || (*interpolation != "linear" && *interpolation != "smooth")) {
    return wrong("\"linear\" or \"smooth\" was expected", json::child(here, "interpolation"));
  }
  timeline.interpolation =
      *interpolation == "linear" ? document::KeyInterpolation::linear : document::KeyInterpolation::smooth;
  const json::Json* keys = json::find(*value, "keys");
  const std::string list = json::child(here, "keys");
  if (keys == nullptr || !keys->is_array()) return wrong("a list of keys was expected", list);
  const auto parameters = out.model->rig->parameters();
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const std::string at = json::child(list, i);
    document::PoseKey key;
    const json::Json* time = json::find((*keys)[i], "time_s");
    const auto seconds = time == nullptr ? std::nullopt : json::number(*time);
    const double before = timeline.keys.empty() ? -1.0 : timeline.keys.back().time_s;
    if (!seconds || !(*seconds >= 0 && *seconds > before && *seconds <= document::k_latest_key_s)) {
      return wrong("moments were expected that ascend from 0", json::child(at, "time_s"));
    }
    key.time_s = *seconds;
    const json::Json* pose = json::find((*keys)[i], "pose");
    if (pose == nullptr) return wrong("a pose was expected", json::child(at, "pose"));
    rig::Pose values;
    if (auto problem = read_row(*pose, json::child(at, "pose"), parameters.size(), values)) return problem;
    if (const json::Json* name = json::find((*keys)[i], "name"); name != nullptr) {
      if (!name->is_string()) return wrong("a name was expected", json::child(at, "name"));
      key.name = name->get<std::string>();
    }
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      values[p] = std::clamp(values[p], parameters[p].minimum, parameters[p].maximum);
    }
    key.pose = std::move(values);
    timeline.keys.push_back(std::move(key));
  }
  out.timeline = std::make_shared<const document::Timeline>(std::move(timeline));
  return std::nullopt;
}

Problem read_locks(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* locked = json::find(project, "locked");
  if (locked != nullptr) {
    if (!locked->is_array()) return wrong("a list of names was expected", json::child(pointer, "locked"));
    for (std::size_t i = 0; i < locked->size(); ++i) {
      const json::Json& name = (*locked)[i];
      if (!name.is_string()) return wrong("a name was expected", json::child(json::child(pointer, "locked"), i));
      // A parameter that is gone needs no lock.
      if (rig::find_parameter(out.model->rig->parameters(), name.get<std::string>())) {
        out.locked.push_back(name.get<std::string>());
      }
    }
    std::stable_sort(out.locked.begin(), out.locked.end());
    out.locked.erase(std::unique(out.locked.begin(), out.locked.end()), out.locked.end());
  }
  if (const json::Json* on = json::find(project, "pressure_weighting"); on != nullptr) {
    if (!on->is_boolean()) return wrong("true or false was expected", json::child(pointer, "pressure_weighting"));
    out.pressure_weighting = on->get<bool>();
  }
  if (const json::Json* hand = json::find(project, "hand"); hand != nullptr) {
    const auto unsteadiness = json::number(*hand);
    if (!unsteadiness || !(*unsteadiness >= document::k_steadiest_hand && *unsteadiness <= document::k_shakiest_hand))
      return wrong("the unsteadiness of a hand was expected, 0.25 to 4", json::child(pointer, "hand"));
    out.hand = *unsteadiness;
  }
  if (const json::Json* time = json::find(project, "time_s"); time != nullptr) {
    const auto seconds = json::number(*time);
    if (!seconds || !(*seconds >= 0 && *seconds <= document::k_latest_key_s)) {
      return wrong("a moment was expected", json::child(pointer, "time_s"));
    }
    out.time_s = *seconds;
  }
  return std::nullopt;
}

Problem read_names(const json::Json& object, const char* name, const std::string& pointer,
                   std::vector<std::string>& out) {
  const json::Json* names = json::find(object, name);
  const std::string here = json::child(pointer, name);
  if (names == nullptr || !names->is_array()) return wrong("a list of names was expected", here);
  for (std::size_t i = 0; i < names->size(); ++i) {
    if (!(*names)[i].is_string()) return wrong("a name was expected", json::child(here, i));
    out.push_back((*names)[i].get<std::string>());
  }
  return std::nullopt;
}

Problem read_taken(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* value = json::find(project, "taken");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "taken");
  if (!value->is_array() || value->size() > document::k_most_taken) return wrong("a list was expected", here);
  std::vector<document::TakenReading> taken;
  for (std::size_t i = 0; i < value->size(); ++i) {
    document::TakenReading& one = taken.emplace_back();
    const std::string at = json::child(here, i);
    if (auto problem = read_names((*value)[i], "taken", at, one.taken)) return problem;
    if (auto problem = read_names((*value)[i], "instead_of", at, one.instead_of)) return problem;
  }
  // A control that is gone tells nothing.
  out.taken = document::taken_of_rig(std::move(taken), out.model->rig->parameters());
  return std::nullopt;
}

Problem read_views(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* views = json::find(project, "views");
  if (views == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "views");
  if (!views->is_array() || views->size() > k_most_curves) return wrong("a list of views was expected", here);
  for (std::size_t i = 0; i < views->size(); ++i) {
    const std::string at = json::child(here, i);
    document::NamedView named;
    const json::Json* name = json::find((*views)[i], "name");
    if (name == nullptr || !name->is_string()) return wrong("a name was expected", json::child(at, "name"));
    named.name = name->get<std::string>();
    const bool again =
        std::any_of(out.views.begin(), out.views.end(), [&](const auto& one) { return one->name == named.name; });
    if (named.name.empty() || again) return wrong("a name of its own was expected", json::child(at, "name"));
    if (auto problem = read_view((*views)[i], at, named.view)) return problem;
    out.views.push_back(std::make_shared<const document::NamedView>(std::move(named)));
  }
  return std::nullopt;
}

/// A deformer whose steps are not all drawn is kept as the commands that drew them.
Problem read_pending(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* pending = json::find(project, "pending");
  if (pending == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "pending");
  if (!pending->is_array() || pending->size() > 8) return wrong("a list of commands was expected", here);
  document::ApplyWorkspace work;
  for (std::size_t i = 0; i < pending->size(); ++i) {
    const json::Json& text = (*pending)[i];
    const auto command = document::parse_command(text.is_string() ? text.get<std::string>() : std::string());
    if (!command) return wrong(command.error().what, json::child(here, i));
    const bool begins = std::holds_alternative<document::BeginDeformer>(*command) ||
                        std::holds_alternative<document::BeginCorrection>(*command);
    const auto* draws = std::get_if<document::SketchCurve>(&*command);
    const bool takes = std::holds_alternative<document::TakeRegion>(*command);
    const bool fits = i == 0 ? begins : takes || (draws != nullptr && draws->role != articulation::CurveRole::target);
    if (!fits) return wrong("the beginning of a deformer and its first curves were expected", json::child(here, i));
    auto changed = document::apply(out, *command, work);
    if (!changed) return wrong(changed.error().what, json::child(here, i));
    out = std::move(changed).value();
  }
  return std::nullopt;
}

json::Json row(const geometry::ModelPoint& p) { return {p.x, p.y, p.z}; }

json::Json to_json(const PoseCurve& curve) {
  json::Json points = json::Json::array();
  for (const mesh::MeshPoint& p : curve.points) {
    points.push_back({p.triangle, p.barycentric[0], p.barycentric[1], p.barycentric[2]});
  }
  const bool constraint = curve.role == PoseCurveRole::constraint;
  json::Json out = {
      {"id", curve.id.value}, {"role", constraint ? "constraint" : "reference"}, {"points", std::move(points)}};
  if (constraint) {
    json::Json kept = json::Json::array();
    for (const auto& p : curve.kept) kept.push_back(row(p));
    out["kept"] = std::move(kept);
  }
  if (!curve.aside.empty()) {
    json::Json aside = json::Json::array();
    for (const auto& v : curve.aside) aside.push_back(row(v));
    out["aside"] = std::move(aside);
  }
  if (!curve.target) return out;
  const document::DrawnTarget& target = *curve.target;
  json::Json line = json::Json::array();
  for (std::size_t i = 0; i < target.line.size(); ++i) {
    line.push_back({target.line[i].x, target.line[i].y, target.pressure[i]});
  }
  json::Json lifted = json::Json::array();
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const geometry::ModelPoint& p = target.points[i];
    lifted.push_back({p.x, p.y, p.z, target.weights[i]});
  }
  out["target"] = {{"view", document::to_text(target.view)}, {"line", std::move(line)}, {"points", std::move(lifted)}};
  return out;
}

json::Json to_json(const std::vector<document::TakenReading>& taken) {
  json::Json out = json::Json::array();
  for (const document::TakenReading& one : taken) out.push_back({{"taken", one.taken}, {"instead_of", one.instead_of}});
  return out;
}

json::Json pending_commands(const document::PendingSketch& pending) {
  const articulation::Sketch& sketch = pending.sketch;
  using articulation::CurveRole;
  json::Json commands = json::Json::array();
  const auto add = [&](const document::Command& command) { commands.push_back(document::to_text(command)); };
  if (pending.drivers.empty()) {
    add(document::BeginDeformer{sketch.name, sketch.mode, sketch.surface, sketch.minimum, sketch.maximum});
  } else {
    document::BeginCorrection begin{sketch.name, {}, sketch.mode};
    for (const articulation::Driver& one : pending.drivers) begin.drivers.push_back({one.control, one.value});
    add(begin);
  }
  const document::View view{sketch.camera, sketch.viewport};
  if (sketch.reach != articulation::Reach::through) add(document::TakeRegion{sketch.reach, {}});
  if (!sketch.general.empty()) add(document::SketchCurve{CurveRole::general, view, sketch.general});
  if (sketch.piece != 0) add(document::TakeRegion{{}, sketch.piece});
  if (!sketch.specific.empty()) add(document::SketchCurve{CurveRole::specific, view, sketch.specific});
  if (!sketch.reference.empty()) {
    const document::View own{sketch.reference_camera.value_or(sketch.camera), sketch.viewport};
    add(document::SketchCurve{CurveRole::reference, own, sketch.reference});
  }
  return commands;
}

}  // namespace

json::Json project_to_json(const Document& document) {
  json::Json project = {{"last_curve", document.last_curve}, {"time_s", document.time_s}};
  project["pressure_weighting"] = document.pressure_weighting;
  if (document.hand != 1.0) project["hand"] = document.hand;
  project["locked"] = document.locked;
  if (document.taken) project["taken"] = to_json(*document.taken);
  json::Json curves = json::Json::array();
  for (const auto& curve : document.curves) curves.push_back(to_json(*curve));
  project["curves"] = std::move(curves);
  json::Json keys = json::Json::array();
  for (const document::PoseKey& key : document.timeline->keys) {
    json::Json one = {{"time_s", key.time_s}, {"pose", static_cast<const rig::Pose&>(key.pose)}};
    if (!key.name.empty()) one["name"] = key.name;
    keys.push_back(std::move(one));
  }
  const bool linear = document.timeline->interpolation == document::KeyInterpolation::linear;
  project["timeline"] = {{"interpolation", linear ? "linear" : "smooth"}, {"keys", std::move(keys)}};
  json::Json views = json::Json::array();
  for (const auto& named : document.views) {
    views.push_back({{"name", named->name}, {"view", document::to_text(named->view)}});
  }
  project["views"] = std::move(views);
  if (document.pending) project["pending"] = pending_commands(*document.pending);
  return project;
}

base::Result<Document> read_project(const json::Json& project, const std::string& pointer, document::Model model) {
  if (!project.is_object()) return wrong("an object was expected", pointer);
  Document out = document::make_document(std::move(model));
  for (const auto read : {read_curves, read_timeline, read_locks, read_taken, read_views, read_pending}) {
    if (auto problem = read(project, pointer, out)) return *std::move(problem);
  }
  return out;
}

}  // namespace penpose::io
