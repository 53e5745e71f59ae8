#include "core/io/gltf/write/patch/target_writer.h"

#include <algorithm>
#include <span>

#include "core/document/source_file.h"
#include "core/geometry/rotation.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/write/shape_entries.h"
#include "core/io/surface/normals.h"

namespace penpose::io {

const TargetWriter::Turned& TargetWriter::turned_by(const rig::BlendShape& shape) {
  if (shape_ == &shape) return turned_;
  const mesh::TriangleMesh& mesh = *model_.mesh;
  if (at_rest_.empty()) at_rest_ = smooth_normals(mesh.positions(), mesh.triangles(), mesh.smoothing());
  std::vector<mesh::ModelPoint> moved(mesh.positions().begin(), mesh.positions().end());
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    moved[shape.vertices[i]] += geometry::ModelVector(shape.deltas[i]);
  }
  const auto now = smooth_normals(moved, mesh.triangles(), mesh.smoothing());
  turned_ = {};
  for (std::uint32_t v = 0; v < now.size(); ++v) {
    if (now[v] == at_rest_[v]) continue;
    turned_.vertices.push_back(v);
    const geometry::Turn turn =
        geometry::turn_between(geometry::ModelVector(at_rest_[v]), geometry::ModelVector(now[v]));
    turned_.turns.push_back(geometry::rotation_about(turn.axis, turn.angle));
  }
  shape_ = &shape;
  return turned_;
}

json::Json TargetWriter::write(const rig::BlendShape& shape, bool made, std::size_t index) {
  const mesh::Part& part = model_.mesh->parts()[index];
  const auto [first, last] = entries_in(shape, part);
  std::vector<std::uint32_t> elements;
  for (std::size_t i = first; i < last; ++i) elements.push_back(shape.vertices[i] - part.first_vertex);
  const auto deltas = std::span(shape.deltas).subspan(first, last - first);
  const bool keep_zeros =
      !made && std::any_of(deltas.begin(), deltas.end(), [](const glm::vec3& v) { return v == glm::vec3(0); });
  json::Json target = {
      {"POSITION", builder_.add_displacements(part.vertex_count, elements, flatten(deltas), keep_zeros, true)}};
  const document::SourceFile::Part& from = model_.source->parts[index];
  const auto& attributes = document_.model.meshes[from.mesh].primitives[from.primitives.front()].attributes;
  const bool normals = attributes.contains("NORMAL");
  if (!made) {
    if (!normals || shape.normal_deltas.empty()) return target;
    const auto own = std::span(shape.normal_deltas).subspan(first, last - first);
    target["NORMAL"] = builder_.add_displacements(part.vertex_count, elements, flatten(own), keep_zeros, false);
    return target;
  }
  const auto tangent = attributes.find("TANGENT");
  if (!normals && tangent == attributes.end()) return target;
  const Turned& turned = turned_by(shape);
  const auto begin = std::lower_bound(turned.vertices.begin(), turned.vertices.end(), part.first_vertex);
  const auto end = std::lower_bound(begin, turned.vertices.end(), part.first_vertex + part.vertex_count);
  std::vector<std::uint32_t> changed;
  for (auto v = begin; v != end; ++v) changed.push_back(*v - part.first_vertex);
  const auto turn_of = [&](std::size_t i) {
    return turned.turns[static_cast<std::size_t>(begin - turned.vertices.begin()) + i];
  };
  std::vector<float> moves;
  const auto add = [&](std::size_t i, const glm::dvec3& direction) {
    const glm::dvec3 move = turn_of(i) * direction - direction;
    for (int axis = 0; axis < 3; ++axis) moves.push_back(static_cast<float>(move[axis]));
  };
  if (normals && !model_.mesh->file_normals().empty()) {
    for (std::size_t i = 0; i < changed.size(); ++i) {
      add(i, glm::dvec3(model_.mesh->file_normals()[part.first_vertex + changed[i]]));
    }
    target["NORMAL"] = builder_.add_displacements(part.vertex_count, changed, moves, false, false);
  }
  if (tangent != attributes.end()) {
    const auto tangents =
        read_elements(document_, tangent->second, {.type = TINYGLTF_TYPE_VEC4, .count = part.vertex_count});
    if (!tangents) return target;
    const std::vector<float> numbers = tangents->dense();
    moves.clear();
    for (std::size_t i = 0; i < changed.size(); ++i) {
      const float* t = &numbers[std::size_t{4} * changed[i]];
      add(i, glm::dvec3(t[0], t[1], t[2]));
    }
    target["TANGENT"] = builder_.add_displacements(part.vertex_count, changed, moves, false, false);
  }
  return target;
}

}  // namespace penpose::io
