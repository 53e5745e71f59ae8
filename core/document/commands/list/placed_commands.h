#pragma once

#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"
#include "core/mesh/mesh_point.h"

// Commands that give curves and targets as points, for other programs.

namespace penpose::document {

/// Adds a curve of known points. Errors: no points, one that is not on the mesh.
struct PlaceCurve {
  static constexpr Called k_called{"place_curve", "Place a feature"};
  std::vector<mesh::MeshPoint> points;
  bool constraint = false;  ///< stays where it is now; else a reference
  static auto members(auto& self) { return base::named("points", self.points, "constraint", self.constraint); }
};
Changed run(const Document&, const PlaceCurve&, ApplyParts&);

/// Says where each point of a reference should go, and solves nothing yet. Errors: no such reference, another number of
/// points, a coordinate too large to be written to a file.
struct PlaceTarget {
  static constexpr Called k_called{"place_target", "Place a target"};
  CurveId curve;
  std::vector<geometry::ModelPoint> points;
  static auto members(auto& self) { return base::named("curve", self.curve, "points", self.points); }
};
Changed run(const Document&, const PlaceTarget&, ApplyParts&);

using PlacedCommands = std::variant<PlaceCurve, PlaceTarget>;

}  // namespace penpose::document
