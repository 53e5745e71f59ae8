#include "core/io/surface/orientation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/io/model/model_formats.h"

namespace penpose::io {
namespace {

template <typename Vector>
Vector stood_up(Vector v, const Orientation& orientation) {
  if (orientation.left_handed) v.x = -v.x;
  return orientation.up == Up::z ? Vector(v.x, v.z, -v.y) : v;
}

}  // namespace

bool has_open_orientation(base::Bytes bytes, std::string_view file_name) {
  constexpr std::array<std::string_view, 4> k_open = {".obj", ".ply", ".off", ".stl"};
  const ModelFormat* format = format_to_read(bytes, file_name);
  return format != nullptr && std::find(k_open.begin(), k_open.end(), format->extension) != k_open.end();
}

base::Result<document::Model> oriented(const document::Model& model, const Orientation& orientation) {
  if (orientation.is_usual()) return model;
  if (!model.rig->parameters().empty()) {
    return base::Error{"a model with controls cannot be turned", "", "turn its surface before it gets them"};
  }
  const mesh::TriangleMesh& old = *model.mesh;
  mesh::MeshSource source;
  for (const auto& p : old.positions()) source.positions.push_back(stood_up(p, orientation));
  for (const auto& n : old.file_normals()) source.normals.push_back(stood_up(n, orientation));
  source.triangles.assign(old.triangles().begin(), old.triangles().end());
  if (orientation.left_handed) {
    for (mesh::Triangle& t : source.triangles) std::swap(t[1], t[2]);
  }
  source.parts.assign(old.parts().begin(), old.parts().end());
  auto mesh = mesh::TriangleMesh::build(std::move(source));
  if (!mesh) return mesh.error();
  auto turned = document::make_model(std::move(mesh).value(), nullptr, nullptr);
  if (!turned) return turned;
  turned->materials = model.materials;
  turned->look = model.look;
  turned->notes = model.notes;
  if (orientation.up == Up::z) turned->notes.emplace_back("z is up in the file: it was turned so that y is");
  if (orientation.left_handed) turned->notes.emplace_back("the file is left-handed: it was mirrored");
  return turned;
}

bool looks_as_if_z_were_up(const document::Model& model) {
  const geometry::Box& box = model.mesh->rest_box();
  // A head is a little higher than deep, a figure much more; what is flat says nothing.
  return box.maximum.z - box.minimum.z > 1.15 * (box.maximum.y - box.minimum.y);
}

}  // namespace penpose::io
