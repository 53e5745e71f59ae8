#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "ui/app/view/present/output/picture_output.h"
#include "ui/app/view/present/output/rotation.h"
#include "ui/app/view/present/presenter.h"

namespace penpose::app {

/// Microseconds of a clock that never goes back; called on the thread that draws.
using PresentClock = std::function<std::int64_t()>;

/// Draws by the processor into an output, which must outlive it. While the view moves and pictures take longer than 33
/// ms by the clock they are drawn at half the resolution, and whole as soon as the view rests (MovingDetail). `slow`: a
/// screen that takes long to change; only what differs is put on it, at once and without smoothing it later.
[[nodiscard]] std::unique_ptr<Presenter> make_cpu_presenter(PictureOutput& output, Rotation rotation, bool slow,
                                                            PresentClock clock);

}  // namespace penpose::app
