#pragma once

#include <string>

#include "core/articulation/deformer.h"
#include "core/rig/blend_shapes.h"

namespace penpose::io {

/// A deformer as other programs see it: the morph target of its displacements at amount 1. Exact at every amount for a
/// deformer that translates without a surface; for one that rotates or slides over a surface a single target goes
/// straight where the deformer goes round, so that it agrees at amounts 0 and 1 only.
[[nodiscard]] rig::BlendShape sample_deformer(const articulation::Deformer& deformer);

/// Whether a morph target is the sample of this deformer, within `tolerance` (model units). A program that changed the
/// mesh has changed the target with it, and then the deformer's strokes no longer belong to the mesh.
[[nodiscard]] bool is_sample_of(const rig::BlendShape& target, const articulation::Deformer& deformer,
                                double tolerance);

}  // namespace penpose::io
