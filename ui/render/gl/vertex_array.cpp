#include "ui/render/gl/vertex_array.h"

#include <algorithm>
#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/vertex_data.h"

namespace penpose::render {
namespace {

void point_at(const VertexAttribute& one, std::uint32_t first_vertex) {
  glBindBuffer(GL_ARRAY_BUFFER, one.buffer);
  glEnableVertexAttribArray(one.place);
  glVertexAttribPointer(one.place, one.size, one.type, one.type == GL_FLOAT ? GL_FALSE : GL_TRUE, one.stride,
                        offset(one.start + static_cast<std::size_t>(one.stride) * first_vertex));
}

}  // namespace

VertexArray::VertexArray(const GlDialect& dialect) : objects_(dialect.modern) {
  if (objects_) glGenVertexArrays(1, &name_);
}
VertexArray::~VertexArray() {
  if (name_ != 0) glDeleteVertexArrays(1, &name_);
}
VertexArray::VertexArray(VertexArray&& other) noexcept
    : objects_(other.objects_),
      name_(std::exchange(other.name_, 0)),
      indices_(other.indices_),
      attributes_(std::move(other.attributes_)),
      first_vertex_(other.first_vertex_) {}

void VertexArray::set(const VertexAttribute& attribute) {
  drop(attribute.place);
  attributes_.push_back(attribute);
  point_at(attribute, first_vertex_);
}

void VertexArray::drop(unsigned place) {
  if (objects_) glBindVertexArray(name_);
  std::erase_if(attributes_, [&](const VertexAttribute& one) { return one.place == place; });
  glDisableVertexAttribArray(place);
}

void VertexArray::set_indices(unsigned buffer) {
  if (objects_) glBindVertexArray(name_);
  indices_ = buffer;
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
}

void VertexArray::bind(std::uint32_t first_vertex) const {
  if (objects_) glBindVertexArray(name_);
  if (objects_ && first_vertex == first_vertex_) return;
  first_vertex_ = first_vertex;
  for (const VertexAttribute& one : attributes_) point_at(one, first_vertex);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
}

void VertexArray::unbind() const {
  if (objects_) {
    glBindVertexArray(0);
    return;
  }
  for (const VertexAttribute& one : attributes_) glDisableVertexAttribArray(one.place);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

}  // namespace penpose::render
