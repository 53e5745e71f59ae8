#include "core/io/gltf/write/shape_entries.h"

#include <algorithm>

namespace penpose::io {

std::pair<std::size_t, std::size_t> entries_in(const rig::BlendShape& shape, const mesh::Part& part) {
  const auto begin = shape.vertices.begin();
  const auto first = std::lower_bound(begin, shape.vertices.end(), part.first_vertex);
  const auto last = std::lower_bound(first, shape.vertices.end(), part.first_vertex + part.vertex_count);
  return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin)};
}

}  // namespace penpose::io
