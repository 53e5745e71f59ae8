#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/app/view/present/output/picture_output.h"

namespace penpose::app {

/// A screen by the kernel's frame buffer /dev/fbN, of 16, 24 or 32 bits a px; its console is silent meanwhile. Errors:
/// as open_screen_output.
[[nodiscard]] base::Result<std::unique_ptr<PictureOutput>> open_frame_buffer_output(int number);

}  // namespace penpose::app
