#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// What write_vrma wrote.
struct VrmaFile {
  std::vector<std::uint8_t> bytes;
  std::vector<std::string> notes;  ///< what the format has no place for, one line each
};

/// A model's first animation, or its pose where it has none, as a VRM animation (VRMC_vrm_animation 1.0): a binary glTF
/// file without a mesh that any avatar can play. The figure looks along +z and its bones have no rotation at rest, so
/// that rotations are the normalised ones of the specification ("How to transform human pose": N = W inverse(L) q
/// inverse(W)). Joints between two bones are part of the lower one's rotation. The hips also move; the eyes become the
/// gaze ("LookAt"). Weights become those of the model's expressions, 0..1, whose sum is nearest to them (least
/// squares); controls in none of these, and all controls of a model without expressions, become custom expressions of
/// their names. Bones are told by document::humanoid_of. Errors: nothing that the format holds is animated or posed,
/// more keys than can be written.
[[nodiscard]] base::Result<VrmaFile> write_vrma(const document::Model& model);

}  // namespace penpose::io
