#pragma once

#include <memory>

#include "ui/app/view/present/output/picture_output.h"
#include "ui/app/view/present/output/rotation.h"
#include "ui/app/view/present/presenter.h"

namespace penpose::app {

/// Draws by the processor into an output, which must outlive it. `slow`: a screen that takes long to change; only what
/// differs is put on it, at once and without smoothing it later.
[[nodiscard]] std::unique_ptr<Presenter> make_cpu_presenter(PictureOutput& output, Rotation rotation, bool slow);

}  // namespace penpose::app
