#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace penpose::render {

/// A linked shader program of the current context. Shaders are written in the words that GLSL 1.40 and GLSL ES 3.00
/// share; the version line is added here.
class GlProgram {
 public:
  /// `attributes` get locations 0, 1, ... in their order; `functions` stand before the fragment shader. Errors: what
  /// the driver's compiler says, in one line.
  static base::Result<GlProgram> make(std::string_view vertex, std::string_view fragment,
                                      std::initializer_list<const char*> attributes, std::string_view functions = {});
  GlProgram() = default;
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&& other) noexcept;

  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float x) const;
  void set(const char* uniform, float x, float y) const;
  void set(const char* uniform, float x, float y, float z) const;
  /// 16 numbers, column after column.
  void set_matrix(const char* uniform, const float* matrix) const;

 private:
  [[nodiscard]] int location(const char* uniform) const;

  unsigned program_ = 0;
};

/// True when the current context is OpenGL 3.1 or OpenGL ES 3.0 or later.
[[nodiscard]] bool context_is_enough();
/// "OpenGL ..., RENDERER" of the current context, for messages.
[[nodiscard]] std::string context_name();

}  // namespace penpose::render
