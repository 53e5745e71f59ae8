#include "ui/render/gl/mesh/mesh_buffers.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <limits>
#include <utility>

namespace penpose::render {

MeshBuffers::MeshBuffers(const GlDialect& dialect)
    : most_vertices_(dialect.most_vertices),
      short_(dialect.most_vertices < std::numeric_limits<std::uint32_t>::max()),
      array_(dialect) {
  glGenBuffers(1, &indices_);
  array_.set_indices(indices_);
  array_.unbind();
}

MeshBuffers::~MeshBuffers() {
  if (indices_ != 0) glDeleteBuffers(1, &indices_);
  for (const unsigned buffer : buffers_) glDeleteBuffers(1, &buffer);
}

MeshBuffers::MeshBuffers(MeshBuffers&& other) noexcept
    : most_vertices_(other.most_vertices_),
      short_(other.short_),
      array_(std::move(other.array_)),
      indices_(std::exchange(other.indices_, 0)),
      buffers_(std::exchange(other.buffers_, {})),
      whole_(std::move(other.whole_)),
      first_edge_(other.first_edge_),
      vertex_count_(other.vertex_count_),
      chunks_(std::move(other.chunks_)),
      vertices_(std::move(other.vertices_)) {}

unsigned MeshBuffers::add_buffer() {
  unsigned buffer = 0;
  glGenBuffers(1, &buffer);
  buffers_.push_back(buffer);
  return buffer;
}

void MeshBuffers::send_indices(std::vector<std::uint32_t> indices, std::size_t first_edge, std::size_t vertex_count) {
  first_edge_ = first_edge;
  vertex_count_ = vertex_count;
  whole_ = {};
  chunks_ = {};
  vertices_ = {};
  if (vertex_count > most_vertices_) {
    whole_ = std::move(indices);
    return split_again();
  }
  bind();
  if (short_) {
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    fill(GL_ELEMENT_ARRAY_BUFFER, indices_, std::span<const std::uint16_t>(narrow), GL_STATIC_DRAW);
  } else {
    fill(GL_ELEMENT_ARRAY_BUFFER, indices_, std::span<const std::uint32_t>(indices), GL_STATIC_DRAW);
  }
  unbind();
}

void MeshBuffers::split_again() {
  SplitIndices split = split_indices(whole_, first_edge_, vertex_count_, most_vertices_);
  chunks_ = std::move(split.chunks);
  vertices_ = std::move(split.vertices);
  bind();
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, std::span<const std::uint16_t>(split.indices), GL_DYNAMIC_DRAW);
  unbind();
}

bool MeshBuffers::replace(std::size_t first_index, std::span<const mesh::Triangle> triangles) {
  if (!chunks_.empty()) {
    auto out = whole_.begin() + static_cast<std::ptrdiff_t>(first_index);
    for (const mesh::Triangle& t : triangles) out = std::copy(t.begin(), t.end(), out);
    return true;
  }
  bind();
  if (short_) {
    std::vector<std::uint16_t> narrow;
    narrow.reserve(triangles.size() * 3);
    for (const mesh::Triangle& t : triangles) narrow.insert(narrow.end(), t.begin(), t.end());
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(first_index * sizeof(std::uint16_t)),
                    static_cast<GLsizeiptr>(narrow.size() * sizeof(std::uint16_t)), narrow.data());
  } else {
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(first_index * sizeof(std::uint32_t)),
                    static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data());
  }
  unbind();
  return false;
}

void MeshBuffers::draw(unsigned mode, std::size_t first_index, std::size_t count) const {
  if (count == 0) return;
  if (chunks_.empty()) {
    glDrawElements(mode, static_cast<GLsizei>(count), short_ ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                   offset(first_index * (short_ ? sizeof(std::uint16_t) : sizeof(std::uint32_t))));
    return;
  }
  for (const IndexChunk& chunk : chunks_) {
    const std::size_t first = std::max(first_index, chunk.first_index);
    const std::size_t end = std::min(first_index + count, chunk.first_index + chunk.index_count);
    if (first >= end) continue;
    array_.bind(chunk.first_vertex);
    glDrawElements(mode, static_cast<GLsizei>(end - first), GL_UNSIGNED_SHORT, offset(first * sizeof(std::uint16_t)));
  }
}

}  // namespace penpose::render
