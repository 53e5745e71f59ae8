#include "core/document/commands/list/deformer_commands.h"

#include <algorithm>
#include <string>

#include "core/articulation/mirror.h"
#include "core/articulation/motion/reference_curve.h"
#include "core/articulation/region/region.h"
#include "core/document/commands/apply_deformers.h"
#include "core/geometry/lasso.h"

namespace penpose::document {

using articulation::CurveRole;
using articulation::Sketch;
using articulation::SketchedDeformers;

SketchedDeformers::Shared deformers_of(const Document& document) {
  if (document.model->deformers) return document.model->deformers;
  return std::make_shared<const SketchedDeformers>();
}

base::Result<std::size_t> deformer_number(const Document& document, const std::string& name) {
  const auto number = find_deformer(*deformers_of(document), name);
  if (!number) return base::Error{"there is no control \"" + name + "\"", "deformer", "look at the names in the model"};
  return *number;
}

Document with_pending(const Document& document, PendingSketch pending) {
  Document changed = document;
  changed.pending = std::make_shared<const PendingSketch>(std::move(pending));
  return changed;
}

namespace {

/// A control may not take the name of the deformer that is being sketched, nor go while a correction is drawn at a pose
/// of it: the sketch could not be completed, nor read again from a file.
std::optional<base::Error> check_pending_name(const Document& document) {
  if (!document.pending) return std::nullopt;
  const std::string& name = document.pending->sketch.name;
  for (const articulation::Driver& driver : document.pending->drivers) {
    if (rig::find_parameter(document.model->rig->parameters(), driver.control)) continue;
    return base::Error{"the correction that is being sketched is drawn at a pose of \"" + driver.control + "\"", "",
                       "complete or cancel it first"};
  }
  if (!rig::find_parameter(document.model->rig->parameters(), name)) return std::nullopt;
  return base::Error{"the control that is being sketched has the name \"" + name + "\"", "",
                     "complete or cancel it first"};
}

Changed with_set(const Document& document, const base::Result<SketchedDeformers::Shared>& set) {
  if (!set) return set.error();
  auto changed = with_deformers(document, *set);
  if (!changed) return changed;
  if (auto error = check_pending_name(*changed)) return *error;
  return changed;
}

std::string free_deformer_name(const Document& document) {
  for (std::size_t n = 1;; ++n) {
    std::string name = "deformer " + std::to_string(n);
    if (!rig::find_parameter(document.model->rig->parameters(), name)) return name;
  }
}

base::Error not_yet(const char* what, const char* remedy) { return {what, "role", remedy}; }

Document with_pending(const Document& document, Sketch sketch) {
  std::vector<articulation::Driver> drivers;
  if (document.pending) drivers = document.pending->drivers;
  return with_pending(document, PendingSketch{std::move(sketch), std::move(drivers)});
}

/// Step 1 or 2 (method, section 3); a region that holds nothing is told at once.
Changed draw_region(const Document& document, Sketch sketch, const SketchCurve& command, Parts& work) {
  const bool general = command.role == CurveRole::general;
  if (general) {
    sketch.camera = command.view.camera;
    sketch.viewport = command.view.viewport;
    sketch.specific.clear();
    sketch.piece = 0;
    sketch.reference.clear();
    sketch.reference_camera.reset();
  } else {
    if (sketch.general.empty()) {
      return not_yet("the first line is not drawn yet", "draw around all that should move");
    }
    if (!(sketch.camera == command.view.camera) || !(sketch.viewport == command.view.viewport)) {
      return base::Error{"the view has changed since the first line was drawn", "view", "draw both lines in one view"};
    }
  }
  const auto camera = geometry::Camera::make(sketch.camera, sketch.viewport);
  if (!camera) return at("view", camera.error());
  const auto canvas = pending_canvas(document, work);
  if (!canvas) return canvas.error();
  const auto surface = articulation::KeptSurface::make(sketch.surface, **canvas);
  if (!surface) return surface.error();
  (general ? sketch.general : sketch.specific) = command.line;
  if (const auto whole = articulation::check_crossing(command.line); !whole) {
    return at("line", at(general ? "general" : "core", whole.error()));
  }
  const auto region = general_region(**canvas, *camera, sketch.general, *surface, articulation::Borders::measured,
                                     {sketch.reach, sketch.piece});
  if (!region) return at("line", region.error());
  if (!general) {
    const auto weights = specific_region(*region, sketch.specific);
    if (!weights && geometry::Lasso::make(sketch.specific)) {
      return at("line", at("core", core_outside(*region, sketch.specific)));
    }
    if (!weights) return at("line", weights.error());
  }
  return with_pending(document, std::move(sketch));
}

Changed complete(const Document& document, const Sketch& sketch, Parts& work) {
  if (document.pending && !document.pending->drivers.empty()) return with_correction(document, sketch);
  const auto canvas = work.canvas_of(document);
  if (!canvas) return canvas.error();
  auto deformer = build_deformer(sketch, **canvas);
  if (!deformer) return deformer.error();
  Document completed = document;
  completed.pending.reset();
  return with_set(completed, with_added(*deformers_of(document), std::move(deformer).value()));
}

}  // namespace

Changed with_deformer_from(const Document& document, std::size_t number, const Sketch& sketch, Parts& work) {
  const auto canvas = work.canvas_of(document);
  if (!canvas) return canvas.error();
  return with_set(document, with_sketch(*deformers_of(document), number, sketch, **canvas));
}

std::vector<PxPoint> rescaled(const std::vector<PxPoint>& line, geometry::Viewport from, geometry::Viewport to) {
  if (from == to) return line;
  const double scale = static_cast<double>(to.height) / static_cast<double>(from.height);
  std::vector<PxPoint> other;
  for (const PxPoint& p : line) other.push_back({(p.x - 0.5 * from.width) * scale + 0.5 * to.width, p.y * scale});
  return other;
}

Changed with_deformers(const Document& document, std::shared_ptr<const articulation::SketchedDeformers> deformers) {
  auto model = with_deformers(*document.model, std::move(deformers));
  if (!model) return model.error();
  return with_model(document, std::move(model).value());
}

Changed run(const Document& document, const BeginDeformer& command, Parts&) {
  Sketch sketch;
  sketch.name = command.name.empty() ? free_deformer_name(document) : command.name;
  if (rig::find_parameter(document.model->rig->parameters(), sketch.name)) {
    return base::Error{"a control has the name \"" + sketch.name + "\" already", "name", "give it another name"};
  }
  sketch.mode = command.mode;
  sketch.surface = command.surface;
  sketch.minimum = command.minimum;
  sketch.maximum = command.maximum;
  // What is wrong already is told before anything is drawn.
  Sketch drawn = sketch;
  drawn.general = drawn.specific = drawn.target = {{}};
  if (const auto checked = check_sketch(drawn); !checked) return checked.error();
  return with_pending(document, std::move(sketch));
}

Changed run(const Document& document, const SketchCurve& command, Parts& work) {
  if (const auto posed = check_pending_pose(document); !posed) return posed.error();
  Sketch sketch;
  if (document.pending) {
    sketch = document.pending->sketch;
  } else {
    sketch.name = free_deformer_name(document);
  }
  if (command.line.size() > articulation::k_most_points) {
    return base::Error{"the curve has too many points", "line", "use at most 100,000"};
  }
  if (command.role == CurveRole::general || command.role == CurveRole::specific) {
    return draw_region(document, std::move(sketch), command, work);
  }
  if (sketch.specific.empty()) {
    return not_yet("the second line is not drawn yet", "draw around what should move as a whole");
  }
  if (const auto own = geometry::Camera::make(command.view.camera, command.view.viewport); !own) {
    return at("view", own.error());
  }
  const std::vector<PxPoint> line = rescaled(command.line, command.view.viewport, sketch.viewport);
  auto drawn = redrawn(sketch, command.role, line, command.view.camera);
  if (!drawn) return drawn.error();
  if (command.role == CurveRole::target) return complete(document, *drawn, work);
  const auto canvas = pending_canvas(document, work);
  if (!canvas) return canvas.error();
  const auto camera = geometry::Camera::make(command.view.camera, sketch.viewport);
  if (!camera) return at("view", camera.error());
  if (!line.empty()) {
    const auto reference =
        sheet_reference(**canvas, *camera, line, articulation::k_curve_points, curve::SheetChoice::nearer);
    if (!reference) return at("line", reference.error());
  }
  return with_pending(document, std::move(drawn).value());
}

Changed run(const Document& document, const CancelDeformer&, Parts&) {
  if (!document.pending) return base::Error{"no control is being sketched", "", ""};
  Document changed = document;
  changed.pending.reset();
  return changed;
}

Changed run(const Document& document, const RedrawCurve& command, Parts& work) {
  if (const auto correction = correction_number(document, command.deformer)) {
    return with_redrawn_correction(document, *correction, command);
  }
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  const Sketch& sketch = document.model->deformers->deformers()[*number]->sketch();
  if (const auto own = geometry::Camera::make(command.view.camera, command.view.viewport); !own) {
    return at("view", own.error());
  }
  auto drawn = redrawn(sketch, command.role, rescaled(command.line, command.view.viewport, sketch.viewport),
                       command.view.camera);
  if (!drawn) return drawn.error();
  return with_deformer_from(document, *number, *drawn, work);
}

Changed run(const Document& document, const ChangeDeformer& command, Parts& work) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  Sketch sketch = document.model->deformers->deformers()[*number]->sketch();
  if (command.mode) sketch.mode = *command.mode;
  if (command.surface) sketch.surface = *command.surface;
  if (command.minimum) sketch.minimum = *command.minimum;
  if (command.maximum) sketch.maximum = *command.maximum;
  if (command.other_sheet) {
    if (sketch.paper || sketch.reference.empty()) {
      return base::Error{"the reference was not drawn on a sheet of the surface", "other_sheet", "draw the reference"};
    }
    sketch.other_sheet = *command.other_sheet;
  }
  if (command.reach) {
    sketch.reach = *command.reach;
    sketch.piece = 0;
  }
  if (command.piece) sketch.piece = *command.piece;
  const bool moves_as_before =
      !command.mode && !command.surface && !command.other_sheet && !command.reach && !command.piece;
  // Both ends of the range of what is held together are mended, so that another range is another motion.
  if (moves_as_before && sketch.paper)
    return with_set(document, with_range(*deformers_of(document), *number, sketch.minimum, sketch.maximum));
  return with_deformer_from(document, *number, sketch, work);
}

