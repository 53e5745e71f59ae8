#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/sketched_deformers.h"

namespace penpose::articulation {

// Edits of a set of deformers. Each gives a new set and shares every deformer that it does not change. An index that
// does not exist and a name that is taken are errors.

/// Adds at the end.
[[nodiscard]] base::Result<SketchedDeformers::Shared> with_added(const SketchedDeformers& set,
                                                                 std::shared_ptr<const Deformer> deformer);
/// Builds deformer `index` again from another sketch: one with a redrawn curve, another mode, surface or range.
[[nodiscard]] base::Result<SketchedDeformers::Shared> with_sketch(const SketchedDeformers& set, std::size_t index,
                                                                  const Sketch& sketch, const Canvas& canvas);
[[nodiscard]] base::Result<SketchedDeformers::Shared> without(const SketchedDeformers& set, std::size_t index);
[[nodiscard]] base::Result<SketchedDeformers::Shared> with_name(const SketchedDeformers& set, std::size_t index,
                                                                std::string name);
[[nodiscard]] base::Result<SketchedDeformers::Shared> with_range(const SketchedDeformers& set, std::size_t index,
                                                                 double minimum, double maximum);
/// Moves deformer `from` to index `to`.
[[nodiscard]] base::Result<SketchedDeformers::Shared> moved(const SketchedDeformers& set, std::size_t from,
                                                            std::size_t to);
/// Adds the mirror image of deformer `index` at the end, under a name or, where that is empty, the other side's.
[[nodiscard]] base::Result<SketchedDeformers::Shared> with_mirrored(const SketchedDeformers& set, std::size_t index,
                                                                    const Canvas& canvas, const std::string& name = {});

enum class CurveRole : std::uint8_t { general, specific, reference, target };

/// The sketch with one curve redrawn under a camera. No points for the reference: it is inferred again. Error: a
/// region under another camera than the sketch's, because both regions are compared in px of one picture.
[[nodiscard]] base::Result<Sketch> redrawn(const Sketch& sketch, CurveRole role, std::vector<PxPoint> points,
                                           const geometry::CameraPose& camera);

/// The number of the deformer of that name.
[[nodiscard]] std::optional<std::size_t> find_deformer(const SketchedDeformers& set, std::string_view name);

}  // namespace penpose::articulation
