#pragma once

#include <memory>
#include <vector>

#include "ui/render/renderer.h"

namespace penpose::render {

/// A way to draw that needs more than the processor.
struct OffscreenWay {
  DrawWay way = DrawWay::gl;
  base::Result<std::unique_ptr<Renderer>> (*make)() = nullptr;
};
/// Those that this program was built with (PENPOSE_GL), the best first.
[[nodiscard]] std::vector<OffscreenWay> card_ways();

}  // namespace penpose::render
