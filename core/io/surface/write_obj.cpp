#include <cmath>

#include "core/base/byte_writer.h"
#include "core/base/numbers.h"
#include "core/io/model/write_model.h"
#include "core/io/surface/normals.h"

namespace penpose::io {
namespace {

/// A name on one line that reads back without blanks at its ends.
std::string one_line(std::string_view name) {
  std::string text;
  for (const char c : name) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return std::string(base::trim(text));
}

void add_vector(base::ByteWriter& file, std::string_view keyword, const glm::dvec3& v) {
  file.append(keyword);
  for (int axis = 0; axis < 3; ++axis) {
    file.append(" ");
    file.append(base::format_float(static_cast<float>(v[axis])));
  }
  file.append("\n");
}

}  // namespace

base::Result<std::vector<std::uint8_t>> write_obj(const document::Model& model) {
  const auto positions = document::posed_positions(model);
  const auto normals = smooth_normals(positions, model.mesh->triangles(), model.mesh->smoothing());
  base::ByteWriter file;
  file.append("# penpose\n");
  for (const mesh::Part& part : model.mesh->parts()) {
    const std::string name = one_line(part.name);
    if (!name.empty() || model.mesh->parts().size() > 1) file.append("o " + name + "\n");
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      add_vector(file, "v", positions[v]);
    }
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      add_vector(file, "vn", glm::dvec3(normals[v]));
    }
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      file.append("f");
      for (const std::uint32_t v : model.mesh->triangles()[t]) {
        const std::string number = std::to_string(v + 1);
        file.append(" " + number + "//" + number);
      }
      file.append("\n");
    }
  }
  return file.take();
}

}  // namespace penpose::io
