#pragma once

#include <cstddef>
#include <epoxy/gl.h>
#include <span>

// How numbers of vertices are sent.
namespace penpose::render {

template <typename T>
void fill(unsigned target, unsigned buffer, std::span<const T> data, unsigned usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

inline const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // what OpenGL calls a pointer is an offset here
}

}  // namespace penpose::render
