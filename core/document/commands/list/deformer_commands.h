#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/articulation/edit.h"
#include "core/articulation/sketch.h"
#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"

// Commands of sketched deformers.

namespace penpose::document {

/// Begins a deformer, whose curves are drawn one by one.
struct BeginDeformer {
  static constexpr Called k_called{"begin_deformer", "Begin a control"};
  std::string name;  ///< empty: "deformer N" with the first free N
  articulation::Mode mode = articulation::Mode::automatic;
  articulation::Surface surface;
  double minimum = 0;
  double maximum = 1;
  static auto members(auto& self) {
    return base::named("name", self.name, "mode", self.mode, "surface", self.surface, "minimum", self.minimum,
                       "maximum", self.maximum);
  }
};
Changed run(const Document&, const BeginDeformer&, ApplyParts&);

/// Draws a curve of the deformer that was begun; the target completes it. Errors: no deformer was begun, a curve before
/// its turn, the second region under another camera than the first; with the target those of build_deformer.
struct SketchCurve {
  static constexpr Called k_called{"sketch_curve", "Sketch a line"};
  articulation::CurveRole role = articulation::CurveRole::general;
  View view;
  std::vector<PxPoint> line;
  static auto members(auto& self) { return base::named("role", self.role, "view", self.view, "line", self.line); }
};
Changed run(const Document&, const SketchCurve&, ApplyParts&);

using CancelDeformer = Plain<NoMembers, "cancel_deformer", "Cancel a new control">;
Changed run(const Document&, const CancelDeformer&, ApplyParts&);

/// Draws one curve of a deformer again; a reference without points is inferred. The parameter keeps its value.
struct RedrawCurve {
  static constexpr Called k_called{"redraw_curve", "Draw a control's line again"};
  std::string deformer;
  articulation::CurveRole role = articulation::CurveRole::target;
  View view;
  std::vector<PxPoint> line;
  static auto members(auto& self) {
    return base::named("deformer", self.deformer, "role", self.role, "view", self.view, "line", self.line);
  }
};
Changed run(const Document&, const RedrawCurve&, ApplyParts&);

/// Changes how a deformer moves, what it slides over, the sheet that its reference lies on, what its first lasso takes,
/// or its range; what is not given stays.
struct ChangeDeformer {
  static constexpr Called k_called{"change_deformer", "Change a control"};
  std::string deformer;
  std::optional<articulation::Mode> mode;
  std::optional<articulation::Surface> surface;
  std::optional<double> minimum;
  std::optional<double> maximum;
  std::optional<bool> other_sheet = {};  ///< the drawn reference goes over to the other sheet of the surface, or back
  std::optional<articulation::Reach> reach = {};
  std::optional<std::uint32_t> piece = {};
  static auto members(auto& self) {
    return base::named("deformer", self.deformer, "mode", self.mode, "surface", self.surface, "minimum", self.minimum,
                       "maximum", self.maximum, "other_sheet", self.other_sheet, "reach", self.reach, "piece",
                       self.piece);
  }
};
Changed run(const Document&, const ChangeDeformer&, ApplyParts&);

/// Adds the same deformer on the model's other side; without a name that of articulation::mirrored_name.
using MirrorDeformer = Plain<OfDeformer, "mirror_deformer", "Mirror a control">;
Changed run(const Document&, const MirrorDeformer&, ApplyParts&);

using RenameDeformer = Plain<OfDeformer, "rename_deformer", "Rename a control">;
Changed run(const Document&, const RenameDeformer&, ApplyParts&);

struct DeleteDeformer {
  static constexpr Called k_called{"delete_deformer", "Delete a control"};
  std::string deformer;
  static auto members(auto& self) { return base::named("deformer", self.deformer); }
};
Changed run(const Document&, const DeleteDeformer&, ApplyParts&);

/// Takes a deformer out of the list and puts it back as number `to`, from 0.
struct MoveDeformer {
  static constexpr Called k_called{"move_deformer", "Move a control in the list"};
  std::string deformer;
  std::uint32_t to = 0;
  static auto members(auto& self) { return base::named("deformer", self.deformer, "to", self.to); }
};
Changed run(const Document&, const MoveDeformer&, ApplyParts&);

using DeformerCommands = std::variant<BeginDeformer, SketchCurve, CancelDeformer, RedrawCurve, ChangeDeformer,
                                      MirrorDeformer, RenameDeformer, DeleteDeformer, MoveDeformer>;

}  // namespace penpose::document
