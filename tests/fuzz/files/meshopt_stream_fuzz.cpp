#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/gltf/read/compression/meshopt_stream.h"

// Four bytes of layout (mode, filter, stride, count; the last two in fours), then the stream.
// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose::io;
  if (size < 4) return 0;
  MeshoptLayout layout;
  layout.mode = static_cast<MeshoptMode>(data[0] % 3);
  layout.filter = static_cast<MeshoptFilter>(data[1] % 4);
  layout.stride = layout.mode == MeshoptMode::attributes ? 4U * data[2] : 2U + 2U * (data[2] % 2U);
  layout.count = 3U * data[3];
  const auto bytes = unpack_meshopt({data + 4, size - 4}, layout, 1U << 20);
  if (bytes && bytes->size() != layout.count * layout.stride) std::abort();
  return 0;
}
