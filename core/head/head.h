#pragma once

#include <array>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::head {

/// A true sphere that lids slide over. Metres.
struct Eyeball {
  geometry::ModelPoint center;
  double radius = 0;
};

/// Facts about the built-in head that a rig needs and a mesh does not say.
struct HeadLandmarks {
  Eyeball left;   ///< the character's left, +x
  Eyeball right;  ///< the mirror image of `left`
};
[[nodiscard]] HeadLandmarks head_landmarks();

/// The built-in head: metres, y up, facing +z, symmetric to the plane x = 0, at rest with open eyes and closed lips.
/// Parts: skin (one manifold, open at the neck only), and the eyes, teeth and hair. Same bits every time.
[[nodiscard]] document::Model make_head();

}  // namespace penpose::head
