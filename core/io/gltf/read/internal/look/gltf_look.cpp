#include "core/io/gltf/read/internal/look/gltf_look.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/read/internal/look/gltf_surfaces.h"

namespace penpose::io {
namespace {

using document::Surface;

constexpr std::size_t k_most_surfaces = 60000;

/// Which nodes turn what hangs on them inside out: an odd number of scales below zero on the way to the root.
std::vector<bool> inverting_nodes(const GltfDocument& document) {
  const auto& nodes = document.model.nodes;
  std::vector<std::size_t> parent(nodes.size(), nodes.size());
  std::vector<bool> own(nodes.size(), false);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const int child : nodes[n].children) parent[static_cast<std::size_t>(child)] = n;
    const auto transform = node_transform(document, n);
    own[n] = transform && transform->scale.x * transform->scale.y * transform->scale.z < 0;
  }
  // Nodes are few where one scales below zero, and the way up is short: a file of 64 levels at most is usual.
  std::vector<bool> inverting(nodes.size(), false);
  if (std::none_of(own.begin(), own.end(), [](bool is) { return is; })) return inverting;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    constexpr int k_most_levels = 256;
    bool odd = false;
    std::size_t at = n;
    for (int level = 0; at != nodes.size() && level < k_most_levels; ++level, at = parent[at]) odd = odd != own[at];
    inverting[n] = odd;
  }
  return inverting;
}

std::size_t surface_of_material(int material) {
  return material < 0 ? 0 : std::min(static_cast<std::size_t>(material) + 1, k_most_surfaces);
}

/// Triangles that a primitive of the vetted structure has.
std::size_t triangles_of(const GltfDocument& document, const tinygltf::Primitive& primitive, std::size_t vertex_count) {
  const std::size_t corners = primitive.indices < 0
                                  ? vertex_count
                                  : document.model.accessors[static_cast<std::size_t>(primitive.indices)].count;
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

/// Fills surface_of; tells which surfaces are seen, and whether a part has several.
bool set_surfaces(const GltfDocument& document, const GltfMeshes& meshes, document::Look& look,
                  std::set<std::size_t>& seen) {
  bool several = false;
  const auto& triangles = meshes.source.triangles;
  look.surface_of.reserve(triangles.size());
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const PartOrigin& origin = meshes.origins[i];
    const mesh::Part& part = meshes.source.parts[i];
    std::size_t at = part.first_triangle;
    const std::size_t end = at + part.triangle_count;
    const std::size_t first = surface_of_material(origin.primitive(document).material);
    for (const std::size_t p : origin.primitives) {
      const auto& primitive = document.model.meshes[origin.mesh].primitives[p];
      const std::size_t surface = surface_of_material(primitive.material);
      several = several || surface != first;
      seen.insert(surface);
      const std::size_t stop = std::min(end, at + triangles_of(document, primitive, part.vertex_count));
      for (; at < stop; ++at) {
        const mesh::Triangle& t = triangles[at];
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
          look.surface_of.push_back(static_cast<std::uint32_t>(surface));
      }
    }
  }
  return several;
}

/// Reads an attribute of all parts that have it, `n` numbers a vertex; what a part lacks is `otherwise`.
template <std::size_t n>
void read_attribute(GltfDocument& document, const GltfMeshes& meshes, const char* name,
                    const std::array<float, n>& otherwise, std::vector<std::array<float, n>>& values) {
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const auto& attributes = meshes.origins[i].primitive(document).attributes;
    const auto found = attributes.find(name);
    if (found == attributes.end()) continue;
    const mesh::Part& part = meshes.source.parts[i];
    ElementRule rule{.type = n == 2 ? TINYGLTF_TYPE_VEC2 : TINYGLTF_TYPE_VEC4, .count = part.vertex_count};
    const int type = document.model.accessors[static_cast<std::size_t>(found->second)].type;
    if (n == 4 && type == TINYGLTF_TYPE_VEC3) rule.type = type;
    const auto elements = read_elements(document, found->second, rule);
    if (!elements) {
      document.notes.push_back(std::string(name) + " is not shown: " + elements.error().what);
      return values.clear();
    }
    if (values.empty()) values.assign(meshes.source.positions.size(), otherwise);
    const std::vector<float> numbers = elements->dense();
    const std::size_t width = elements->components;
    for (std::size_t v = 0; v < elements->count; ++v) {
      for (std::size_t c = 0; c < std::min(width, n); ++c) {
        const float number = numbers[v * width + c];
        if (std::isfinite(number)) values[part.first_vertex + v][c] = number;
      }
    }
  }
}

}  // namespace

