#include "ui/render/gl/mesh/split_indices.h"

#include <gtest/gtest.h>
#include <random>

namespace penpose::render {
namespace {

TEST(SplitIndices, EveryChunkNamesTheSameVerticesWithFewNumbers) {
  std::mt19937 numbers(7);
  constexpr std::size_t k_vertices = 500;
  constexpr std::size_t k_first_edge = 3 * 400;
  std::vector<std::uint32_t> indices(k_first_edge + 2 * 300);
  for (std::uint32_t& one : indices) one = static_cast<std::uint32_t>(numbers() % k_vertices);
  for (const std::uint32_t most : {3U, 10U, 64U, 65536U}) {
    const SplitIndices split = split_indices(indices, k_first_edge, k_vertices, most);
    ASSERT_EQ(split.indices.size(), indices.size());
    std::size_t next = 0;
    for (const IndexChunk& chunk : split.chunks) {
      EXPECT_EQ(chunk.first_index, next) << "one after the other";
      next += chunk.index_count;
      const bool whole =
          chunk.first_index <= k_first_edge ? chunk.first_index % 3 == 0 : (chunk.first_index - k_first_edge) % 2 == 0;
      EXPECT_TRUE(whole) << "no triangle and no edge is torn";
      for (std::size_t i = chunk.first_index; i < next; ++i) {
        ASSERT_LT(split.indices[i], most);
        EXPECT_EQ(split.vertices[chunk.first_vertex + split.indices[i]], indices[i]);
      }
    }
    EXPECT_EQ(next, indices.size());
    EXPECT_EQ(split.chunks.size() == 1, most == 65536);
  }
}

}  // namespace
}  // namespace penpose::render
