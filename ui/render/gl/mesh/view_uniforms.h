#pragma once

#include "ui/render/gl/gl_program.h"
#include "ui/render/view.h"

namespace penpose::render {

/// Takes a program into use with its uniforms of a view: those of k_place_functions.
void use_with_view(const GlProgram& program, const View& view);

}  // namespace penpose::render
