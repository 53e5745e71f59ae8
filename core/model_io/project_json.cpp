#include "core/model_io/project_json.h"

#include <algorithm>
#include <cmath>

#include "core/document/apply.h"
#include "core/document/command_text.h"

namespace penpose::model_io {
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
Problem read_row(const Json& value, const std::string& pointer, std::size_t count, std::vector<double>& out) {
  if (!value.is_array() || value.size() != count) {
    return wrong("a list of " + std::to_string(count) + " numbers was expected", pointer);
  }
  out.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = number(value[i]);
    if (!n || !(std::abs(*n) <= k_largest_number)) return wrong("a number was expected", child(pointer, i));
    out.push_back(*n);
  }
  return std::nullopt;
}

/// Calls `take(row)` for every row of a member; a member that is missing has none.
template <typename Take>
Problem read_rows(const Json& object, const char* name, const std::string& pointer, std::size_t width, std::size_t most,
                  Take take) {
  const Json* rows = find(object, name);
  if (rows == nullptr) return std::nullopt;
  const std::string here = child(pointer, name);
  if (!rows->is_array() || rows->size() > most) return wrong("a list was expected", here);
  std::vector<double> row;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (auto problem = read_row((*rows)[i], child(here, i), width, row)) return problem;
    if (auto problem = take(row, child(here, i))) return problem;
  }
  return std::nullopt;
}

Problem read_view(const Json& object, const std::string& pointer, document::View& out) {
  const Json* value = find(object, "view");
  const std::string here = child(pointer, "view");
  if (value == nullptr || !value->is_string()) return wrong("a view was expected", here);
  const auto view = document::parse_view(value->get<std::string>());
  if (!view || !geometry::Camera::make(view->camera, view->viewport)) return wrong("a view was expected", here);
  out = *view;
  return std::nullopt;
}

