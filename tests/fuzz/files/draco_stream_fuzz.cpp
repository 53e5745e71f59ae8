#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/gltf/read/compression/draco_stream.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose::io;
  constexpr std::array<DracoAttribute, 1> k_positions{{{.unique_id = 0, .component_type = 5126, .components = 3}}};
  constexpr std::array<DracoAttribute, 1> k_others{{{.unique_id = 1, .component_type = 5121, .components = 4}}};
  for (const auto& wanted : {k_positions, k_others}) {
    const auto mesh = unpack_draco({data, size}, wanted, std::uint64_t{1} << 20);
    if (!mesh) continue;
    if (mesh->corners.size() % 3 != 0 || mesh->attributes.size() != 1) std::abort();
    for (const std::uint32_t corner : mesh->corners) {
      if (corner >= mesh->points) std::abort();
    }
  }
  return 0;
}
