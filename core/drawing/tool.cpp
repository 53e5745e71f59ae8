#include "core/drawing/tool.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/curve/pairing.h"
#include "core/document/commands/text_members.h"

namespace penpose::document {

template <>
struct TextForm<drawing::ToolKind> {
  static constexpr std::array<std::pair<drawing::ToolKind, std::string_view>, 13> k_names{
      {{drawing::ToolKind::pose, "pose"},
       {drawing::ToolKind::reference, "reference"},
       {drawing::ToolKind::target, "target"},
       {drawing::ToolKind::oversketch, "oversketch"},
       {drawing::ToolKind::constraint, "constraint"},
       {drawing::ToolKind::pin, "pin"},
       {drawing::ToolKind::articulate, "articulate"},
       {drawing::ToolKind::redraw, "redraw"},
       {drawing::ToolKind::erase, "erase"},
       {drawing::ToolKind::none, "none"},
       {drawing::ToolKind::between, "between"},
       {drawing::ToolKind::draw, "draw"},
       {drawing::ToolKind::feature, "feature"}}};
  static void write(std::string& out, drawing::ToolKind value) {
    for (const auto& [kind, name] : k_names) {
      if (kind == value) out += name;
    }
  }
  static std::optional<drawing::ToolKind> read(std::string_view text) {
    for (const auto& [kind, name] : k_names) {
      if (name == text) return kind;
    }
    return std::nullopt;
  }
};

}  // namespace penpose::document

namespace penpose::drawing {
namespace {

using articulation::CurveRole;
using document::CurveId;
using document::Document;
using document::PoseCurveRole;

std::optional<CurveId> last_with_target(const Document& document) {
  std::optional<CurveId> found;
  for (const auto& curve : document.curves) {
    if (curve->target) found = curve->id;
  }
  return found;
}

std::vector<double> pressure_of(const curve::Stroke& stroke) {
  std::vector<double> pressure;
  for (const curve::StrokeSample& sample : stroke) pressure.push_back(sample.pressure);
  return pressure;
}

document::DrawTarget target_of(CurveId curve, const document::View& view, const curve::Stroke& stroke) {
  return {curve, view, curve::positions_of(stroke), pressure_of(stroke)};
}

}  // namespace

std::string to_text(const Tool& tool) {
  std::string out;
  document::append_members(out, tool);
  if (!out.empty()) out.erase(0, 1);
  return out;
}

base::Result<Tool> parse_tool(std::string_view text) { return document::parse_members<Tool>(text); }

CurveRole next_step(const Document& document, const Tool& tool) {
  if (!document.pending || document.pending->sketch.general.empty()) return CurveRole::general;
  const articulation::Sketch& sketch = document.pending->sketch;
  if (sketch.specific.empty()) return CurveRole::specific;
  return tool.draw_reference && sketch.reference.empty() ? CurveRole::reference : CurveRole::target;
}

bool is_tap(const curve::Stroke& stroke, geometry::Viewport viewport) {
  const double near = 0.5 * curve::pairing_distance_px(viewport);
  return std::all_of(stroke.begin(), stroke.end(), [&](const curve::StrokeSample& sample) {
    return geometry::distance(sample.position, stroke.front().position) < near;
  });
}

base::Result<document::Command> command_of(const Document& document, const Tool& tool, const document::View& view,
                                           const curve::Stroke& stroke, bool eraser) {
  using Command = document::Command;
  auto line = curve::positions_of(stroke);
  if (eraser || tool.kind == ToolKind::erase) return Command(document::EraseCurves{view, std::move(line)});
  const auto waiting = document::waiting_reference(document);
  switch (tool.kind) {
    case ToolKind::pose:
      if (waiting) return Command(target_of(*waiting, view, stroke));
      return Command(document::DrawReference{view, std::move(line)});
    case ToolKind::reference:
      return Command(document::DrawReference{view, std::move(line)});
    case ToolKind::target:
      if (tool.curve) return Command(target_of(tool.curve, view, stroke));
      if (waiting) return Command(target_of(*waiting, view, stroke));
      return base::Error{"no reference curve waits for a target", "", "draw a reference curve first"};
    case ToolKind::oversketch: {
      const auto last = tool.curve ? std::optional(tool.curve) : last_with_target(document);
      if (last) return Command(document::OversketchTarget{*last, view, std::move(line)});
      return base::Error{"there is no target to draw over", "", "draw a target first"};
    }
    case ToolKind::constraint:
      return Command(document::DrawConstraint{view, std::move(line)});
    case ToolKind::pin:
      if (!line.empty()) return Command(document::Pin{view, line.front()});
      break;
    case ToolKind::articulate:
      return Command(document::SketchCurve{next_step(document, tool), view, std::move(line)});
    case ToolKind::redraw:
      return Command(document::RedrawCurve{tool.deformer, tool.role, view, std::move(line)});
    case ToolKind::between:
      return Command(document::DrawBetween{tool.deformer, tool.value, view, std::move(line)});
    case ToolKind::draw:
      return Command(document::DrawFaceLine{{view, std::move(line)}});
    case ToolKind::feature:
      return Command(document::DrawFeature{view, std::move(line), {}});
    case ToolKind::erase:
    case ToolKind::none:
      break;
  }
  return base::Error{"no tool is in hand", "", "choose a tool"};
}

}  // namespace penpose::drawing
