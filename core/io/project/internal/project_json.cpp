#include "core/io/project/internal/project_json.h"

#include <algorithm>
#include <cmath>

#include "core/document/commands/apply.h"
#include "core/document/commands/command_text.h"
#include "core/io/project/internal/project_bookmarks.h"
#include "core/io/project/internal/project_curves.h"
#include "core/io/project/internal/project_face.h"
#include "core/io/project/internal/project_sound.h"
#include "core/io/project/internal/project_time.h"
#include "core/io/project/internal/project_values.h"
#include "core/io/project/internal/project_view.h"

namespace penpose::io {
namespace {

using document::Document;

Problem read_locks(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* locked = json::find(project, "locked");
  if (locked != nullptr) {
    if (!locked->is_array()) return project_error("a list of names was expected", json::child(pointer, "locked"));
    for (std::size_t i = 0; i < locked->size(); ++i) {
      const json::Json& name = (*locked)[i];
      if (!name.is_string())
        return project_error("a name was expected", json::child(json::child(pointer, "locked"), i));
      // A parameter that is gone needs no lock.
      if (rig::find_parameter(out.model->rig->parameters(), name.get<std::string>())) {
        out.locked.push_back(name.get<std::string>());
      }
    }
    std::stable_sort(out.locked.begin(), out.locked.end());
    out.locked.erase(std::unique(out.locked.begin(), out.locked.end()), out.locked.end());
  }
  if (const json::Json* on = json::find(project, "pressure_weighting"); on != nullptr) {
    if (!on->is_boolean())
      return project_error("true or false was expected", json::child(pointer, "pressure_weighting"));
    out.pressure_weighting = on->get<bool>();
  }
  if (const json::Json* hand = json::find(project, "hand"); hand != nullptr) {
    const auto unsteadiness = json::number(*hand);
    if (!unsteadiness || !(*unsteadiness >= document::k_steadiest_hand && *unsteadiness <= document::k_shakiest_hand))
      return project_error("the unsteadiness of a hand was expected, 0.25 to 4", json::child(pointer, "hand"));
    out.hand = *unsteadiness;
  }
  if (const json::Json* time = json::find(project, "time_s"); time != nullptr) {
    const auto seconds = json::number(*time);
    if (!seconds || !(*seconds >= 0 && *seconds <= document::k_latest_key_s)) {
      return project_error("a moment was expected", json::child(pointer, "time_s"));
    }
    out.time_s = *seconds;
  }
  return std::nullopt;
}

Problem read_names(const json::Json& object, const char* name, const std::string& pointer,
                   std::vector<std::string>& out) {
  const json::Json* names = json::find(object, name);
  const std::string here = json::child(pointer, name);
  if (names == nullptr || !names->is_array()) return project_error("a list of names was expected", here);
  for (std::size_t i = 0; i < names->size(); ++i) {
    if (!(*names)[i].is_string()) return project_error("a name was expected", json::child(here, i));
    out.push_back((*names)[i].get<std::string>());
  }
  return std::nullopt;
}

Problem read_taken(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* value = json::find(project, "taken");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "taken");
  if (!value->is_array() || value->size() > document::k_most_taken) return project_error("a list was expected", here);
  std::vector<document::TakenReading> taken;
  for (std::size_t i = 0; i < value->size(); ++i) {
    document::TakenReading& one = taken.emplace_back();
    const std::string at = json::child(here, i);
    if (auto problem = read_names((*value)[i], "taken", at, one.taken)) return problem;
    if (auto problem = read_names((*value)[i], "instead_of", at, one.instead_of)) return problem;
    // Until edition 7 nobody measured by how much.
    const json::Json* by = json::find((*value)[i], "by");
    if (by == nullptr) continue;
    if (!by->is_number() || !(std::abs(by->get<double>()) <= document::k_most_taught))
      return project_error(
          "a number up to " + std::to_string(static_cast<int>(document::k_most_taught)) + " was expected",
          json::child(at, "by"));
    one.by = by->get<double>();
  }
  // A control that is gone tells nothing.
  out.taken = document::taken_of_rig(std::move(taken), out.model->rig->parameters());
  return std::nullopt;
}

/// A deformer whose steps are not all drawn is kept as the commands that drew them.
Problem read_pending(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* pending = json::find(project, "pending");
  if (pending == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "pending");
  if (!pending->is_array() || pending->size() > 8) return project_error("a list of commands was expected", here);
  document::ApplyWorkspace work;
  for (std::size_t i = 0; i < pending->size(); ++i) {
    const json::Json& text = (*pending)[i];
    const auto command = document::parse_command(text.is_string() ? text.get<std::string>() : std::string());
    if (!command) return project_error(command.error().what, json::child(here, i));
    const bool begins = command->holds<document::BeginDeformer>() || command->holds<document::BeginCorrection>();
    const auto* draws = command->get_if<document::SketchCurve>();
    const bool takes = command->holds<document::TakeRegion>();
    const bool fits = i == 0 ? begins : takes || (draws != nullptr && draws->role != articulation::CurveRole::target);
    if (!fits)
      return project_error("the beginning of a deformer and its first curves were expected", json::child(here, i));
    auto changed = document::apply(out, *command, work);
    if (!changed) return project_error(changed.error().what, json::child(here, i));
    out = std::move(changed).value();
  }
  return std::nullopt;
}

json::Json to_json(const std::vector<document::TakenReading>& taken) {
  json::Json out = json::Json::array();
  for (const document::TakenReading& one : taken)
    out.push_back({{"taken", one.taken}, {"instead_of", one.instead_of}, {"by", one.by}});
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
  for (const auto& curve : document.curves) curves.push_back(curve_to_json(*curve));
  project["curves"] = std::move(curves);
  if (document.face) project["face"] = face_to_json(*document.face);
  if (document.neutral) project["neutral"] = face_to_json(*document.neutral);
  project["timeline"] = timeline_to_json(*document.timeline);
  if (!document.clips.empty()) project["clips"] = clips_to_json(document);
  write_project_views(document, project);
  write_project_sound(document, project);
  if (document.bookmarks) project["bookmarks"] = bookmarks_to_json(*document.bookmarks);
  if (document.pending) project["pending"] = pending_commands(*document.pending);
  return project;
}

base::Result<Document> read_project(const json::Json& project, const std::string& pointer, document::Model model) {
  if (!project.is_object()) return project_error("an object was expected", pointer);
  Document out = document::make_document(std::move(model));
  for (const auto read : {read_project_curves, read_project_face, read_timeline, read_locks, read_taken,
                          read_project_views, read_project_sound, read_project_bookmarks, read_clips, read_pending}) {
    if (auto problem = read(project, pointer, out)) return *std::move(problem);
  }
  return out;
}

}  // namespace penpose::io
