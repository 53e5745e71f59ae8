#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "core/rig/blend_shapes.h"

namespace penpose::io {

/// The entries of a shape that lie in a part, as first and one past the last.
[[nodiscard]] std::pair<std::size_t, std::size_t> entries_in(const rig::BlendShape& shape, const mesh::Part& part);

/// x, y and z of each vector in turn, rounded to float.
template <typename Vector>
std::vector<float> flatten(std::span<const Vector> vectors) {
  std::vector<float> numbers;
  numbers.reserve(vectors.size() * 3);
  for (const Vector& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(v[axis]));
  }
  return numbers;
}

}  // namespace penpose::io
