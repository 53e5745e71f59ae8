#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ui/render/gl/gl_dialect.h"

namespace penpose::render {

/// Where one attribute of vertices comes from.
struct VertexAttribute {
  unsigned place = 0;
  unsigned buffer = 0;
  int size = 0;       ///< numbers a vertex
  unsigned type = 0;  ///< GL_FLOAT or GL_UNSIGNED_BYTE; bytes are shares of 255
  int stride = 0;     ///< bytes from vertex to vertex
  std::size_t start = 0;
};

/// The attributes and the indices of vertices, of the current context: an object of it, or where there are none a list
/// that is gone through.
class VertexArray {
 public:
  explicit VertexArray(const GlDialect& dialect);
  ~VertexArray();
  VertexArray(VertexArray&& other) noexcept;
  VertexArray& operator=(VertexArray&&) = delete;

  /// Leaves it bound.
  void set(const VertexAttribute& attribute);
  void drop(unsigned place);
  void set_indices(unsigned buffer);
  /// Vertices are counted from that one on.
  void bind(std::uint32_t first_vertex = 0) const;
  void unbind() const;

 private:
  bool objects_;
  unsigned name_ = 0;
  unsigned indices_ = 0;
  std::vector<VertexAttribute> attributes_;
  mutable std::uint32_t first_vertex_ = 0;  ///< from which the object counts
};

}  // namespace penpose::render
