#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "ui/render/picture/image.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;
  const auto image = render::decode_png({data, size});
  if (!image) return 0;
  // Whatever can be read can be written and is the same again.
  const auto bytes = render::encode_png(*image);
  if (!bytes) std::abort();
  const auto again = render::decode_png(*bytes);
  if (again && !(*again == *image)) std::abort();
  return 0;
}
