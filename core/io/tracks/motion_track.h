#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/humanoid.h"
#include "core/document/model.h"

namespace penpose::io {

/// How one bone turns: what VRMC_vrm_animation ("Pose data compatibility") calls its normalized local rotation, as a
/// figure in T-pose that looks along +z and whose bones have no rotation at rest would turn it. Quaternions x y z w.
struct BoneMotion {
  document::HumanBone bone{};
  document::Channel rotations;
};

/// How far one expression is shown, 0..1, over time; one number a key.
struct ExpressionMotion {
  std::string name;
  document::Channel weights;
};

/// A motion of a human figure and its face that any figure can take.
struct MotionTrack {
  std::vector<BoneMotion> bones;                   ///< one a bone that is animated, in the order of the bones
  std::optional<document::Channel> hips = {};      ///< where the hips are in the world, in the units of the file
  double hips_height = 0;                          ///< y of the hips at rest, in the same units
  std::vector<ExpressionMotion> expressions = {};  ///< in the order of the file
  std::optional<document::Channel> gaze = {};      ///< the turn of the eyes from straight ahead, in a head at rest
  std::vector<std::string> notes = {};             ///< what was left out, one line each
};

/// Whether a binary glTF file says that it is a VRM animation.
[[nodiscard]] bool looks_like_vrma(base::Bytes bytes);

/// A VRM animation (.vrma: glTF with the extension VRMC_vrm_animation 1.0), the first animation of the file. Rotations
/// are normalised by the rest pose of the file: N = W inverse(L) q inverse(W), with L and W the rotations of the bone's
/// node at rest, in its parent and in the world (VRMC_vrm_animation, "How to transform human pose"). Errors (place:
/// JSON pointer): those of glTF, no such extension, a version that is not 1.0, no animation, nothing that it animates.
[[nodiscard]] base::Result<MotionTrack> read_vrma(base::Bytes bytes);

}  // namespace penpose::io
