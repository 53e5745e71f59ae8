#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/curve/bend.h"
#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/commands/list/reading_commands.h"
#include "core/document/drawing/pose_curve.h"

// Commands of the curves that pose.

namespace penpose::document {

/// What solving minimises: what was meant (core/intent); the sum of distances; or that sum by the single simplex of
/// 2006.
enum class Preset : std::uint8_t { meant, exact, paper };

/// Draws a reference curve on the posed surface.
using DrawReference = Plain<DrawnLine, "draw_reference", "Draw a feature">;
Changed run(const Document&, const DrawReference&, ApplyParts&);

/// Draws (again) where a reference should go, and solves.
struct DrawTarget {
  static constexpr Called k_called{"draw_target", "Draw where it goes"};
  CurveId curve;
  View view;
  std::vector<PxPoint> line;
  std::vector<double> pressure;  ///< 0..1, one a point of the line; empty: all 1
  static auto members(auto& self) {
    return base::named("curve", self.curve, "view", self.view, "line", self.line, "pressure", self.pressure);
  }
};
Changed run(const Document&, const DrawTarget&, ApplyParts&);

/// Replaces the part of a target that a stroke runs along, and solves.
struct OversketchTarget {
  static constexpr Called k_called{"oversketch_target", "Draw over a target"};
  CurveId curve;
  View view;
  std::vector<PxPoint> line;
  static auto members(auto& self) { return base::named("curve", self.curve, "view", self.view, "line", self.line); }
};
Changed run(const Document&, const OversketchTarget&, ApplyParts&);

/// Moves a target by px of its own view, and solves.
struct DragTarget {
  static constexpr Called k_called{"drag_target", "Move a target"};
  CurveId curve;
  PxPoint by;
  static auto members(auto& self) { return base::named("curve", self.curve, "by", self.by); }
};
Changed run(const Document&, const DragTarget&, ApplyParts&);

/// Pulls a target at a point: nearby points of the line follow, less with distance (curve/bend.h); the others keep
/// their exact bits. Then solves.
struct PullTarget {
  static constexpr Called k_called{"pull_target", "Pull at a target"};
  CurveId curve;
  View view;
  PxPoint at;  ///< where it is held
  PxPoint by;
  double reach = curve::k_usual_reach;  ///< share of the line's length to either side; 0: the whole line
  static auto members(auto& self) {
    return base::named("curve", self.curve, "view", self.view, "at", self.at, "by", self.by, "reach", self.reach);
  }
};
Changed run(const Document&, const PullTarget&, ApplyParts&);

/// Draws a curve that should stay where it is now.
using DrawConstraint = Plain<DrawnLine, "draw_constraint", "Hold a line">;
Changed run(const Document&, const DrawConstraint&, ApplyParts&);

/// Pins one point of the surface where it is now.
struct Pin {
  static constexpr Called k_called{"pin", "Pin a point"};
  View view;
  PxPoint at;
  static auto members(auto& self) { return base::named("view", self.view, "at", self.at); }
};
Changed run(const Document&, const Pin&, ApplyParts&);

/// Turns a reference into a constraint where its points are now.
using KeepCurve = Plain<OfCurve, "keep_curve", "Keep a line">;
Changed run(const Document&, const KeepCurve&, ApplyParts&);

using DeleteCurve = Plain<OfCurve, "delete_curve", "Delete a line">;
Changed run(const Document&, const DeleteCurve&, ApplyParts&);

/// Deletes every curve that is seen under a stroke.
using EraseCurves = Plain<DrawnLine, "erase_curves", "Erase">;
Changed run(const Document&, const EraseCurves&, ApplyParts&);

/// Deletes all curves of the posing tool; the pose stays.
using ClearCurves = Plain<NoMembers, "clear_curves", "Clear all lines">;
Changed run(const Document&, const ClearCurves&, ApplyParts&);

/// Solves the curves that are there, from the pose as it is.
struct SolvePose {
  static constexpr Called k_called{"solve_pose", "Solve again"};
  Preset preset = Preset::meant;
  static auto members(auto& self) { return base::named("preset", self.preset); }
};
Changed run(const Document&, const SolvePose&, ApplyParts&);

struct SetPressureWeighting {
  static constexpr Called k_called{"set_pressure_weighting", "Turn pressure on or off"};
  bool on = false;
  static auto members(auto& self) { return base::named("on", self.on); }
};
Changed run(const Document&, const SetPressureWeighting&, ApplyParts&);

/// How unsteady the artist's hand is, relative to a usual one; sets how much drawn lines are doubted.
struct SetHand {
  static constexpr Called k_called{"set_hand", "How steady the hand is"};
  double unsteadiness = 1;  ///< 0.25..4
  static auto members(auto& self) { return base::named("unsteadiness", self.unsteadiness); }
};
Changed run(const Document&, const SetHand&, ApplyParts&);

/// Gives the points of a drawn curve a name in the model, as maps of tracked curves use it.
struct NameCurve {
  static constexpr Called k_called{"name_curve", "Name a line"};
  CurveId curve;
  std::string name;
  static auto members(auto& self) { return base::named("curve", self.curve, "name", self.name); }
};
Changed run(const Document&, const NameCurve&, ApplyParts&);

using DeleteNamedCurve = Plain<OfName, "delete_named_curve", "Delete a named line">;
Changed run(const Document&, const DeleteNamedCurve&, ApplyParts&);

using PosingCommands = std::variant<DrawReference, DrawTarget, OversketchTarget, DragTarget, PullTarget, DrawConstraint,
                                    Pin, KeepCurve, DeleteCurve, EraseCurves, ClearCurves, SolvePose,
                                    SetPressureWeighting, SetHand, NameCurve, DeleteNamedCurve, TakeReading>;

}  // namespace penpose::document
