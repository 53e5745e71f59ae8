#include "core/io/gltf/read/internal/gltf_meshes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/remedies.h"
#include "core/io/surface/normals.h"
#include "core/io/text/names.h"

namespace penpose::io {
namespace {

bool has_triangles(const tinygltf::Primitive& primitive) { return primitive.mode >= TINYGLTF_MODE_TRIANGLES; }

/// Whether a primitive gives triangles at all: some have no places of their vertices (an extension may give them), or
/// no vertices, or no corners.
bool is_surface(const GltfDocument& document, const tinygltf::Primitive& primitive) {
  const auto position = primitive.attributes.find("POSITION");
  if (!has_triangles(primitive) || position == primitive.attributes.end()) return false;
  const auto count = [&](int accessor) { return document.model.accessors[static_cast<std::size_t>(accessor)].count; };
  return count(position->second) > 0 && (primitive.indices < 0 || count(primitive.indices) > 0);
}

bool shares_vertices(const tinygltf::Primitive& a, const tinygltf::Primitive& b) {
  return a.attributes == b.attributes && a.targets == b.targets;
}

/// Finds the parts of a mesh below one node and adds them.
void add_origins(GltfDocument& document, std::size_t node, std::size_t mesh, std::vector<PartOrigin>& origins) {
  const auto& primitives = document.model.meshes[mesh].primitives;
  const std::size_t first = origins.size();
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    if (!is_surface(document, primitives[p])) continue;
    const auto same =
        std::find_if(origins.begin() + static_cast<std::ptrdiff_t>(first), origins.end(),
                     [&](const auto& o) { return shares_vertices(primitives[o.primitives.front()], primitives[p]); });
    if (same == origins.end()) {
      origins.push_back({node, mesh, {p}});
    } else {
      same->primitives.push_back(p);
    }
  }
}

std::vector<PartOrigin> find_origins(GltfDocument& document, const NodeTree& tree) {
  const auto& nodes = document.model.nodes;
  std::vector<std::vector<std::size_t>> users(document.model.meshes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!tree.in_scene[n] || nodes[n].mesh < 0) continue;
    users[place_of_mesh(document, static_cast<std::size_t>(nodes[n].mesh))].push_back(n);
  }
  std::vector<PartOrigin> origins;
  for (const auto& of_mesh : users) {
    for (const std::size_t node : of_mesh) {
      add_origins(document, node, static_cast<std::size_t>(nodes[node].mesh), origins);
    }
  }
  return origins;
}

std::vector<std::string> part_names(const GltfDocument& document, const std::vector<PartOrigin>& origins) {
  std::vector<std::set<std::size_t>> users(document.model.meshes.size());
  for (const PartOrigin& origin : origins) users[place_of_mesh(document, origin.mesh)].insert(origin.node);
  std::vector<std::string> names;
  for (const PartOrigin& origin : origins) {
    const std::string& mesh = document.model.meshes[origin.mesh].name;
    const std::string& node = document.model.nodes[origin.node].name;
    const bool by_node = mesh.empty() || (users[place_of_mesh(document, origin.mesh)].size() > 1 && !node.empty());
    names.push_back(by_node ? node : mesh);
  }
  make_unique(names);
  return names;
}

base::Status read_vertices(GltfDocument& document, const PartOrigin& origin, mesh::MeshSource& source,
                           std::vector<bool>& has_normals) {
  const auto& attributes = origin.primitive(document).attributes;
  const auto position = attributes.find("POSITION");
  const auto positions = read_elements(document, position->second, {.needs_data = true, .cost = k_cost_of_geometry});
  if (!positions) return positions.error();
  const std::vector<float> numbers = positions->dense();
  for (std::size_t v = 0; v < positions->count; ++v) {
    const geometry::ModelPoint p{numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]};
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return base::Error{"the position of vertex " + std::to_string(v) + " is not a finite number",
                         accessor_pointer(position->second),
                         "export the model again without NaN or infinite positions"};
    }
    source.positions.push_back(p);
  }
  source.normals.resize(source.positions.size(), glm::vec3(0));
  const auto normal = attributes.find("NORMAL");
  has_normals.push_back(normal != attributes.end());
  if (normal == attributes.end()) return base::Done{};
  const auto normals = read_elements(document, normal->second, {.count = positions->count});
  if (!normals) return normals.error();
  const std::vector<float> raw = normals->dense();
  const std::size_t first = source.positions.size() - positions->count;
  for (std::size_t v = 0; v < positions->count; ++v) {
    const glm::vec3 n{raw[3 * v], raw[3 * v + 1], raw[3 * v + 2]};
    const bool finite = std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z);
    source.normals[first + v] = finite ? n : glm::vec3(0);
  }
  return base::Done{};
}

/// The corner numbers of a primitive, in the order of its mode.
base::Result<std::vector<std::uint32_t>> read_corners(GltfDocument& document, const tinygltf::Primitive& primitive,
                                                      std::size_t vertex_count) {
  if (primitive.indices < 0) {
    std::vector<std::uint32_t> corners(vertex_count);
    for (std::size_t i = 0; i < vertex_count; ++i) corners[i] = static_cast<std::uint32_t>(i);
    return corners;
  }
  auto corners = read_indices(document, primitive.indices);
  if (!corners) return corners;
  for (std::size_t i = 0; i < corners->size(); ++i) {
    if ((*corners)[i] < vertex_count) continue;
    return base::Error{"index " + std::to_string(i) + " is " + std::to_string((*corners)[i]) + ", but there are " +
                           std::to_string(vertex_count) + " vertices",
                       accessor_pointer(primitive.indices), k_export_again};
  }
  return corners;
}

