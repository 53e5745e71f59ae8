#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ui/demo/pose_expression.h"

namespace {

/// A bowl of 400 vertices before the camera of most strokes, with a control that shifts it.
const penpose::document::Model& bowl() {
  static const auto model = [] {
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
    return penpose::document::make_model(penpose::mesh::TriangleMesh::build(std::move(source)).value(), nullptr,
                                         nullptr)
        .value();
  }();
  return model;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = penpose::demo::read_expressions(text);
  if (!file) return 0;
  static const auto surface = penpose::demo::rest_surface(bowl());
  for (const auto& expression : file->expressions) {
    (void)penpose::demo::problem_of_expression(bowl(), surface, expression, file->viewport).ok();
  }
  return 0;
}
