#pragma once

#include <cstddef>
#include <epoxy/gl.h>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

// How numbers of vertices are sent.
namespace penpose::render {

template <typename T>
void fill(unsigned target, unsigned buffer, const std::vector<T>& data, unsigned usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

inline void fill(unsigned buffer, std::span<const glm::vec3> data) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

inline const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // what OpenGL calls a pointer is an offset here
}

}  // namespace penpose::render
