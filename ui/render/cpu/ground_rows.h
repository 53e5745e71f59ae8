#pragma once

#include "ui/render/light/ground_view.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// Lays the shade on the ground over a backdrop (GroundPass of ui/render/gl).
void draw_ground(const BakedLight& light, const View& view, Image& backdrop);

}  // namespace penpose::render
