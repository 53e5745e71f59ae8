// In place of ui/render/gl where the program is built without OpenGL (PENPOSE_GL=OFF).

#include "ui/render/offscreen_ways.h"

namespace penpose::render {

std::vector<OffscreenWay> card_ways() { return {}; }

}  // namespace penpose::render
