#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/articulation/sketch.h"
#include "core/curve/bend.h"
#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"

// Commands for what a deformer's first lasso selects, and for its further targets.

namespace penpose::document {

/// What the first lasso of the deformer that was begun selects. Errors: none was begun; those of general_region.
struct TakeRegion {
  static constexpr Called k_called{"take_region", "Choose the region"};
  std::optional<articulation::Reach> reach = {};
  std::optional<std::uint32_t> piece = {};  ///< of those inside the lasso, the nearest being 0
  static auto members(auto& self) { return base::named("reach", self.reach, "piece", self.piece); }
};
Changed run(const Document&, const TakeRegion&, ApplyParts&);

/// Draws where a deformer's feature is at a value other than 0 and 1: adds a target, or replaces the one at that value.
/// Errors: a value out of its range; those of build_deformer.
struct DrawBetween {
  static constexpr Called k_called{"draw_between", "Draw another target"};
  std::string deformer;
  double value = 0.5;
  View view;
  std::vector<PxPoint> line;
  static auto members(auto& self) {
    return base::named("deformer", self.deformer, "value", self.value, "view", self.view, "line", self.line);
  }
};
Changed run(const Document&, const DrawBetween&, ApplyParts&);

struct DeleteBetween {
  static constexpr Called k_called{"delete_between", "Delete a target"};
  std::string deformer;
  double value = 0.5;
  static auto members(auto& self) { return base::named("deformer", self.deformer, "value", self.value); }
};
Changed run(const Document&, const DeleteBetween&, ApplyParts&);

/// Pulls a target of a deformer at a point: nearby points of the line follow, less with distance (curve/bend.h).
struct PullBetween {
  static constexpr Called k_called{"pull_between", "Pull at a control's target"};
  std::string deformer;
  double value = 1;  ///< 1: its own target
  View view;
  PxPoint at;
  PxPoint by;
  double reach = curve::k_usual_reach;  ///< 0: the whole line
  static auto members(auto& self) {
    return base::named("deformer", self.deformer, "value", self.value, "view", self.view, "at", self.at, "by", self.by,
                       "reach", self.reach);
  }
};
Changed run(const Document&, const PullBetween&, ApplyParts&);

using TargetCommands = std::variant<TakeRegion, DrawBetween, DeleteBetween, PullBetween>;

}  // namespace penpose::document
