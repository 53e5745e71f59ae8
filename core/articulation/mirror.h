#pragma once

#include <string>
#include <string_view>

#include "core/articulation/deformer.h"
#include "core/articulation/region/canvas.h"
#include "core/articulation/sketch.h"
#include "core/articulation/surface/symmetry_plane.h"
#include "core/base/result.h"

namespace penpose::articulation {

/// The plane x = 0 or the middle of the model's box, whichever mirrors its surface better onto itself. Error: neither
/// brings the vertices within 2 % of the box's diagonal of the surface, on average.
[[nodiscard]] base::Result<SymmetryPlane> find_symmetry_plane(const Canvas& canvas);

/// The name of the other side: "_L" and "_R" (also ".L", "-l" and the like) at the end or before a separator, "Left"
/// and "Right" in any case of letters; the first that is found. A name without a side gets "_mirrored" at its end.
[[nodiscard]] std::string mirrored_name(std::string_view name);

/// The sketch for the other side: cameras and ball reflected, strokes reflected with the picture, the name and that of
/// the surface's part changed to the other side's.
[[nodiscard]] Sketch mirrored(const Sketch& sketch, const SymmetryPlane& plane);

/// The same deformer on the other side of the model, in one call: a left eyelid's makes the right eyelid's. Errors: no
/// symmetry; those of build_deformer.
[[nodiscard]] base::Result<std::shared_ptr<const Deformer>> mirror_deformer(const Deformer& deformer,
                                                                            const Canvas& canvas);

}  // namespace penpose::articulation
