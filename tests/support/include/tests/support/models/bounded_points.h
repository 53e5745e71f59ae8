#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/models/gltf_sample.h"

namespace penpose::tests {

/// Adds VEC3 with the bounds that glTF asks of positions; returns the accessor.
inline std::size_t add_points(GltfSample& sample, const std::vector<float>& numbers) {
  std::array<float, 3> least{numbers[0], numbers[1], numbers[2]};
  std::array<float, 3> most = least;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], numbers[i]);
    most[i % 3] = std::max(most[i % 3], numbers[i]);
  }
  const std::size_t accessor = sample.add_vec3(numbers);
  sample.json["accessors"][accessor]["min"] = least;
  sample.json["accessors"][accessor]["max"] = most;
  return accessor;
}

}  // namespace penpose::tests