base::Status read_triangles(GltfDocument& document, const PartOrigin& origin, std::size_t primitive_index,
                            std::uint32_t first_vertex, mesh::MeshSource& source) {
  const tinygltf::Primitive& primitive = document.model.meshes[origin.mesh].primitives[primitive_index];
  const std::size_t vertex_count = source.positions.size() - first_vertex;
  const auto corners = read_corners(document, primitive, vertex_count);
  if (!corners) return corners.error();
  const auto& c = *corners;
  const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
    source.triangles.push_back({first_vertex + c[i], first_vertex + c[j], first_vertex + c[k]});
  };
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    if (c.size() % 3 != 0) {
      document.notes.push_back("the last " + std::to_string(c.size() % 3) + " of " + std::to_string(c.size()) +
                               " corners of /meshes/" + std::to_string(origin.mesh) + "/primitives/" +
                               std::to_string(primitive_index) + " form no triangle and were left out");
    }
    for (std::size_t i = 0; i + 2 < c.size(); i += 3) add(i, i + 1, i + 2);
  } else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    // Every second triangle of a strip runs the other way round.
    for (std::size_t i = 0; i + 2 < c.size(); ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
  } else {
    for (std::size_t i = 1; i + 1 < c.size(); ++i) add(i, i + 1, 0);
  }
  return base::Done{};
}

document::Material read_material(const GltfDocument& document, int index) {
  document::Material result;
  if (index < 0) return result;
  const tinygltf::Material& material = document.model.materials[static_cast<std::size_t>(index)];
  const auto& metallic = material.pbrMetallicRoughness;
  result.name = material.name;
  if (metallic.baseColorFactor.size() == 4) {
    for (std::size_t i = 0; i < 4; ++i) result.base_color[i] = std::clamp(metallic.baseColorFactor[i], 0.0, 1.0);
  }
  result.metallic = std::clamp(metallic.metallicFactor, 0.0, 1.0);
  result.roughness = std::clamp(metallic.roughnessFactor, 0.0, 1.0);
  return result;
}

void note_left_out(GltfDocument& document) {
  for (const auto& mesh : document.model.meshes) {
    if (std::all_of(mesh.primitives.begin(), mesh.primitives.end(), has_triangles)) continue;
    document.notes.emplace_back("points and lines are not shown");
    return;
  }
}

}  // namespace

std::size_t place_of_mesh(const GltfDocument& document, std::size_t mesh) {
  const json::Json* extras = json::find(document.json["meshes"][mesh], "extras");
  const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
  const json::Json* of = own == nullptr ? nullptr : json::find(*own, "copy_of");
  const auto last = static_cast<std::int64_t>(document.model.meshes.size()) - 1;
  const auto number = of == nullptr ? std::nullopt : json::whole_number(*of, 0, last);
  return number ? static_cast<std::size_t>(*number) : mesh;
}

std::string PartOrigin::pointer() const {
  return "/meshes/" + std::to_string(mesh) + "/primitives/" + std::to_string(primitives.front());
}

base::Result<GltfMeshes> read_meshes(GltfDocument& document, const NodeTree& tree) {
  note_left_out(document);
  GltfMeshes meshes;
  meshes.origins = find_origins(document, tree);
  if (meshes.origins.empty()) {
    if (document.model.meshes.empty() && !document.model.animations.empty()) {
      return base::Error{"the file holds motions and no mesh", "/meshes",
                         "choose the file of the figure that they move, or export both together"};
    }
    return base::Error{"there is no triangle mesh in the scene", "/meshes", "choose a file with a triangle mesh"};
  }
  const auto names = part_names(document, meshes.origins);
  std::vector<bool> has_normals;
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const PartOrigin& origin = meshes.origins[i];
    mesh::Part part{names[i], static_cast<std::uint32_t>(meshes.source.positions.size()), 0,
                    static_cast<std::uint32_t>(meshes.source.triangles.size()), 0};
    if (auto read = read_vertices(document, origin, meshes.source, has_normals); !read) return read.error();
    if (meshes.source.positions.size() > 0x7fffffffU) {
      return base::Error{"the model has too many vertices", origin.pointer(), "reduce it"};
    }
    for (const std::size_t primitive : origin.primitives) {
      if (auto read = read_triangles(document, origin, primitive, part.first_vertex, meshes.source); !read) {
        return read.error();
      }
    }
    part.vertex_count = static_cast<std::uint32_t>(meshes.source.positions.size()) - part.first_vertex;
    part.triangle_count = static_cast<std::uint32_t>(meshes.source.triangles.size()) - part.first_triangle;
    meshes.source.parts.push_back(std::move(part));
    meshes.materials.push_back(read_material(document, origin.primitive(document).material));
  }
  if (std::none_of(has_normals.begin(), has_normals.end(), [](bool has) { return has; })) {
    meshes.source.normals.clear();
  } else {
    fill_missing_normals(meshes.source);
  }
  return meshes;
}

}  // namespace penpose::io
