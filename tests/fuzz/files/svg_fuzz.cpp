#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/picture_lines/svg/read_svg_lines.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)penpose::io::looks_like_svg({data, size});
  const auto drawing = penpose::io::read_svg_lines({data, size});
  if (!drawing) return 0;
  for (const auto& line : drawing->lines) {
    if (line.points.size() < 2) std::abort();
    if (line.closed && !(line.points.front() == line.points.back())) std::abort();
  }
  return 0;
}
