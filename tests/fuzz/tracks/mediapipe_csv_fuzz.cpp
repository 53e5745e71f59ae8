#include <cstddef>
#include <cstdint>

#include "core/io/tracks/read_track.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::read_mediapipe_csv({data, size}, penpose::io::PictureSize{640, 480});
  return 0;
}
