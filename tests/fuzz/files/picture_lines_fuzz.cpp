#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/io/picture_lines/trace/trace_lines.h"

// The first byte is the width, the others are px.
// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 5) return 0;
  const std::size_t width = data[0] + std::size_t{1};
  const std::size_t height = (size - 1) / 4 / width;
  const auto drawing =
      penpose::io::trace_lines({static_cast<int>(width), static_cast<int>(height), {data + 1, width * height * 4}});
  if (!drawing) return 0;
  for (const auto& line : drawing->lines) {
    if (line.points.size() < 2) std::abort();
    if (line.closed && !(line.points.front() == line.points.back())) std::abort();
    for (const auto& p : line.points) {
      const double slack = 100;
      if (!(p.x > -slack && p.y > -slack && p.x < drawing->width + slack && p.y < drawing->height + slack))
        std::abort();
    }
  }
  return 0;
}