Problem read_target(const Json& value, const std::string& pointer, std::size_t points, document::DrawnTarget& out) {
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

Problem read_curve(const Json& value, const std::string& pointer, std::size_t triangles, PoseCurve& out) {
  const Json* id = find(value, "id");
  const auto number_of = id == nullptr ? std::nullopt : whole_number(*id, 1, 0xffffffffLL);
  if (!number_of) return wrong("a curve's number was expected", child(pointer, "id"));
  out.id = document::CurveId{static_cast<std::uint32_t>(*number_of)};
  const Json* role = find(value, "role");
  if (role == nullptr || (*role != "reference" && *role != "constraint")) {
    return wrong("\"reference\" or \"constraint\" was expected", child(pointer, "role"));
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
    return wrong("as many vectors as points were expected", child(pointer, "aside"));
  const bool fits = out.kept.size() == (out.role == PoseCurveRole::constraint ? out.points.size() : 0);
  if (out.points.empty() || !fits) return wrong("the curve's lists do not fit each other", pointer);
  if (const Json* target = find(value, "target"); target != nullptr) {
    if (out.role == PoseCurveRole::constraint) return wrong("a constraint has no target", child(pointer, "target"));
    out.target.emplace();
    return read_target(*target, child(pointer, "target"), out.points.size(), *out.target);
  }
  return std::nullopt;
}

Problem read_curves(const Json& project, const std::string& pointer, Document& out) {
  const Json* last = find(project, "last_curve");
  if (last != nullptr) {
    const auto n = whole_number(*last, 0, 0xffffffffLL);
    if (!n) return wrong("a curve's number was expected", child(pointer, "last_curve"));
    out.last_curve = static_cast<std::uint32_t>(*n);
  }
  const Json* curves = find(project, "curves");
  if (curves == nullptr) return std::nullopt;
  const std::string here = child(pointer, "curves");
  if (!curves->is_array() || curves->size() > k_most_curves) return wrong("a list of curves was expected", here);
  for (std::size_t i = 0; i < curves->size(); ++i) {
    if (!(*curves)[i].is_object()) return wrong("an object was expected", child(here, i));
    PoseCurve curve;
    if (auto problem = read_curve((*curves)[i], child(here, i), out.model->mesh->triangle_count(), curve)) {
      return problem;
    }
    if (curve.id.value > out.last_curve || find_curve(out, curve.id) != nullptr) {
      return wrong("a curve's number is used twice or above the last one", child(child(here, i), "id"));
    }
    out.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  }
  return std::nullopt;
}

Problem read_timeline(const Json& project, const std::string& pointer, Document& out) {
  const Json* value = find(project, "timeline");
  if (value == nullptr) return std::nullopt;
  const std::string here = child(pointer, "timeline");
  if (!value->is_object()) return wrong("an object was expected", here);
  document::Timeline timeline;
  const Json* interpolation = find(*value, "interpolation");
  if (interpolation == nullptr || (*interpolation != "linear" && *interpolation != "smooth")) {
    return wrong("\"linear\" or \"smooth\" was expected", child(here, "interpolation"));
  }
  timeline.interpolation =
      *interpolation == "linear" ? document::KeyInterpolation::linear : document::KeyInterpolation::smooth;
  const Json* keys = find(*value, "keys");
  const std::string list = child(here, "keys");
  if (keys == nullptr || !keys->is_array()) return wrong("a list of keys was expected", list);
  const auto parameters = out.model->rig->parameters();
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const std::string at = child(list, i);
    document::PoseKey key;
    const Json* time = find((*keys)[i], "time_s");
    const auto seconds = time == nullptr ? std::nullopt : number(*time);
    const double before = timeline.keys.empty() ? -1.0 : timeline.keys.back().time_s;
    if (!seconds || !(*seconds >= 0 && *seconds > before && *seconds <= document::k_latest_key_s)) {
      return wrong("moments were expected that ascend from 0", child(at, "time_s"));
    }
    key.time_s = *seconds;
    const Json* pose = find((*keys)[i], "pose");
    if (pose == nullptr) return wrong("a pose was expected", child(at, "pose"));
    rig::Pose values;
    if (auto problem = read_row(*pose, child(at, "pose"), parameters.size(), values)) return problem;
    if (const Json* name = find((*keys)[i], "name"); name != nullptr) {
      if (!name->is_string()) return wrong("a name was expected", child(at, "name"));
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

Problem read_locks(const Json& project, const std::string& pointer, Document& out) {
  const Json* locked = find(project, "locked");
  if (locked != nullptr) {
    if (!locked->is_array()) return wrong("a list of names was expected", child(pointer, "locked"));
    for (std::size_t i = 0; i < locked->size(); ++i) {
      const Json& name = (*locked)[i];
      if (!name.is_string()) return wrong("a name was expected", child(child(pointer, "locked"), i));
      // A parameter that is gone needs no lock.
      if (rig::find_parameter(out.model->rig->parameters(), name.get<std::string>())) {
        out.locked.push_back(name.get<std::string>());
      }
    }
    std::stable_sort(out.locked.begin(), out.locked.end());
    out.locked.erase(std::unique(out.locked.begin(), out.locked.end()), out.locked.end());
  }
  if (const Json* on = find(project, "pressure_weighting"); on != nullptr) {
    if (!on->is_boolean()) return wrong("true or false was expected", child(pointer, "pressure_weighting"));
    out.pressure_weighting = on->get<bool>();
  }
  if (const Json* hand = find(project, "hand"); hand != nullptr) {
    const auto unsteadiness = number(*hand);
    if (!unsteadiness || !(*unsteadiness >= document::k_steadiest_hand && *unsteadiness <= document::k_shakiest_hand))
      return wrong("the unsteadiness of a hand was expected, 0.25 to 4", child(pointer, "hand"));
    out.hand = *unsteadiness;
  }
  if (const Json* time = find(project, "time_s"); time != nullptr) {
    const auto seconds = number(*time);
    if (!seconds || !(*seconds >= 0 && *seconds <= document::k_latest_key_s)) {
      return wrong("a moment was expected", child(pointer, "time_s"));
    }
    out.time_s = *seconds;
  }
  return std::nullopt;
}

Problem read_views(const Json& project, const std::string& pointer, Document& out) {
  const Json* views = find(project, "views");
  if (views == nullptr) return std::nullopt;
  const std::string here = child(pointer, "views");
  if (!views->is_array() || views->size() > k_most_curves) return wrong("a list of views was expected", here);
  for (std::size_t i = 0; i < views->size(); ++i) {
    const std::string at = child(here, i);
    document::NamedView named;
    const Json* name = find((*views)[i], "name");
    if (name == nullptr || !name->is_string()) return wrong("a name was expected", child(at, "name"));
    named.name = name->get<std::string>();
    const bool again =
        std::any_of(out.views.begin(), out.views.end(), [&](const auto& one) { return one->name == named.name; });
    if (named.name.empty() || again) return wrong("a name of its own was expected", child(at, "name"));
    if (auto problem = read_view((*views)[i], at, named.view)) return problem;
    out.views.push_back(std::make_shared<const document::NamedView>(std::move(named)));
  }
  return std::nullopt;
}

/// A deformer whose steps are not all drawn is kept as the commands that drew them.
Problem read_pending(const Json& project, const std::string& pointer, Document& out) {
  const Json* pending = find(project, "pending");
  if (pending == nullptr) return std::nullopt;
  const std::string here = child(pointer, "pending");
  if (!pending->is_array() || pending->size() > 8) return wrong("a list of commands was expected", here);
  document::ApplyWorkspace work;
  for (std::size_t i = 0; i < pending->size(); ++i) {
    const Json& text = (*pending)[i];
    const auto command = document::parse_command(text.is_string() ? text.get<std::string>() : std::string());
    if (!command) return wrong(command.error().what, child(here, i));
    const bool begins = std::holds_alternative<document::BeginDeformer>(*command) ||
                        std::holds_alternative<document::BeginCorrection>(*command);
    const auto* draws = std::get_if<document::SketchCurve>(&*command);
    const bool takes = std::holds_alternative<document::TakeRegion>(*command);
    const bool fits = i == 0 ? begins : takes || (draws != nullptr && draws->role != articulation::CurveRole::target);
    if (!fits) return wrong("the beginning of a deformer and its first curves were expected", child(here, i));
    auto changed = document::apply(out, *command, work);
    if (!changed) return wrong(changed.error().what, child(here, i));
    out = std::move(changed).value();
  }
  return std::nullopt;
}

Json row(const geometry::ModelPoint& p) { return {p.x, p.y, p.z}; }

Json to_json(const PoseCurve& curve) {
  Json points = Json::array();
  for (const mesh::MeshPoint& p : curve.points) {
    points.push_back({p.triangle, p.barycentric[0], p.barycentric[1], p.barycentric[2]});
  }
  const bool constraint = curve.role == PoseCurveRole::constraint;
  Json out = {{"id", curve.id.value}, {"role", constraint ? "constraint" : "reference"}, {"points", std::move(points)}};
  if (constraint) {
    Json kept = Json::array();
    for (const auto& p : curve.kept) kept.push_back(row(p));
    out["kept"] = std::move(kept);
  }
  if (!curve.aside.empty()) {
    Json aside = Json::array();
    for (const auto& v : curve.aside) aside.push_back(row(v));
    out["aside"] = std::move(aside);
  }
  if (!curve.target) return out;
  const document::DrawnTarget& target = *curve.target;
  Json line = Json::array();
  for (std::size_t i = 0; i < target.line.size(); ++i) {
    line.push_back({target.line[i].x, target.line[i].y, target.pressure[i]});
  }
  Json lifted = Json::array();
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const geometry::ModelPoint& p = target.points[i];
    lifted.push_back({p.x, p.y, p.z, target.weights[i]});
  }
  out["target"] = {{"view", document::to_text(target.view)}, {"line", std::move(line)}, {"points", std::move(lifted)}};
  return out;
}

Json pending_commands(const document::PendingSketch& pending) {
  const articulation::Sketch& sketch = pending.sketch;
  using articulation::CurveRole;
  Json commands = Json::array();
  const auto add = [&](const document::Command& command) { commands.push_back(document::to_text(command)); };
  if (pending.drivers.empty()) {
    add(document::BeginDeformer{sketch.name, sketch.mode, sketch.surface, sketch.minimum, sketch.maximum,
                                sketch.rules});
  } else {
    document::BeginCorrection begin{sketch.name, {}, sketch.mode, sketch.rules};
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

Json project_to_json(const Document& document) {
  Json project = {{"last_curve", document.last_curve}, {"time_s", document.time_s}};
  project["pressure_weighting"] = document.pressure_weighting;
  if (document.hand != 1.0) project["hand"] = document.hand;
  project["locked"] = document.locked;
  Json curves = Json::array();
  for (const auto& curve : document.curves) curves.push_back(to_json(*curve));
  project["curves"] = std::move(curves);
  Json keys = Json::array();
  for (const document::PoseKey& key : document.timeline->keys) {
    Json one = {{"time_s", key.time_s}, {"pose", static_cast<const rig::Pose&>(key.pose)}};
    if (!key.name.empty()) one["name"] = key.name;
    keys.push_back(std::move(one));
  }
  const bool linear = document.timeline->interpolation == document::KeyInterpolation::linear;
  project["timeline"] = {{"interpolation", linear ? "linear" : "smooth"}, {"keys", std::move(keys)}};
  Json views = Json::array();
  for (const auto& named : document.views) {
    views.push_back({{"name", named->name}, {"view", document::to_text(named->view)}});
  }
  project["views"] = std::move(views);
  if (document.pending) project["pending"] = pending_commands(*document.pending);
  return project;
}

base::Result<Document> read_project(const Json& project, const std::string& pointer, document::Model model) {
  if (!project.is_object()) return wrong("an object was expected", pointer);
  Document out = document::make_document(std::move(model));
  for (const auto read : {read_curves, read_timeline, read_locks, read_views, read_pending}) {
    if (auto problem = read(project, pointer, out)) return *std::move(problem);
  }
  return out;
}

}  // namespace penpose::model_io
