#pragma once

#include "ui/render/picture/image.h"

struct ImDrawData;

namespace penpose::app {

/// Draws ImGui's panels over a picture, on the processor, as its back end for OpenGL does: triangles by the middles of
/// px, textures filtered between px, each laid over what is there by its alpha. Debian's ImGui is built without its
/// back end for SDL's renderer. Reads the picture of the letters where ImGui has it, which must not change meanwhile.
void paint_panels(const ImDrawData& panels, render::Image& picture);

}  // namespace penpose::app
