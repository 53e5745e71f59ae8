#include "ui/render/gl/gl_dialect.h"

#include <SDL2/SDL_video.h>
#include <array>
#include <epoxy/gl.h>

namespace penpose::render {
namespace {

constexpr std::array<GlVersion, 2> k_gl{{{SDL_GL_CONTEXT_PROFILE_CORE, 3, 1}, {SDL_GL_CONTEXT_PROFILE_ES, 3, 0}}};
constexpr std::array<GlVersion, 2> k_es{{{SDL_GL_CONTEXT_PROFILE_ES, 2, 0}, {0, 2, 1}}};

/// What 16 bits tell apart.
constexpr std::uint32_t k_short_indices = 65536;

}  // namespace

std::span<const GlVersion> versions_of(DrawWay way) { return way == DrawWay::gl ? k_gl : k_es; }

std::string needs_of(DrawWay way) {
  return way == DrawWay::gl ? "OpenGL 3.1 or OpenGL ES 3.0" : "OpenGL ES 2.0 or OpenGL 2.1";
}

base::Error less_than(DrawWay way, const std::string& why) {
  return {"the driver does not offer " + needs_of(way) + " (" + why + ")", "",
          way == DrawWay::gl ? "draw with --draw es or --draw cpu" : "draw with --draw cpu"};
}

base::Result<GlDialect> dialect_of_context(DrawWay way) {
  GlDialect dialect;
  dialect.embedded = !epoxy_is_desktop_gl();
  dialect.modern = way == DrawWay::gl;
  const int version = epoxy_gl_version();
  const int least = dialect.modern ? (dialect.embedded ? 30 : 31) : (dialect.embedded ? 20 : 21);
  // OpenGL 2.1 itself draws into windows alone.
  const bool framebuffers = dialect.embedded || version >= 30 || epoxy_has_gl_extension("GL_ARB_framebuffer_object") ||
                            epoxy_has_gl_extension("GL_EXT_framebuffer_object");
  if (version < least || !framebuffers) return less_than(way, context_name());
  if (dialect.modern || !dialect.embedded) return dialect;
  dialect.derivatives = epoxy_has_gl_extension("GL_OES_standard_derivatives");
  dialect.depth_24 = epoxy_has_gl_extension("GL_OES_depth24");
  if (!epoxy_has_gl_extension("GL_OES_element_index_uint")) dialect.most_vertices = k_short_indices;
  return dialect;
}

std::string context_name() {
  const auto text = [](unsigned what) {
    const unsigned char* found = glGetString(what);
    std::string result;
    for (; found != nullptr && *found != 0; ++found) result += static_cast<char>(*found);
    return result;
  };
  const std::string version = text(GL_VERSION);
  return (version.starts_with("OpenGL") ? "" : "OpenGL ") + version + ", " + text(GL_RENDERER);
}

}  // namespace penpose::render