std::shared_ptr<const document::Look> read_look(GltfDocument& document, const GltfMeshes& meshes,
                                                const FileResolver& resolve) {
  auto look = std::make_shared<document::Look>();
  std::set<std::size_t> seen;
  const bool several = set_surfaces(document, meshes, *look, seen);
  look->surfaces.resize(*seen.rbegin() + 1);
  look->surfaces.front().base_color = {0.8, 0.8, 0.8, 1};
  std::set<std::size_t> inside_out;
  const std::vector<bool> inverting = inverting_nodes(document);
  for (const PartOrigin& origin : meshes.origins) {
    if (!inverting[origin.node] || document.model.nodes[origin.node].skin >= 0) continue;
    for (const std::size_t p : origin.primitives)
      inside_out.insert(surface_of_material(document.model.meshes[origin.mesh].primitives[p].material));
  }
  GltfPictures pictures(document, resolve, *look);
  bool textured = false;
  bool drawn = false;
  std::array<bool, 2> sets{};
  for (const std::size_t s : seen) {
    if (s == 0) continue;
    Surface& surface = look->surfaces[s];
    surface = read_surface(document, s - 1, pictures);
    surface.double_sided = surface.double_sided || inside_out.contains(s);
    textured = textured || surface.texture;
    drawn = drawn || surface.unlit || surface.toon;
    if (surface.texture) sets[surface.texture->coordinates] = true;
    if (!surface.toon) continue;
    for (const auto& further : {surface.toon->shade_texture, surface.toon->outline_texture}) {
      if (further) sets[further->coordinates] = true;
    }
  }
  if (std::string note = document::undrawn_note(look->undrawn); !note.empty())
    document.notes.push_back(std::move(note));
  // What is only shown takes nothing from what the rest of the file may unfold to.
  const std::size_t budget = std::exchange(document.budget, document.budget / 4);
  for (const std::size_t set : {0U, 1U}) {
    const char* name = set == 0 ? "TEXCOORD_0" : "TEXCOORD_1";
    if (sets[set]) read_attribute<2>(document, meshes, name, {0, 0}, look->coordinates[set]);
  }
  read_attribute<4>(document, meshes, "COLOR_0", {1, 1, 1, 1}, look->colors);
  document.budget = budget;
  const bool white = std::all_of(look->colors.begin(), look->colors.end(), [](const auto& c) {
    return c == std::array<float, 4>{1, 1, 1, 1};
  });
  if (white) look->colors.clear();
  if (!textured && !several && !drawn && look->colors.empty() && look->undrawn.empty()) return nullptr;
  return look;
}

std::shared_ptr<const document::Look> fitting_look(std::shared_ptr<const document::Look> look,
                                                   const mesh::TriangleMesh& mesh, std::vector<std::string>& notes) {
  if (!look) return look;
  const auto fits = [&](std::size_t size) { return size == 0 || size == mesh.vertex_count(); };
  if (look->surface_of.size() == mesh.triangle_count() && fits(look->coordinates[0].size()) &&
      fits(look->coordinates[1].size()) && fits(look->colors.size()))
    return look;
  notes.emplace_back("textures are not shown: the surface was cut");
  return nullptr;
}

}  // namespace penpose::io
