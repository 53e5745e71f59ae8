#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"

// Commands of arcs: the paths of curves over time.

namespace penpose::document {

/// Redraws the path of a point of the mesh between two moments, as it is seen in a view (time/arc.h). `line`: the path,
/// px. `shares`: when the point is at each of its points, as a share of the time, ascending from 0 to 1; empty: the
/// spacing stays as it is. Errors: no such point, moments that are not on the timeline or no frame apart, a line of
/// fewer than two points, another number of shares than of points, nothing that is free moves the point.
struct RedrawArc {
  static constexpr Called k_called{"redraw_arc", "Redraw an arc"};
  mesh::MeshPoint point;
  View view;
  double from_s = 0;
  double to_s = 0;
  std::uint32_t rate = 24;  ///< frames a second
  std::vector<geometry::PxPoint> line;
  std::vector<double> shares;
  static auto members(auto& self) {
    return base::named("point", self.point, "view", self.view, "from_s", self.from_s, "to_s", self.to_s, "rate",
                       self.rate, "line", self.line, "shares", self.shares);
  }
};
Changed run(const Document&, const RedrawArc&, ApplyParts&);

using ArcCommands = std::variant<RedrawArc>;

}  // namespace penpose::document
