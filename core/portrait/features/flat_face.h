#pragma once

#include <array>
#include <optional>

#include "core/intent/model/whole_model.h"
#include "core/portrait/surface/face_surface.h"
#include "core/portrait/surface/surface_paint.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// The features of a face whose eyes and mouth are flat: pieces that lie on its head, or painted areas. Lines run from
/// the outer to the inner end, those of lips from the right to the left; the right side is first. Sides without a brow
/// have no points.
struct FlatFace {
  std::array<FoundLine, 2> upper_lids, lower_lids, brows;
  FoundLine upper_lip, lower_lip, between_lips;
};

/// Looks at the front of a face the way a person looks at a drawing: the outlines of pieces and painted areas are its
/// lines, and the layout says which of them are eyes, brows and mouth (find_face). Eyes mirror each other, and what
/// controls shut is likelier an eye. Returns nothing where they are no face.
[[nodiscard]] std::optional<FlatFace> find_flat_face(const rig::Rig& rig, const intent::WholeModel& whole,
                                                     const FaceSurface& surface, const SurfacePaint& paint);

}  // namespace penpose::portrait
