#pragma once

#include <array>
#include <cstdint>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::head {

/// A true sphere that lids slide over. Metres.
struct Eyeball {
  geometry::ModelPoint center;
  double radius = 0;
};

/// Parts that make up the skin, in the mesh's order; they share borders exactly, so that the mesh sees one surface.
inline constexpr std::array<const char*, 5> k_skin_parts{"skin", "lips", "brows", "lining", "lashes"};

/// Facts about the built-in head that a rig needs and a mesh does not say.
struct HeadLandmarks {
  Eyeball left;   ///< the character's left, +x
  Eyeball right;  ///< the mirror image of `left`
};
[[nodiscard]] HeadLandmarks head_landmarks();

/// The built-in head: metres, y up, facing +z, symmetric to the plane x = 0, at rest with open eyes and closed lips.
/// Parts: those of the skin (k_skin_parts; together one manifold, open at the neck only), eye, iris_rim, iris and pupil
/// of each side (_L, _R), teeth, teeth_lower, tongue and hair. Lower teeth and tongue hang on the floor of the mouth
/// and go along with a jaw. Named curves: see make_curves in core/head/curves.h. Same bits every time.
[[nodiscard]] document::Model make_head();

}  // namespace penpose::head
