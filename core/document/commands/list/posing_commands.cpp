#include "core/document/commands/list/posing_commands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/curve/pairing.h"
#include "core/curve/sheet_line.h"
#include "core/curve/slight_parts.h"
#include "core/document/commands/apply_parts.h"
#include "core/document/commands/list/solved_lines.h"
#include "core/document/drawing/moment.h"
#include "core/document/drawing/pose_problem.h"
#include "core/document/drawing/pulled_target.h"
#include "core/document/drawing/target_line.h"
#include "core/geometry/lasso.h"

namespace penpose::document {
namespace {

using geometry::ModelPoint;

/// Brings all references to their targets; a document with no target, or nothing that may move, keeps its pose.
Changed solved(Document document, Preset preset, Parts& work) {
  if (preset == Preset::meant) {
    const intent::IntentProblem problem = intent_problem(document);
    if ((problem.drawn.empty() && problem.known.empty()) || problem.free.empty()) return document;
    auto solution = intent::solve(*document.model->rig, work.whole_of(document), problem, {}, work.meant);
    if (!solution) return solution.error();
    document.pose = std::move(solution->pose);
    return document;
  }
  posing::PoseProblem problem = pose_problem(document);
  if (problem.pairs.empty() || problem.free.empty()) return document;
  posing::SolveOptions options;
  options.paper = preset == Preset::paper;
  auto solution = posing::solve(*document.model->rig, problem, options, work.solve);
  if (!solution) return solution.error();
  document.pose = std::move(solution->pose);
  return document;
}

/// Gives a reference another target, and solves.
Changed retargeted(const Document& document, const PoseCurve& curve, const View& view, const std::vector<PxPoint>& line,
                   const std::vector<double>& pressure, Parts& work) {
  auto target = make_target(positions_of(document, curve.points), view, line, pressure);
  if (!target) return target.error();
  PoseCurve other = curve;
  other.target = std::move(target).value();
  return solved_for(with_replaced(document, std::move(other)), curve.id, work);
}

/// Where a view shows points; those behind the camera are left out.
std::vector<PxPoint> seen(const geometry::Camera& camera, const std::vector<ModelPoint>& points) {
  std::vector<PxPoint> out;
  for (const ModelPoint& point : points) {
    if (const auto px = camera.project(point)) out.push_back(*px);
  }
  return out;
}

PxPoint middle_of(const std::vector<PxPoint>& line) {
  PxPoint sum;
  for (const PxPoint& p : line) sum = sum + p;
  return sum * (1.0 / static_cast<double>(line.size()));
}

/// How far a reference stays away from its target, px in the mean, as multiples of the hand's doubt.
double left_doubts(Document document, CurveId id, Parts& work) {
  std::erase_if(document.curves, [&](const auto& curve) { return !(curve->id == id); });
  const intent::IntentProblem problem = intent_problem(document);
  if (problem.drawn.size() != 1) return 0.0;
  const auto left = intent::left_at_start(*document.model->rig, work.whole_of(document), problem);
  return left ? left->front().px / problem.drawn.front().doubt_px : 0.0;
}

/// Lips that touch are told apart by where a line goes: where its reference can hardly be brought there, and one on the
/// other sheet beside it can, that one was meant. Takes and gives the document after a target was drawn.
Changed on_the_sheet_that_was_meant(const Document& before, const PoseCurve& curve, const DrawTarget& command,
                                    Document after, Parts& work) {
  constexpr double k_far = 6.0;
  constexpr double k_near = 0.4;
  constexpr double k_aside_px = 4.0;  // half of what a line sticks beside the pen, at 1000 px high
  if (curve.target || find_curve(after, curve.id) == nullptr) return after;
  const double left = left_doubts(after, curve.id, work);
  const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport);
  if (left < k_far || !camera) return after;
  // The sheet on which the line went lies on its side of the reference.
  std::vector<PxPoint> line = seen(*camera, positions_of(before, curve.points));
  if (line.size() < 2) return after;
  const PxPoint way = middle_of(command.line) - middle_of(line);
  const double aside = k_aside_px * command.view.viewport.height / 1000.0;
  for (PxPoint& p : line) p = p + way * (aside / std::max(geometry::distance(way, {}), aside));
  auto points = drawn_on_surface(before, command.view, line, work);
  if (!points || points->dropped > 0) return after;
  PoseCurve other = curve;
  other.points = std::move(points->points);
  other.aside = std::move(points->aside);
  auto there = retargeted(with_replaced(before, other), other, command.view, command.line, command.pressure, work);
  if (!there || find_curve(*there, curve.id) == nullptr) return after;
  return left_doubts(*there, curve.id, work) < k_near * left ? there : Changed(std::move(after));
}

}  // namespace

