#include <cstddef>
#include <cstdint>

#include "core/articulation/deformer.h"
#include "core/io/project/sketch_file.h"

namespace {

/// A bowl of 400 vertices before the camera of most sketches.
std::shared_ptr<const penpose::articulation::Canvas> bowl() {
  penpose::mesh::MeshSource source;
  for (std::uint32_t r = 0; r < 20; ++r) {
    for (std::uint32_t c = 0; c < 20; ++c) {
      const double x = c / 19.0 - 0.5;
      const double y = r / 19.0 - 0.5;
      source.positions.push_back({x, y, x * x + y * y});
      if (r == 19 || c == 19) continue;
      const std::uint32_t a = r * 20 + c;
      source.triangles.push_back({a, a + 1, a + 21});
      source.triangles.push_back({a, a + 21, a + 20});
    }
  }
  source.parts = {{"bowl", 0, 400, 0, static_cast<std::uint32_t>(source.triangles.size())}};
  return penpose::articulation::Canvas::make(penpose::mesh::TriangleMesh::build(std::move(source)).value(), nullptr)
      .value();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto canvas = bowl();
  const auto file = penpose::io::read_sketch_file({data, size});
  if (!file) return 0;
  for (const auto& sketch : file->sketches) {
    const auto deformer = penpose::articulation::build_deformer(sketch, *canvas);
    if (!deformer) continue;
    static_cast<void>((*deformer)->displacements(0.5));
  }
  (void)penpose::io::write_sketch_file(*file);
  return 0;
}
