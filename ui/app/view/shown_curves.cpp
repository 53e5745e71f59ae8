#include "ui/app/view/shown_curves.h"

#include <algorithm>
#include <array>

#include "core/articulation/edit.h"
#include "core/curve/bend.h"
#include "core/curve/pairing.h"
#include "core/document/commands/apply.h"
#include "core/document/drawing/target_line.h"
#include "ui/app/tools/tool.h"
#include "ui/app/view/arc_drawing.h"
#include "ui/app/view/shown_features.h"

namespace penpose::app {
namespace {

using document::PoseCurve;
using document::PoseCurveRole;
using geometry::ModelPoint;
using geometry::PxPoint;
using render::CurveDrawing;
using render::CurveKind;

constexpr double k_far = 0.02;  // share of the model's size at which a target counts as missed altogether
constexpr float k_thin_px = 2.0F;
constexpr float k_most_width_px = 7.0F;

float width_of(double pressure, float scale) {
  return scale * (k_thin_px + (k_most_width_px - k_thin_px) * static_cast<float>(std::clamp(pressure, 0.0, 1.0)));
}

InkLook ink_look(const CurveLook& look, bool done) {
  return {look.stabiliser, look.scale, k_thin_px, k_most_width_px, done};
}

std::vector<ModelPoint> points_now(const PoseCurve& curve, const PosedSurface& surface) {
  std::vector<ModelPoint> points;
  for (const auto& point : curve.points) points.emplace_back(surface.at(point));
  return points;
}

std::vector<PxPoint> seen_in_view(const std::vector<ModelPoint>& points, const document::View& view) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  std::vector<PxPoint> seen;
  for (const auto& point : points) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    if (px) seen.push_back(*px);
  }
  return seen;
}

CurveKind kind_of(const WindowTool& window, const drawing::Tool& tool, const document::Document& document,
                  const document::View& view, const curve::Stroke& stroke) {
  if (window.line != nullptr) return window.line({document, tool});
  const auto command = drawing::command_of(document, tool, view, stroke, false);
  if (!command) return CurveKind::reference;
  if (command->holds<document::DrawReference>()) return CurveKind::reference;
  if (command->holds<document::DrawConstraint>()) return CurveKind::constraint;
  return CurveKind::target;
}

/// How far a point of a curve is from the line that was drawn for it, in the picture it was drawn in: along the line it
/// may slide, and the picture says nothing of depth. Model units.
double left_across(const document::DrawnTarget& target, const geometry::ModelPoint& now,
                   const geometry::ModelPoint& wanted) {
  const auto camera = geometry::Camera::make(target.view.camera, target.view.viewport);
  const auto px = camera ? camera->project(now) : std::nullopt;
  if (!px || target.line.empty()) return geometry::distance(now, wanted);
  double least = geometry::distance(*px, target.line.front());
  for (std::size_t i = 0; i + 1 < target.line.size(); ++i) {
    const PxPoint a = target.line[i], way = target.line[i + 1] - a, to = *px - a;
    const double length = way.x * way.x + way.y * way.y;
    const double share = length > 0.0 ? std::clamp((to.x * way.x + to.y * way.y) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, geometry::distance(*px, a + way * share));
  }
  return least * camera->units_per_px(camera->depth(now));
}

/// A line in hand, as far as it was moved or pulled.
void move_line(std::vector<PxPoint>& line, const EditingSession& editing, const CurveLook& look) {
  const double near = curve::pairing_distance_px(editing.editor().view().viewport);
  const auto bent = look.pulled ? curve::bent(line, look.pulled->at, look.dragged_by, look.pulled->reach,
                                              curve::is_closed(line, near))
                                : std::nullopt;
  if (bent) {
    line = *bent;
    return;
  }
  for (PxPoint& p : line) p = p + look.dragged_by;
}

/// The middle of a target, by which all of it is moved.
void add_handle(std::vector<CurveDrawing>& out, const std::vector<ModelPoint>& line, const CurveLook& look) {
  if (line.empty()) return;
  CurveDrawing handle;
  handle.points = {line[line.size() / 2]};
  handle.kind = CurveKind::target;
  handle.width_px = 11 * look.scale;
  out.push_back(std::move(handle));
}

