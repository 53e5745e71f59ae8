#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/poses/kept_pose.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto pose = penpose::poses::read_kept_pose({data, size});
  if (!pose) return 0;
  // What was read is written so that it is read again.
  const std::string text = penpose::poses::write_kept_pose(*pose);
  const auto again = penpose::poses::read_kept_pose(penpose::base::as_bytes(text));
  if (!again || again->values != pose->values || again->name != pose->name) std::abort();
  return 0;
}