Changed run(const Document& document, const MirrorDeformer& command, Parts& work) {
  if (const auto correction = correction_number(document, command.deformer)) {
    return with_mirrored_correction(document, *correction, command.to, work);
  }
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  const auto canvas = work.canvas_of(document);
  if (!canvas) return canvas.error();
  return with_set(document, with_mirrored(*deformers_of(document), *number, **canvas, command.to));
}

namespace {

std::shared_ptr<const std::vector<TakenReading>> renamed(std::vector<TakenReading> taken, const std::string& from,
                                                         const std::string& to) {
  for (TakenReading& one : taken) {
    std::replace(one.taken.begin(), one.taken.end(), from, to);
    std::replace(one.instead_of.begin(), one.instead_of.end(), from, to);
  }
  return std::make_shared<const std::vector<TakenReading>>(std::move(taken));
}

}  // namespace

Changed run(const Document& document, const RenameDeformer& command, Parts&) {
  if (const auto correction = correction_number(document, command.deformer)) {
    return with_renamed_correction(document, *correction, command.to);
  }
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  const auto set = with_name(*deformers_of(document), *number, command.to);
  if (!set) return set.error();
  Model before = *document.model;
  std::vector<articulation::CorrectionSketch> corrections = correction_sketches(before);
  for (articulation::CorrectionSketch& one : corrections) {
    for (articulation::Driver& driver : one.drivers) {
      if (driver.control == command.deformer) driver.control = command.to;
    }
  }
  before.corrections = nullptr;
  auto model = with_deformers(before, *set);
  if (model && !corrections.empty()) model = with_corrections(std::move(*model), corrections);
  if (!model) return model.error();
  // The parameters keep their places, so that poses and animations fit as they are.
  model->pose = document.pose;
  model->animations = std::move(before.animations);
  Document changed = document;
  changed.model = std::make_shared<const Model>(std::move(model).value());
  const auto locked = std::find(changed.locked.begin(), changed.locked.end(), command.deformer);
  if (locked != changed.locked.end()) {
    *locked = command.to;
    std::stable_sort(changed.locked.begin(), changed.locked.end());
  }
  changed.mouths = with_renamed_control(document.mouths, command.deformer, command.to);
  if (changed.taken) changed.taken = renamed(*changed.taken, command.deformer, command.to);
  if (auto error = check_pending_name(changed)) return *error;
  return changed;
}

Changed run(const Document& document, const DeleteDeformer& command, Parts&) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  return with_set(document, without(*deformers_of(document), *number));
}

Changed run(const Document& document, const MoveDeformer& command, Parts&) {
  const auto number = deformer_number(document, command.deformer);
  if (!number) return number.error();
  return with_set(document, moved(*deformers_of(document), *number, command.to));
}

}  // namespace penpose::document
