#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/speech/mouth_keys.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto cues = penpose::speech::read_mouth_cues({data, size});
  if (!cues) return 0;
  const auto keys = penpose::speech::mouth_keys(cues->cues, {});
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (!(keys[i].time_s > keys[i - 1].time_s)) std::abort();
  }
  return 0;
}
