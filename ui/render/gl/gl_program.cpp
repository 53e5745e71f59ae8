#include "ui/render/gl/gl_program.h"

#include <epoxy/gl.h>
#include <utility>

namespace penpose::render {
namespace {

// What the words of shaders.h mean.
constexpr std::string_view k_modern_vertex =
    "#define from_buffer in\n#define to_fragment out\n#define VERTICES_SEE_PICTURES\n";
constexpr std::string_view k_modern_fragment =
    "#define from_vertex in\n#define sample_picture texture\n#define change_per_px(value) fwidth(value)\n"
    "const float k_least_alpha = 0.01;\nout vec4 result;\n";
constexpr std::string_view k_early_vertex = "#define from_buffer attribute\n#define to_fragment varying\n";
constexpr std::string_view k_early_fragment =
    "#define from_vertex varying\n#define sample_picture texture2D\n#define result gl_FragColor\n"
    "#define PICTURES_ARE_ENCODED\n";
// Where fragments have 10 bits alone, a sharp highlight would be none or all.
constexpr std::string_view k_early_precision =
    "#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\nconst float k_least_alpha = 0.01;\n#else\n"
    "precision mediump float;\nconst float k_least_alpha = 0.1;\n#endif\n";

std::string first_line(std::string text) { return text.substr(0, text.find('\n')); }

base::Result<unsigned> compile(unsigned kind, const std::string& whole) {
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

std::string shader_source(const GlDialect& dialect, bool fragment, std::string_view text) {
  std::string whole;
  if (dialect.modern) {
    whole = dialect.embedded ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                               "precision highp sampler2D;\n"
                             : "#version 140\n";
    whole += fragment ? k_modern_fragment : k_modern_vertex;
    return whole += text;
  }
  whole = dialect.embedded ? "#version 100\n" : "#version 120\n";
  if (!fragment) return whole.append(k_early_vertex).append(text);
  if (dialect.embedded && dialect.derivatives) whole += "#extension GL_OES_standard_derivatives : enable\n";
  whole += dialect.embedded ? k_early_precision : "const float k_least_alpha = 0.01;\n";
  whole += dialect.derivatives ? "#define change_per_px(value) fwidth(value)\n" : "#define change_per_px(value) 0.01\n";
  return whole.append(k_early_fragment).append(text);
}

base::Result<GlProgram> GlProgram::make(const GlDialect& dialect, std::string_view vertex, std::string_view fragment,
                                        std::initializer_list<const char*> attributes, std::string_view functions) {
  auto first = compile(GL_VERTEX_SHADER, shader_source(dialect, false, vertex));
  if (!first) return first.error();
  auto second = compile(GL_FRAGMENT_SHADER, shader_source(dialect, true, std::string(functions).append(fragment)));
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

}  // namespace penpose::render
