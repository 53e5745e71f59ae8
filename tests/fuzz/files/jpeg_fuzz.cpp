#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/picture/jpeg.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;
  const auto image = picture::decode_jpeg({data, size}, 256);
  if (!image) return 0;
  if (image->pixels.size() != std::size_t(image->width) * std::size_t(image->height) * 4) std::abort();
  const picture::Image small = picture::shrunk(*image, 64);
  if (small.width < 1 || small.height < 1 || std::max(small.width, small.height) > 64) std::abort();
  return 0;
}
