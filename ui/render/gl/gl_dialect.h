#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "core/base/result.h"
#include "ui/render/renderer.h"

namespace penpose::render {

/// A context to ask SDL for.
struct GlVersion {
  int profile = 0;  ///< SDL_GL_CONTEXT_PROFILE_MASK
  int major = 0;
  int minor = 0;
};
/// The contexts in which a way draws, in the order in which they are asked for. Precondition: not the processor.
[[nodiscard]] std::span<const GlVersion> versions_of(DrawWay way);
/// "OpenGL 3.1 or OpenGL ES 3.0": what a way needs, for messages.
[[nodiscard]] std::string needs_of(DrawWay way);
/// That the driver offers less than that, with the ways that may still draw. `why`: what it said or offers.
[[nodiscard]] base::Error less_than(DrawWay way, const std::string& why);

/// What a renderer may ask of a context, whatever else that could do.
struct GlDialect {
  /// OpenGL 3.1 and OpenGL ES 3.0: GLSL 1.40 and ES 3.00, arrays of vertices as objects, samples, textures of depth and
  /// of sRGB, blits. Otherwise what OpenGL ES 2.0 and OpenGL 2.1 share.
  bool modern = true;
  bool embedded = false;                                                    ///< OpenGL ES
  bool derivatives = true;                                                  ///< fragments know how values change a px
  bool depth_24 = true;                                                     ///< bits of depth; otherwise 16
  std::uint32_t most_vertices = std::numeric_limits<std::uint32_t>::max();  ///< that indices can tell apart
};
/// Of the context that is current. Errors: it is older than the way needs.
[[nodiscard]] base::Result<GlDialect> dialect_of_context(DrawWay way);
/// "OpenGL ..., RENDERER" of the current context, for messages.
[[nodiscard]] std::string context_name();

}  // namespace penpose::render
