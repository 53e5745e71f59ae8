#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/document/model.h"
#include "core/document/time/animation_sampling.h"

namespace penpose::io {

/// Frames between keys.
struct FbxFrames {
  double a_second = 60;
  double left = 500'000;  ///< how many more there may be in the file
  bool fewer = false;     ///< some were left out
};

/// Keys of one property as FBX has them.
struct FbxKeys {
  /// A joint's transform by angles in degrees about x, then y, then z.
  struct Local {
    glm::dvec3 translation{0}, angles{0}, scale{1};
  };
  std::vector<std::int64_t> ticks;
  std::array<std::vector<double>, 3> values;  ///< a list an axis
  bool steps = false;

  static std::int64_t ticks_of(double time_s);
  /// `turn`: the values of its parameters, radians.
  static Local at(const rig::Joint& joint, const glm::dvec3& turn);
  /// Per cent of one of `width` weights. Nothing where it has no keys.
  static FbxKeys of_weight(const document::Channel& channel, std::size_t width, std::size_t weight, FbxFrames& frames);
  /// Translation, angles or scale of a joint.
  static FbxKeys of_joint(const document::Channel& channel, FbxFrames& frames);
};

}  // namespace penpose::io
