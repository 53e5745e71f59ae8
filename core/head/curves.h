#pragma once

#include <vector>

#include "core/document/model.h"
#include "core/head/skin.h"

namespace penpose::head {

/// Curves that are worth having a name, glued to the skin: eyelid_upper, eyelid_lower (inner to outer corner) and brow
/// (inner to outer end) of each side (_L, _R), lip_upper, lip_lower (border of the red) and lip_upper_inner,
/// lip_lower_inner (where they meet), jaw, all from the right to the left, and nose_bridge from above.
/// `skin_triangles`: how many of the mesh's first triangles are skin. `unit`: metres in a centimetre of the half.
[[nodiscard]] std::vector<document::NamedCurve> make_curves(const Half& half, const mesh::TriangleMesh& mesh,
                                                            std::uint32_t skin_triangles, double unit);

}  // namespace penpose::head