base::Result<curve::ProjectedStroke> drawn_on_surface(const Document& document, const View& view,
                                                      const std::vector<PxPoint>& line, Parts& work) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return at("view", camera.error());
  const geometry::TriangleBvh& tree = work.surface_of(document);
  const curve::SheetSurface surface{tree, work.surface_positions(), document.model->mesh->triangles(),
                                    work.sheets_of(document)};
  auto drawn = curve::sheet_curve(line, k_pose_curve_points, *camera, surface);
  if (!drawn) return at("line", drawn.error());
  curve::stand_on_body(*drawn, surface);
  return drawn;
}

base::Error no_such_curve(CurveId id) {
  return {"there is no curve " + std::to_string(id.value), "curve", "it may have been deleted"};
}

Changed with_curve(const Document& document, PoseCurve curve) {
  if (document.last_curve == std::numeric_limits<std::uint32_t>::max()) {
    return base::Error{"all numbers of curves are used up", "", "draw on in a new document"};
  }
  Document changed = document;
  curve.id = CurveId{++changed.last_curve};
  changed.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  return changed;
}

Document with_replaced(const Document& document, PoseCurve curve) {
  Document changed = document;
  for (auto& one : changed.curves) {
    if (one->id == curve.id) one = std::make_shared<const PoseCurve>(curve);
  }
  return changed;
}

base::Result<const PoseCurve*> reference_named(const Document& document, CurveId id, bool with_line) {
  const PoseCurve* curve = find_curve(document, id);
  if (curve == nullptr) return no_such_curve(id);
  if (curve->role != PoseCurveRole::reference) {
    return base::Error{"curve " + std::to_string(id.value) + " is a constraint", "curve", "name a reference curve"};
  }
  if (with_line && !curve->target) {
    return base::Error{"curve " + std::to_string(id.value) + " has no target yet", "curve", "draw its target first"};
  }
  if (with_line && curve->target->line.empty()) {
    return base::Error{"the target of curve " + std::to_string(id.value) + " was given as points, not drawn", "curve",
                       "draw a target for it, or give other points"};
  }
  return curve;
}

std::vector<ModelPoint> positions_of(const Document& document, const std::vector<mesh::MeshPoint>& points) {
  const auto triangles = document.model->mesh->triangles();
  std::vector<std::uint32_t> vertices;
  for (const mesh::MeshPoint& point : points) {
    const mesh::Triangle& corners = triangles[point.triangle];
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::vector<ModelPoint> corners(vertices.size());
  document.model->rig->bind(vertices)->evaluate(document.pose, corners);
  std::vector<ModelPoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& b = points[i].barycentric;
    out.push_back(corners[3 * i] * b[0] + corners[3 * i + 1] * b[1] + corners[3 * i + 2] * b[2]);
  }
  return out;
}

Changed run(const Document& document, const DrawReference& command, Parts& work) {
  auto points = drawn_on_surface(document, command.view, command.line, work);
  if (!points) return points.error();
  PoseCurve curve;
  curve.points = std::move(points->points);
  curve.aside = std::move(points->aside);
  return with_curve(document, std::move(curve));
}

Changed run(const Document& document, const DrawTarget& command, Parts& work) {
  const auto curve = reference_named(document, command.curve, false);
  if (!curve) return curve.error();
  auto drawn = retargeted(document, **curve, command.view, command.line, command.pressure, work);
  if (!drawn) return drawn;
  return on_the_sheet_that_was_meant(document, **curve, command, std::move(drawn).value(), work);
}

Changed run(const Document& document, const OversketchTarget& command, Parts& work) {
  const auto curve = reference_named(document, command.curve, true);
  if (!curve) return curve.error();
  const DrawnTarget& target = *(*curve)->target;
  auto over = drawn_over(target, positions_of(document, (*curve)->points), command.view, command.line);
  if (!over) return over.error();
  PoseCurve other = **curve;
  other.target = std::move(over).value();
  return corrected(document, other, untouched(target, *other.target), work);
}

Changed run(const Document& document, const DragTarget& command, Parts& work) {
  const auto curve = reference_named(document, command.curve, true);
  if (!curve) return curve.error();
  if (!(std::abs(command.by.x) <= geometry::k_largest_px && std::abs(command.by.y) <= geometry::k_largest_px)) {
    return base::Error{"the target cannot go that far", "by", "drag it by at most a million px"};
  }
  const DrawnTarget& target = *(*curve)->target;
  std::vector<PxPoint> line = target.line;
  for (PxPoint& p : line) p = p + command.by;
  return retargeted(document, **curve, target.view, line, target.pressure, work);
}

Changed run(const Document& document, const PullTarget& command, Parts& work) {
  const auto curve = reference_named(document, command.curve, true);
  if (!curve) return curve.error();
  auto pulled = pulled_target(*(*curve)->target, command);
  if (!pulled) return pulled.error();
  PoseCurve other = **curve;
  other.target = std::move(pulled).value();
  return corrected(document, other, untouched(*(*curve)->target, *other.target), work);
}

