#include "core/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mesh/topology.h"

namespace penpose::mesh {
namespace {

base::Error at(std::string what, const char* kind, std::size_t index, std::string remedy) {
  return {std::move(what), std::string(kind) + " " + std::to_string(index), std::move(remedy)};
}

/// GCC 12 takes two neighbouring conversions to float and back for nothing at all (-O2, superword vectorizer); a
/// volatile number is really stored.
double rounded_to_float(double value) {
  const volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

std::optional<base::Error> check_positions(MeshSource& source) {
  for (std::size_t v = 0; v < source.positions.size(); ++v) {
    ModelPoint& p = source.positions[v];
    p = {rounded_to_float(p.x), rounded_to_float(p.y), rounded_to_float(p.z)};
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return at("the position is not a finite number", "vertex", v,
                "export the model again without NaN or infinite positions");
    }
  }
  return std::nullopt;
}

std::optional<base::Error> check_parts(MeshSource& source) {
  const auto vertices = static_cast<std::uint32_t>(source.positions.size());
  const auto triangles = static_cast<std::uint32_t>(source.triangles.size());
  if (source.parts.empty()) source.parts.push_back({"", 0, vertices, 0, triangles});
  std::uint64_t next_vertex = 0;
  std::uint64_t next_triangle = 0;
  for (std::size_t i = 0; i < source.parts.size(); ++i) {
    const Part& part = source.parts[i];
    if (part.first_vertex != next_vertex || part.first_triangle != next_triangle) {
      return at("the part does not follow the one before it", "part", i, "list parts in order without gaps");
    }
    next_vertex += part.vertex_count;
    next_triangle += part.triangle_count;
    if (next_triangle > triangles || next_vertex > vertices) break;
    for (std::size_t t = part.first_triangle; t < next_triangle; ++t) {
      for (const std::uint32_t v : source.triangles[t]) {
        if (v < part.first_vertex || v >= next_vertex) {
          return at("the triangle uses a vertex outside its mesh", "triangle", t,
                    "export the model again with valid indices");
        }
      }
    }
  }
  if (next_vertex != vertices || next_triangle != triangles) {
    return at("the parts do not cover the mesh", "part", source.parts.size() - 1, "export the model again");
  }
  return std::nullopt;
}

/// Drops triangles that repeat a vertex: they have no area and no neighbours.
std::size_t drop_degenerate(MeshSource& source) {
  const auto degenerate = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  std::vector<Triangle> kept;
  kept.reserve(source.triangles.size());
  for (Part& part : source.parts) {
    const auto first = static_cast<std::uint32_t>(kept.size());
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      if (!degenerate(source.triangles[t])) kept.push_back(source.triangles[t]);
    }
    part.first_triangle = first;
    part.triangle_count = static_cast<std::uint32_t>(kept.size()) - first;
  }
  const std::size_t dropped = source.triangles.size() - kept.size();
  source.triangles = std::move(kept);
  return dropped;
}

}  // namespace

base::Result<std::shared_ptr<const TriangleMesh>> TriangleMesh::build(MeshSource source) {
  if (source.positions.empty())
    return base::Error{"the mesh has no vertices", "", "choose a file with a triangle mesh"};
  if (source.positions.size() > 0xfffffff0U) return base::Error{"the mesh has too many vertices", "", "reduce it"};
  if (!source.normals.empty() && source.normals.size() != source.positions.size()) {
    return base::Error{"the mesh has another number of normals than of vertices", "", "export the model again"};
  }
  if (auto error = check_positions(source)) return *error;
  if (auto error = check_parts(source)) return *error;
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->dropped_triangles_ = drop_degenerate(source);
  mesh->weld_ = weld_coincident(source, extra_triangles(source.triangles, source.positions));
  mesh->smoothing_ = smoothing_groups(source, mesh->weld_);
  auto labels = label_components(source.triangles, mesh->weld_);
  mesh->components_ = std::move(labels.component);
  mesh->component_count_ = labels.count;
  for (const ModelPoint& p : source.positions) mesh->rest_box_.add(p);
  mesh->source_ = std::move(source);
  return std::shared_ptr<const TriangleMesh>(std::move(mesh));
}

const Part* TriangleMesh::find_part(std::string_view name) const {
  const auto found =
      std::find_if(source_.parts.begin(), source_.parts.end(), [&](const Part& part) { return part.name == name; });
  return found == source_.parts.end() ? nullptr : &*found;
}

}  // namespace penpose::mesh
