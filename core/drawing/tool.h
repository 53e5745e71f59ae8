#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/members.h"
#include "core/base/result.h"
#include "core/curve/stroke.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"

namespace penpose::drawing {

/// What the pen does on the canvas.
enum class ToolKind : std::uint8_t {
  pose,        ///< a reference, then its target, then the next reference
  reference,   ///< references only
  target,      ///< the target of `curve`, else of the first reference that has none
  oversketch,  ///< a part of the target of `curve`, else of the last reference that has one
  constraint,
  pin,         ///< where the pen first touches
  articulate,  ///< the curves of a deformer in their order
  redraw,      ///< one curve of a deformer that exists
  erase,
  none,     ///< strokes do nothing
  between,  ///< another target of a deformer, at `value`
  draw,     ///< lines of the face as it should be
  feature,  ///< lines along features of the face as it is, which correct where they are
};

struct Tool {
  ToolKind kind = ToolKind::pose;
  document::CurveId curve;      ///< for target and oversketch; null: chosen as the kind says
  bool draw_reference = false;  ///< articulate: the reference is drawn and not inferred
  std::string deformer;         ///< redraw, between: of which deformer
  articulation::CurveRole role = articulation::CurveRole::target;  ///< redraw: which of its curves
  double value = 0.5;                                              ///< between: at which value
  static auto members(auto& self) {
    return base::named("kind", self.kind, "curve", self.curve, "draw_reference", self.draw_reference, "deformer",
                       self.deformer, "role", self.role, "value", self.value);
  }
  friend bool operator==(const Tool&, const Tool&) = default;
};

/// "kind=articulate draw_reference=1": members that are not at their defaults, as commands write them.
[[nodiscard]] std::string to_text(const Tool& tool);
[[nodiscard]] base::Result<Tool> parse_tool(std::string_view text);

/// The step of a deformer that the next stroke of `articulate` draws.
[[nodiscard]] articulation::CurveRole next_step(const document::Document& document, const Tool& tool);

/// Whether a pen only touched the canvas, or trembled there: no line for any tool. Where it is no further than 5 px of
/// a picture 1000 px high from where it began.
[[nodiscard]] bool is_tap(const curve::Stroke& stroke, geometry::Viewport viewport);

/// The command that a stroke means. The eraser end of a pen erases whatever the tool. Errors: a stroke that the tool
/// can make nothing of, such as a target where no reference waits for one.
[[nodiscard]] base::Result<document::Command> command_of(const document::Document& document, const Tool& tool,
                                                         const document::View& view, const curve::Stroke& stroke,
                                                         bool eraser);

}  // namespace penpose::drawing
