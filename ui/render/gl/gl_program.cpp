#include "ui/render/gl/gl_program.h"

#include <epoxy/gl.h>
#include <utility>

namespace penpose::render {
namespace {

constexpr std::string_view k_desktop = "#version 140\n";
constexpr std::string_view k_embedded =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

std::string first_line(std::string text) { return text.substr(0, text.find('\n')); }

base::Result<unsigned> compile(unsigned kind, std::string_view source) {
  const std::string whole = std::string(epoxy_is_desktop_gl() ? k_desktop : k_embedded) + std::string(source);
  const unsigned shader = glCreateShader(kind);
  const char* text = whole.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  int good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  return base::Error{"the graphics driver refuses a shader: " + first_line(log), context_name(), "update the driver"};
}

}  // namespace

base::Result<GlProgram> GlProgram::make(std::string_view vertex, std::string_view fragment,
                                        std::initializer_list<const char*> attributes, std::string_view functions) {
  auto first = compile(GL_VERTEX_SHADER, vertex);
  if (!first) return first.error();
  auto second = compile(GL_FRAGMENT_SHADER, std::string(functions).append(fragment));
  if (!second) {
    glDeleteShader(*first);
    return second.error();
  }
  GlProgram made;
  made.program_ = glCreateProgram();
  glAttachShader(made.program_, *first);
  glAttachShader(made.program_, *second);
  unsigned place = 0;
  for (const char* name : attributes) glBindAttribLocation(made.program_, place++, name);
  glLinkProgram(made.program_);
  glDeleteShader(*first);
  glDeleteShader(*second);
  int good = 0;
  glGetProgramiv(made.program_, GL_LINK_STATUS, &good);
  if (good != 0) return made;
  char log[1024] = "";
  glGetProgramInfoLog(made.program_, sizeof log, nullptr, log);
  return base::Error{"the graphics driver refuses a shader: " + first_line(log), context_name(), "update the driver"};
}

GlProgram::~GlProgram() {
  if (program_ != 0) glDeleteProgram(program_);
}
GlProgram::GlProgram(GlProgram&& other) noexcept : program_(std::exchange(other.program_, 0)) {}
GlProgram& GlProgram::operator=(GlProgram&& other) noexcept {
  std::swap(program_, other.program_);
  return *this;
}

void GlProgram::use() const { glUseProgram(program_); }
int GlProgram::location(const char* uniform) const { return glGetUniformLocation(program_, uniform); }
void GlProgram::set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }
void GlProgram::set(const char* uniform, float x) const { glUniform1f(location(uniform), x); }
void GlProgram::set(const char* uniform, float x, float y) const { glUniform2f(location(uniform), x, y); }
void GlProgram::set(const char* uniform, float x, float y, float z) const { glUniform3f(location(uniform), x, y, z); }
void GlProgram::set_matrix(const char* uniform, const float* matrix) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, matrix);
}

bool context_is_enough() {
  const int version = epoxy_gl_version();
  return epoxy_is_desktop_gl() ? version >= 31 : version >= 30;
}

std::string context_name() {
  const auto text = [](unsigned what) {
    const unsigned char* found = glGetString(what);
    std::string result;
    for (; found != nullptr && *found != 0; ++found) result += static_cast<char>(*found);
    return result;
  };
  return "OpenGL " + text(GL_VERSION) + ", " + text(GL_RENDERER);
}

}  // namespace penpose::render