Changed run(const Document& document, const DrawConstraint& command, Parts& work) {
  auto points = drawn_on_surface(document, command.view, command.line, work);
  if (!points) return points.error();
  PoseCurve curve;
  curve.role = PoseCurveRole::constraint;
  curve.points = std::move(points->points);
  curve.kept = positions_of(document, curve.points);
  return with_curve(document, std::move(curve));
}

Changed run(const Document& document, const Pin& command, Parts& work) {
  const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport);
  if (!camera) return at("view", camera.error());
  const auto hit = work.surface_of(document).nearest_hit(camera->ray(command.at));
  if (!hit) return base::Error{"the pin does not touch the mesh", "at", "put it on the mesh"};
  PoseCurve curve;
  curve.role = PoseCurveRole::constraint;
  curve.points = {{hit->triangle, hit->barycentric}};
  curve.kept = positions_of(document, curve.points);
  return with_curve(document, std::move(curve));
}

Changed run(const Document& document, const KeepCurve& command, Parts&) {
  const auto curve = reference_named(document, command.curve, false);
  if (!curve) return curve.error();
  PoseCurve kept = **curve;
  kept.role = PoseCurveRole::constraint;
  kept.target.reset();
  kept.kept = positions_of(document, kept.points);
  return with_replaced(document, std::move(kept));
}

Changed run(const Document& document, const DeleteCurve& command, Parts& work) {
  if (find_face_line(document, command.curve) != nullptr) {
    FaceDrawing drawing = *document.face;
    std::erase_if(drawing.lines, [&](const FaceLine& line) { return line.id == command.curve; });
    return with_face_read(document, std::move(drawing), work);
  }
  if (find_curve(document, command.curve) == nullptr) return no_such_curve(command.curve);
  Document changed = document;
  std::erase_if(changed.curves, [&](const auto& curve) { return curve->id == command.curve; });
  return changed;
}

Changed run(const Document& document, const EraseCurves& command, Parts& work) {
  const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport);
  if (!camera) return at("view", camera.error());
  const double near = curve::pairing_distance_px(command.view.viewport);
  Document changed = document;
  std::erase_if(changed.curves, [&](const auto& curve) {
    if (come_near(seen(*camera, positions_of(document, curve->points)), command.line, near)) return true;
    return curve->target && come_near(seen(*camera, curve->target->points), command.line, near);
  });
  if (document.face) {
    FaceDrawing drawing = *document.face;
    std::erase_if(drawing.lines, [&](const FaceLine& line) {
      const auto there = line_in(command.view, drawing, line);
      return there && come_near(*there, command.line, near);
    });
    if (drawing.lines.size() != document.face->lines.size()) return with_face_read(changed, std::move(drawing), work);
  }
  if (changed.curves.size() == document.curves.size()) {
    return base::Error{"there is no curve under the eraser", "line", "draw over a curve"};
  }
  return changed;
}

Changed run(const Document& document, const ClearCurves&, Parts&) {
  Document changed = document;
  changed.curves.clear();
  changed.face = nullptr;
  return changed;
}

Changed run(const Document& document, const SolvePose& command, Parts& work) {
  auto changed = solved(document, command.preset, work);
  if (changed && command.preset == Preset::meant) changed->moment = moment_of_all(document, changed->pose);
  return changed;
}

Changed run(const Document& document, const SetPressureWeighting& command, Parts&) {
  Document changed = document;
  changed.pressure_weighting = command.on;
  return changed;
}

Changed run(const Document& document, const SetHand& command, Parts&) {
  if (!(command.unsteadiness >= k_steadiest_hand && command.unsteadiness <= k_shakiest_hand))
    return base::Error{"no hand is like that", "unsteadiness", "give 0.25 to 4; a usual hand has 1"};
  Document changed = document;
  changed.hand = command.unsteadiness;
  return changed;
}

Changed run(const Document& document, const NameCurve& command, Parts&) {
  const PoseCurve* curve = find_curve(document, command.curve);
  if (curve == nullptr) return no_such_curve(command.curve);
  if (command.name.empty()) return base::Error{"a curve of the model needs a name", "name", "give one"};
  Model model = *document.model;
  NamedCurve named{command.name, curve->points};
  const auto same = std::find_if(model.curves.begin(), model.curves.end(),
                                 [&](const NamedCurve& one) { return one.name == command.name; });
  if (same != model.curves.end()) {
    *same = std::move(named);
  } else {
    model.curves.push_back(std::move(named));
  }
  Document changed = document;
  changed.model = std::make_shared<const Model>(std::move(model));
  return changed;
}

Changed run(const Document& document, const DeleteNamedCurve& command, Parts&) {
  Model model = *document.model;
  const auto erased = std::erase_if(model.curves, [&](const NamedCurve& one) { return one.name == command.name; });
  if (erased == 0) return base::Error{"the model has no curve \"" + command.name + "\"", "name", ""};
  Document changed = document;
  changed.model = std::make_shared<const Model>(std::move(model));
  return changed;
}

}  // namespace penpose::document
