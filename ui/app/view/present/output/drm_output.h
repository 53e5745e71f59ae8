#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/app/view/present/output/drm_screens.h"
#include "ui/app/view/present/output/picture_output.h"

namespace penpose::app {

/// A screen by the kernel's display driver: memory of the card that a program writes, shown in turn, or, where `slow`
/// or the driver cannot, part by part. Errors: as open_screen_output.
[[nodiscard]] base::Result<std::unique_ptr<PictureOutput>> open_drm_output(const DrmScreen& screen, bool slow);

}  // namespace penpose::app
