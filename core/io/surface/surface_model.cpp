#include "core/io/surface/surface_model.h"

#include <algorithm>
#include <utility>

#include "core/io/surface/normals.h"
#include "core/mesh/topology.h"

namespace penpose::io {

base::Result<document::Model> surface_model(mesh::MeshSource source, std::vector<std::string> notes) {
  if (source.triangles.empty()) {
    return base::Error{"the file has no faces", "", "choose a file with a mesh; points and lines are no surface"};
  }
  const auto is_zero = [](const glm::vec3& n) { return n == glm::vec3(0); };
  if (std::all_of(source.normals.begin(), source.normals.end(), is_zero)) {
    source.normals.clear();
  } else {
    fill_missing_normals(source);
  }
  auto mesh = mesh::TriangleMesh::build(std::move(source));
  if (!mesh) return mesh.error();
  auto model = document::make_model(*mesh, nullptr, nullptr);
  if (!model) return model;
  model->notes = std::move(notes);
  if ((*mesh)->dropped_triangles() > 0) {
    model->notes.push_back(std::to_string((*mesh)->dropped_triangles()) + " triangles without area were left out");
  }
  if (auto note = mesh::note_of_extra_triangles(**mesh); !note.empty()) model->notes.push_back(std::move(note));
  return model;
}

}  // namespace penpose::io
