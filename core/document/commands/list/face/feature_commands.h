#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands that correct where the features of a face are (Model::features). A drawing of the face that is there is read
// again by them.

namespace penpose::document {

/// So many features of a model are corrected.
inline constexpr std::size_t k_most_corrected = 200;

/// Draws along a feature of the face as it is posed. Without a name it is the feature that runs there: the nearest one,
/// where no other is about as near. Errors: no line on the surface; none or several run there (place: "feature").
struct DrawFeature {
  static constexpr Called k_called{"draw_feature", "Draw along a feature"};
  View view;
  std::vector<PxPoint> line;
  std::string feature;
  static auto members(auto& self) { return base::named("view", self.view, "line", self.line, "feature", self.feature); }
};
Changed run(const Document&, const DrawFeature&, ApplyParts&);

/// Says that a line that was drawn runs along a feature: a reference, a constraint, or a line of the face as it should
/// be, which lay over the face as it was before that was drawn. The line goes. Errors: no such line; no name; the line
/// does not lie on the surface.
struct LineIsFeature {
  static constexpr Called k_called{"line_is_feature", "This is a feature"};
  CurveId curve;
  std::string feature;
  static auto members(auto& self) { return base::named("curve", self.curve, "feature", self.feature); }
};
Changed run(const Document&, const LineIsFeature&, ApplyParts&);

/// A feature runs through points of the surface; without any the face has no such feature. Errors: no name; a
/// single point; a point does not lie on the mesh; too many features are corrected.
struct PlaceFeature {
  static constexpr Called k_called{"place_feature", "Correct a feature"};
  std::string feature;
  std::vector<mesh::MeshPoint> points;
  static auto members(auto& self) { return base::named("feature", self.feature, "points", self.points); }
};
Changed run(const Document&, const PlaceFeature&, ApplyParts&);

/// Takes the correction of a feature back; without a name, of all. Errors: it was not corrected.
struct FeatureAsFound {
  static constexpr Called k_called{"feature_as_found", "A feature as it was found"};
  std::string feature;
  static auto members(auto& self) { return base::named("feature", self.feature); }
};
Changed run(const Document&, const FeatureAsFound&, ApplyParts&);

using FeatureCommands = std::variant<DrawFeature, LineIsFeature, PlaceFeature, FeatureAsFound>;

}  // namespace penpose::document