void add_pose_curves(std::vector<CurveDrawing>& out, const EditingSession& editing, const PosedSurface& surface,
                     const CurveLook& look) {
  const bool held = look.dragged.has_value();
  for (const auto& curve : editing.document().curves) {
    if (!editing.moments().shows(curve->id)) continue;
    const bool lit = look.highlighted == curve->id;
    const auto now = points_now(*curve, surface);
    CurveDrawing on_surface;
    on_surface.points = now;
    on_surface.kind = curve->role == PoseCurveRole::constraint ? CurveKind::constraint : CurveKind::reference;
    on_surface.width_px = look.scale * (curve->points.size() == 1 ? 9.0F : 3.5F);
    on_surface.highlighted = lit && !curve->target;
    out.push_back(std::move(on_surface));
    // While the target is drawn anew the old one would only be in the way; one that is drawn over is shown as it will
    // be.
    const bool drawn = !held && editing.shown().live().active() && editing.shown().live().curve() == curve->id;
    const document::DrawnTarget* now_wanted = drawn           ? editing.shown().live().target()
                                              : curve->target ? &*curve->target
                                                              : nullptr;
    if (now_wanted == nullptr) continue;
    CurveDrawing target;
    target.kind = CurveKind::target;
    target.points = now_wanted->points;
    target.highlighted = lit;
    const auto& pressure = now_wanted->pressure;
    std::vector<double> pressed;
    for (std::size_t i = 0; i < target.points.size(); ++i) {
      target.point_colors.push_back(distance_color(
          left_across(*now_wanted, i < curve->aside.size() ? now[i] + curve->aside[i] : now[i], target.points[i]),
          surface.size()));
      const std::size_t at =
          pressure.empty() ? 0 : i * (pressure.size() - 1) / std::max<std::size_t>(1, now.size() - 1);
      pressed.push_back(pressure.empty() ? 0.5 : pressure[at]);
    }
    const auto seen = seen_in_view(target.points, editing.editor().view());
    if (seen.size() == target.points.size()) {
      target.widths_px = ink_widths(seen, pressed, ink_look(look, true));
    } else {
      target.width_px = width_of(0.5, look.scale);
    }
    if (look.dragged == curve->id) {
      target = {};
      target.kind = CurveKind::target;
      target.highlighted = true;
      target.points_px = seen_in_view(curve->target->points, editing.editor().view());
      move_line(target.points_px, editing, look);
    }
    if (look.handles && !held) add_handle(out, target.points, look);
    out.push_back(std::move(target));
  }
}

/// The lines of the face as it should be, where this view shows them.
void add_face_lines(std::vector<CurveDrawing>& out, const EditingSession& editing, const CurveLook& look) {
  const auto& face = editing.document().face;
  if (!face || !editing.moments().shows(face->time_s)) return;
  for (const document::FaceLine& line : face->lines) {
    auto seen = document::line_in(editing.editor().view(), *face, line);
    if (!seen) continue;
    CurveDrawing drawing;
    drawing.points_px = std::move(*seen);
    drawing.kind = CurveKind::target;
    drawing.width_px = 3 * look.scale;
    drawing.highlighted = look.highlighted == line.id;
    if (line.feature.empty()) drawing.color = render::from_srgb(0xd08a2a);
    out.push_back(std::move(drawing));
  }
}

/// The curves of the sketch so far: the lassos in px of the view in which they were drawn, the reference as it is found
/// by itself or was drawn, from wherever one looks.
void add_sketch(std::vector<CurveDrawing>& out, const EditingSession& editing, const CurveLook& look) {
  const auto& pending = editing.document().pending;
  const auto& found = editing.shown().sketch().reference();
  if (pending && !found.empty()) {
    CurveDrawing drawing;
    drawing.points = found;
    drawing.kind = CurveKind::reference;
    drawing.width_px = 4 * look.scale;
    out.push_back(std::move(drawing));
  }
  if (!pending || !(pending->sketch.camera == editing.editor().view().camera)) return;
  const articulation::Sketch& sketch = pending->sketch;
  if (!(sketch.viewport == editing.editor().view().viewport)) return;
  const auto add = [&](const std::vector<PxPoint>& line, CurveKind kind, bool closed) {
    if (line.empty()) return;
    CurveDrawing drawing;
    drawing.points_px = line;
    drawing.kind = kind;
    drawing.closed = closed;
    drawing.width_px = 3 * look.scale;
    out.push_back(std::move(drawing));
  };
  add(sketch.general, CurveKind::constraint, true);
  add(sketch.specific, CurveKind::reference, true);
  // One that was refused, so that it is seen where it was drawn.
  if (sketch.specific.empty()) add(editing.shown().sketch().refused_core(), CurveKind::constraint, true);
}

/// The border of what the first lasso took, light over dark, so that it is seen on any material.
void add_outline(std::vector<CurveDrawing>& out, const EditingSession& editing, const CurveLook& look) {
  for (const auto& line : editing.shown().sketch().outline()) {
    CurveDrawing drawing;
    drawing.points = line;
    drawing.color = render::from_srgb(0xfff7d0, 0.95F);
    drawing.width_px = 2.5F * look.scale;
    out.push_back(std::move(drawing));
  }
}

