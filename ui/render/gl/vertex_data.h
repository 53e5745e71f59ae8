#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <epoxy/gl.h>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ui/render/picture/color.h"

// How numbers of vertices are sent.
namespace penpose::render {

using Bytes4 = std::array<std::uint8_t, 4>;

inline std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// Square roots keep finer steps in the dark; the shader squares.
inline Bytes4 pack(const Color& c) {
  return {to_byte(std::sqrt(std::max(c.r, 0.0F))), to_byte(std::sqrt(std::max(c.g, 0.0F))),
          to_byte(std::sqrt(std::max(c.b, 0.0F))), to_byte(c.a)};
}

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
