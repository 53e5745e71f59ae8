#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/write_model.h"
#include "core/io/tracks/motion_track.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penpose;
  // Motions are glTF too.
  (void)io::read_vrma({data, size});
  (void)io::read_gltf_humanoid({data, size});
  const auto model = io::read_gltf({data, size});
  if (!model) return 0;
  // Whatever can be read can be written and is the same again.
  const auto bytes = io::write_glb(*model);
  if (!bytes) return 0;
  const auto again = io::read_gltf(*bytes);
  if (!again || document::state_hash(*again) != document::state_hash(*model)) std::abort();
  return 0;
}