/// A control's feature where the control has brought it, and where it goes at most.
void add_deformer(std::vector<CurveDrawing>& out, const EditingSession& editing, const CurveLook& look) {
  const auto& model = editing.shown().model();
  const auto number = look.deformer.empty() || !model->deformers || editing.document().pending
                          ? std::nullopt
                          : articulation::find_deformer(*model->deformers, look.deformer);
  const auto parameter =
      number ? rig::find_parameter(model->rig->parameters(), look.deformer) : std::optional<std::size_t>();
  if (!parameter || *parameter >= editing.shown().pose().size()) return;
  const articulation::Deformer& deformer = *model->deformers->deformers()[*number];
  const auto add_target = [&](double value, std::span<const ModelPoint> points) {
    CurveDrawing line;
    line.points.assign(points.begin(), points.end());
    line.kind = CurveKind::target;
    line.width_px = k_thin_px * look.scale;
    if (look.control_target == value) {
      line.points_px = seen_in_view(line.points, editing.editor().view());
      move_line(line.points_px, editing, look);
      line.highlighted = true;
    } else if (look.handles) {
      add_handle(out, line.points, look);
    }
    out.push_back(std::move(line));
  };
  // While one of them is in hand the face shows what it would do; the line is pulled from where it was.
  const document::Model& drawn = look.control_target ? *editing.document().model : *model;
  const articulation::Deformer& pulled = *drawn.deformers->deformers()[*number];
  add_target(1.0, pulled.target());
  for (std::size_t i = 0; i < pulled.betweens().size(); ++i) {
    add_target(pulled.sketch().betweens[i].value, pulled.betweens()[i]);
  }
  CurveDrawing feature;
  feature.points = deformer.curve_at(editing.shown().pose()[*parameter]);
  feature.kind = CurveKind::reference;
  feature.width_px = 3 * look.scale;
  out.push_back(std::move(feature));
}

void add_stroke(std::vector<CurveDrawing>& out, const EditingSession& editing, const CurveLook& look) {
  const replay::DrawnStroke* stroke = editing.session().pens().current();
  if (stroke == nullptr || !stroke->on_canvas || stroke->samples.empty()) return;
  const drawing::Tool& tool = editing.editor().tool();
  const WindowTool& window = look.tool != nullptr ? *look.tool : window_tool(tool.kind);
  if (!window.draws()) return;
  CurveDrawing drawing;
  const bool erases = stroke->eraser || window.erases;
  drawing.kind = kind_of(window, tool, editing.document(), stroke->view, stroke->samples);
  if (erases) drawing.color = render::from_srgb(0xf2efe8, 0.7F);
  std::vector<PxPoint> line;
  std::vector<double> pressures;
  for (const auto& sample : stroke->samples) {
    line.push_back(sample.position);
    pressures.push_back(sample.pressure);
  }
  InkLine ink = ink_line(line, pressures, ink_look(look, false));
  drawing.points_px = std::move(ink.points);
  drawing.widths_px = std::move(ink.widths_px);
  if (erases) drawing.widths_px.assign(drawing.points_px.size(), 10 * look.scale);
  out.push_back(std::move(drawing));
}

}  // namespace

render::Color distance_color(double distance, double model_size) {
  const double share = std::clamp(distance / (k_far * model_size), 0.0, 1.0);
  return render::mix(render::curve_color(CurveKind::target), render::from_srgb(0xffb000), static_cast<float>(share));
}

std::vector<CurveDrawing> shown_curves(const EditingSession& editing, const PosedSurface& surface,
                                       const CurveLook& look) {
  std::vector<CurveDrawing> out;
  out.insert(out.end(), look.ghosts.begin(), look.ghosts.end());
  if (editing.editor().tool().kind == drawing::ToolKind::articulate) {
    add_outline(out, editing, look);
    add_sketch(out, editing, look);
  } else {
    if (look.features) add_features(out, editing, surface, {look.scale, look.all_features});
    add_face_lines(out, editing, look);
    add_pose_curves(out, editing, surface, look);
  }
  // What is played is looked at as it will be seen.
  if (editing.moments().any()) add_deformer(out, editing, look);
  add_stroke(out, editing, look);
  // A recording that is played may have been drawn in a window of another size.
  const geometry::Viewport drawn_in = editing.editor().view().viewport;
  if (look.window.width > 0 && !(look.window == drawn_in)) {
    for (CurveDrawing& drawing : out) {
      drawing.points_px = document::rescaled(drawing.points_px, drawn_in, look.window);
    }
  }
  add_arcs(out, look.arcs, look.time_s, look.scale);
  return out;
}

std::optional<document::CurveId> curve_near(const EditingSession& editing, const PosedSurface& surface, PxPoint at,
                                            double within_px) {
  const document::View& view = editing.editor().view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return std::nullopt;
  std::optional<document::CurveId> found;
  const std::array<PxPoint, 1> pen{at};
  const auto near = [&](const std::vector<ModelPoint>& points) {
    std::vector<PxPoint> seen;
    for (const auto& point : points) {
      if (const auto px = camera->project(point)) seen.push_back(*px);
    }
    return document::come_near(seen, pen, within_px);
  };
  for (const auto& curve : editing.document().curves) {
    if (!editing.moments().shows(curve->id)) continue;
    if ((curve->target && near(curve->target->points)) || near(points_now(*curve, surface))) found = curve->id;
  }
  if (const auto& face = editing.document().face; face && editing.moments().shows(face->time_s)) {
    for (const document::FaceLine& line : face->lines) {
      const auto seen = document::line_in(view, *face, line);
      if (seen && document::come_near(*seen, pen, within_px)) found = line.id;
    }
  }
  return found;
}

}  // namespace penpose::app
