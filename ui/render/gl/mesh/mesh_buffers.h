#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "ui/render/gl/mesh/split_indices.h"
#include "ui/render/gl/vertex_array.h"
#include "ui/render/gl/vertex_data.h"

namespace penpose::render {

/// The vertices and the indices of one mesh, of the current context. Where indices tell few vertices apart, meshes of
/// more are drawn in chunks.
class MeshBuffers {
 public:
  explicit MeshBuffers(const GlDialect& dialect);
  ~MeshBuffers();
  MeshBuffers(MeshBuffers&& other) noexcept;
  MeshBuffers& operator=(MeshBuffers&&) = delete;

  /// A buffer of vertex data that lives as long as this does.
  [[nodiscard]] unsigned add_buffer();
  void set(const VertexAttribute& attribute) { array_.set(attribute); }
  void drop(unsigned place) { array_.drop(place); }

  /// Triples up to `first_edge`, then pairs. Before the data of the vertices.
  void send_indices(std::vector<std::uint32_t> indices, std::size_t first_edge, std::size_t vertex_count);
  /// Puts triangles in place of others. True: all data of vertices has to be sent again, after `split_again`.
  bool replace(std::size_t first_index, std::span<const mesh::Triangle> triangles);
  void split_again();
  /// One T a vertex.
  template <typename T>
  void send(unsigned buffer, std::span<const T> data, unsigned usage);

  void bind() const { array_.bind(); }
  void unbind() const { array_.unbind(); }
  /// Precondition: bound.
  void draw(unsigned mode, std::size_t first_index, std::size_t count) const;

 private:
  std::uint32_t most_vertices_;
  bool short_;  ///< indices have 16 bits
  VertexArray array_;
  unsigned indices_ = 0;
  std::vector<unsigned> buffers_;
  std::vector<std::uint32_t> whole_;  ///< of a mesh that is split: its indices
  std::size_t first_edge_ = 0;
  std::size_t vertex_count_ = 0;
  std::vector<IndexChunk> chunks_;       ///< empty: not split
  std::vector<std::uint32_t> vertices_;  ///< of a mesh that is split, as SplitIndices has them
};

template <typename T>
void MeshBuffers::send(unsigned buffer, std::span<const T> data, unsigned usage) {
  if (chunks_.empty() || data.empty()) return fill(GL_ARRAY_BUFFER, buffer, data, usage);
  std::vector<T> split;
  split.reserve(vertices_.size());
  for (const std::uint32_t v : vertices_) split.push_back(data[v]);
  fill(GL_ARRAY_BUFFER, buffer, std::span<const T>(split), usage);
}

}  // namespace penpose::render
