#pragma once

#include <memory>

#include "ui/app/sound/sound_output.h"

namespace penpose::app {

/// The system's sound, by SDL. Nothing is opened until it is asked for.
[[nodiscard]] std::unique_ptr<SoundOutput> make_sdl_sound();

}  // namespace penpose::app
