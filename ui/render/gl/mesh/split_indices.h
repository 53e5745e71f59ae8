#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace penpose::render {

/// Indices that follow one another and count their vertices from one place on.
struct IndexChunk {
  std::size_t first_index = 0, index_count = 0;
  std::uint32_t first_vertex = 0;
};
/// Triangles and edges for a card whose indices tell few vertices apart.
struct SplitIndices {
  std::vector<std::uint16_t> indices;  ///< as many as there were
  std::vector<IndexChunk> chunks;      ///< all of them, one after the other
  std::vector<std::uint32_t>
      vertices;  ///< which vertex is to be sent at each place; several times where chunks share it
};

/// Triples up to `first_edge`, then pairs. Preconditions: most_vertices is 3..65536; indices are below vertex_count.
[[nodiscard]] SplitIndices split_indices(std::span<const std::uint32_t> indices, std::size_t first_edge,
                                         std::size_t vertex_count, std::uint32_t most_vertices);

}  // namespace penpose::render
