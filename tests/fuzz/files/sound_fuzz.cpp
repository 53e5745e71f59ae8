#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/sound/peaks.h"
#include "core/sound/read/read_sound.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto sound = penpose::sound::read_sound({data, size});
  if (!sound) return 0;
  for (const float sample : sound->samples) {
    if (!(std::abs(sample) <= 1)) std::abort();
  }
  (void)penpose::sound::Peaks(*sound).between(*sound, 0, sound->duration_s());
  return 0;
}
