#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/picture/decode_picture.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;
  const auto image = picture::decode_picture({data, size}, 64);
  if (!image) return 0;
  if (image->width < 1 || image->height < 1 || std::max(image->width, image->height) > 64) std::abort();
  if (image->pixels.size() != std::size_t(image->width) * std::size_t(image->height) * 4) std::abort();
  return 0;
}
