#include "core/document/commands/list/correction_commands.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/articulation/mirror.h"
#include "core/document/commands/apply_deformers.h"

namespace penpose::document {
namespace {

using articulation::Driver;

/// Nearer to rest than that a control is at rest.
constexpr double k_at_rest = 1e-9;

std::string free_correction_name(const Document& document) {
  const auto sketches = correction_sketches(*document.model);
  for (std::size_t n = 1;; ++n) {
    const std::string name = "correction " + std::to_string(n);
    bool taken = rig::find_parameter(document.model->rig->parameters(), name).has_value();
    for (const auto& one : sketches) taken = taken || one.sketch.name == name;
    if (!taken) return name;
  }
}

std::vector<Driver> posed_controls(const Document& document) {
  std::vector<Driver> posed;
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(document.pose[i] - parameters[i].rest) > k_at_rest) {
      posed.push_back({parameters[i].name, document.pose[i]});
    }
  }
  return posed;
}

/// The document with these corrections; an error of number `own` is told without its number.
Changed with_sketches(const Document& document, const std::vector<articulation::CorrectionSketch>& sketches,
                      std::size_t own) {
  auto model = with_corrections(*document.model, sketches);
  if (!model) {
    base::Error error = model.error();
    const std::string number = std::to_string(own) + "/";
    if (error.place.starts_with(number)) error.place.erase(0, number.size());
    return error;
  }
  return with_model(document, std::move(model).value());
}

std::optional<base::Error> check_free(const Document& document, const std::string& name) {
  const base::Error empty{"a correction needs a name", "to", "give one"};
  if (name.empty()) return empty;
  const bool pending = document.pending && document.pending->sketch.name == name;
  const bool control = rig::find_parameter(document.model->rig->parameters(), name).has_value();
  if (!pending && !control && !correction_number(document, name)) return std::nullopt;
  return base::Error{std::string(control ? "a control" : "a correction") + " has the name \"" + name + "\" already",
                     "to", "give it another name"};
}

}  // namespace

std::optional<std::size_t> correction_number(const Document& document, const std::string& name) {
  if (!document.model->corrections) return std::nullopt;
  const auto all = document.model->corrections->all();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i]->drawn.sketch.name == name) return i;
  }
  return std::nullopt;
}

Changed with_redrawn_correction(const Document& document, std::size_t number, const RedrawCurve& command) {
  auto sketches = correction_sketches(*document.model);
  articulation::Sketch& sketch = sketches[number].sketch;
  if (const auto own = geometry::Camera::make(command.view.camera, command.view.viewport); !own) {
    return base::Error{own.error().what, "view", own.error().remedy};
  }
  auto drawn = redrawn(sketch, command.role, rescaled(command.line, command.view.viewport, sketch.viewport),
                       command.view.camera);
  if (!drawn) return drawn.error();
  sketch = std::move(drawn).value();
  return with_sketches(document, sketches, number);
}

Changed with_renamed_correction(const Document& document, std::size_t number, const std::string& to) {
  auto sketches = correction_sketches(*document.model);
  if (sketches[number].sketch.name == to) return document;
  if (auto taken = check_free(document, to)) return *taken;
  sketches[number].sketch.name = to;
  return with_sketches(document, sketches, number);
}

Changed with_mirrored_correction(const Document& document, std::size_t number, const std::string& to, Parts& work) {
  auto sketches = correction_sketches(*document.model);
  const auto canvas = work.canvas_of(document);
  if (!canvas) return canvas.error();
  const auto plane = articulation::find_symmetry_plane(**canvas);
  if (!plane) return plane.error();
  articulation::CorrectionSketch other = sketches[number];
  other.sketch = articulation::mirrored(other.sketch, *plane);
  if (!to.empty()) other.sketch.name = to;
  if (auto taken = check_free(document, other.sketch.name)) return *taken;
  for (Driver& driver : other.drivers) {
    const std::string name = articulation::mirrored_name(driver.control);
    if (rig::find_parameter(document.model->rig->parameters(), name)) driver.control = name;
  }
  sketches.push_back(std::move(other));
  return with_sketches(document, sketches, sketches.size() - 1);
}

base::Result<std::shared_ptr<const articulation::Canvas>> pending_canvas(const Document& document, Parts& work) {
  if (!document.pending || document.pending->drivers.empty()) return work.canvas_of(document);
  return make_posed_canvas(*document.model, document.pending->drivers);
}

base::Status check_pending_pose(const Document& document) {
  if (!document.pending || document.pending->drivers.empty()) return base::Done{};
  const base::Error other{"the pose is not the one that the correction was begun at", "",
                          "bring it back (undo), or cancel the correction and begin it anew"};
  const std::vector<Driver> posed = posed_controls(document);
  if (posed.size() != document.pending->drivers.size()) return other;
  for (const Driver& wanted : document.pending->drivers) {
    const bool there = std::any_of(posed.begin(), posed.end(), [&](const Driver& one) {
      return one.control == wanted.control && std::abs(one.value - wanted.value) <= k_at_rest;
    });
    if (!there) return other;
  }
  return base::Done{};
}

Changed run(const Document& document, const BeginCorrection& command, Parts&) {
  PendingSketch pending;
  pending.sketch.name = command.name.empty() ? free_correction_name(document) : command.name;
  pending.sketch.mode = command.mode;
  if (rig::find_parameter(document.model->rig->parameters(), pending.sketch.name)) {
    return base::Error{"a control has the name \"" + pending.sketch.name + "\" already", "name",
                       "give the correction another name"};
  }
  for (const auto& one : correction_sketches(*document.model)) {
    if (one.sketch.name == pending.sketch.name) {
      return base::Error{"a correction has the name \"" + pending.sketch.name + "\" already", "name",
                         "give it another name"};
    }
  }
  for (const NamedValue& one : command.drivers) pending.drivers.push_back({one.name, one.value});
  if (pending.drivers.empty()) pending.drivers = posed_controls(document);
  if (pending.drivers.size() < articulation::k_fewest_drivers) {
    return base::Error{"a correction is for a pose that two controls or more make together", "drivers",
                       "pose the face with both; for one control draw another target of it"};
  }
  if (pending.drivers.size() > articulation::k_most_drivers) {
    return base::Error{std::to_string(pending.drivers.size()) +
                           " controls are away from rest, and at most 8 bring a "
                           "correction in",
                       "drivers", "put those at rest that have nothing to do with it"};
  }
  const auto canvas = make_posed_canvas(*document.model, pending.drivers);
  if (!canvas) return canvas.error();
  Document begun = with_pending(document, std::move(pending));
  if (const auto posed = check_pending_pose(begun); !posed) {
    return base::Error{"the model does not stand in that pose", "drivers", "pose it first, or leave the drivers out"};
  }
  return begun;
}

Changed with_correction(const Document& document, const articulation::Sketch& sketch) {
  auto sketches = correction_sketches(*document.model);
  sketches.push_back({sketch, document.pending->drivers});
  auto changed = with_sketches(document, sketches, sketches.size() - 1);
  if (changed) changed->pending.reset();
  return changed;
}

Changed run(const Document& document, const DeleteCorrection& command, Parts&) {
  auto sketches = correction_sketches(*document.model);
  const auto gone = std::erase_if(sketches, [&](const auto& one) { return one.sketch.name == command.correction; });
  if (gone == 0) {
    return base::Error{"there is no correction \"" + command.correction + "\"", "correction",
                       "look at the names in the model"};
  }
  auto model = with_corrections(*document.model, sketches);
  if (!model) return model.error();
  return with_model(document, std::move(model).value());
}

}  // namespace penpose::document
