#include "ui/render/gl/mesh/split_indices.h"

#include <algorithm>

namespace penpose::render {

SplitIndices split_indices(std::span<const std::uint32_t> indices, std::size_t first_edge, std::size_t vertex_count,
                           std::uint32_t most_vertices) {
  constexpr std::uint32_t k_unknown = 0xffffffff;
  SplitIndices made;
  made.indices.reserve(indices.size());
  std::vector<std::uint32_t> place(vertex_count, k_unknown);  // among the vertices that are sent
  IndexChunk chunk;
  const auto known = [&](std::uint32_t v) { return place[v] != k_unknown && place[v] >= chunk.first_vertex; };
  for (std::size_t i = 0; i < indices.size();) {
    const auto corners = indices.subspan(i, i < first_edge ? 3 : 2);
    const auto more = std::count_if(corners.begin(), corners.end(), [&](std::uint32_t v) { return !known(v); });
    if (made.vertices.size() - chunk.first_vertex + static_cast<std::size_t>(more) > most_vertices) {
      chunk.index_count = i - chunk.first_index;
      made.chunks.push_back(chunk);
      chunk = {i, 0, static_cast<std::uint32_t>(made.vertices.size())};
    }
    for (const std::uint32_t v : corners) {
      if (!known(v)) {
        place[v] = static_cast<std::uint32_t>(made.vertices.size());
        made.vertices.push_back(v);
      }
      made.indices.push_back(static_cast<std::uint16_t>(place[v] - chunk.first_vertex));
    }
    i += corners.size();
  }
  chunk.index_count = indices.size() - chunk.first_index;
  made.chunks.push_back(chunk);
  return made;
}

}  // namespace penpose::render
