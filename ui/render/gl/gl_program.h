#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "ui/render/gl/gl_dialect.h"

namespace penpose::render {

/// What a driver gets of a shader that is written in the words of shaders.h.
[[nodiscard]] std::string shader_source(const GlDialect& dialect, bool fragment, std::string_view text);

/// A linked shader program of the current context.
class GlProgram {
 public:
  /// `attributes` get locations 0, 1, ... in their order; `functions` stand before the fragment shader. Errors: what
  /// the driver's compiler says, in one line.
  static base::Result<GlProgram> make(const GlDialect& dialect, std::string_view vertex, std::string_view fragment,
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

}  // namespace penpose::render
