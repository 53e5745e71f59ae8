#include "ui/render/appearance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "core/rig/surface_poser.h"

namespace penpose::render {
namespace {

Surface from_material(const document::Material& material) {
  const auto channel = [&](std::size_t i) {
    const double v = material.base_color[i];
    return static_cast<float>(std::isfinite(v) ? std::clamp(v, 0.0, 1.0) : 0.8);
  };
  Surface surface;
  surface.base_color = {channel(0), channel(1), channel(2), channel(3)};
  surface.roughness = static_cast<float>(std::clamp(material.roughness, 0.05, 1.0));
  surface.metallic = static_cast<float>(std::clamp(material.metallic, 0.0, 1.0)) * 0.5F;
  return surface;
}

/// Colours of the parts of a head, linear.
Surface from_kind(PartKind kind) {
  switch (kind) {
    case PartKind::eyeball:
      return {{0.86F, 0.84F, 0.81F, 1}, 0.2F, 0};
    case PartKind::eye_cover:
      return {{0.30F, 0.24F, 0.22F, 0.03F}, 0.15F, 0};
    case PartKind::lash:
      return {{0.025F, 0.018F, 0.014F, 0.6F}, 1.0F, 0};
    case PartKind::tooth:
      return {{0.72F, 0.66F, 0.54F, 1}, 0.25F, 0};
    case PartKind::gum:
      return {{0.36F, 0.12F, 0.105F, 1}, 0.35F, 0};
    case PartKind::surface:
      break;
  }
  return {};
}

constexpr std::size_t k_kinds = 6;

/// Lashes are modelled as sheets; drawn dark at the lid and fading to nothing at the tips, a sheet looks like hair.
void fade_lashes(const mesh::TriangleMesh& mesh, std::span<const geometry::ModelPoint> rest, const FaceParts& face,
                 std::vector<float>& opacity) {
  struct Range {
    double nearest = 1e300;
    double farthest = 0;
  };
  const auto away = [&](std::size_t v) {
    double least = 1e300;
    for (const Eye& eye : face.eyes) least = std::min(least, geometry::distance(rest[v], eye.center));
    return least;
  };
  const auto is_lash = [&](std::size_t v) { return face.kind_of_component[mesh.components()[v]] == PartKind::lash; };
  std::vector<Range> ranges(mesh.component_count());
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!is_lash(v)) continue;
    Range& range = ranges[mesh.components()[v]];
    range.nearest = std::min(range.nearest, away(v));
    range.farthest = std::max(range.farthest, away(v));
  }
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!is_lash(v)) continue;
    opacity.resize(rest.size(), 1.0F);
    const Range& range = ranges[mesh.components()[v]];
    const double share = (away(v) - range.nearest) / std::max(range.farthest - range.nearest, 1e-300);
    const double left = std::max(0.0, 1.0 - 1.6 * share);
    opacity[v] = static_cast<float>(left * left);
  }
}

/// The component with the most vertices: the body, whose colour says what "no colour of its own" is.
std::uint32_t largest_component(const mesh::TriangleMesh& mesh) {
  std::vector<std::size_t> sizes(mesh.component_count(), 0);
  for (const std::uint32_t c : mesh.components()) ++sizes[c];
  return static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

/// Which triangles are drawn as the file's look has them: all whose surface is more than its part's plain material.
void take_look(const document::Model& model, Appearance& appearance) {
  const auto& look = model.look;
  const mesh::TriangleMesh& mesh = *model.mesh;
  const auto known = [&](std::uint32_t s) { return s < look->surfaces.size(); };
  if (!look || look->surface_of.size() != mesh.triangle_count() ||
      !std::all_of(look->surface_of.begin(), look->surface_of.end(), known))
    return;
  for (const auto* set : {&look->coordinates[0], &look->coordinates[1]}) {
    if (!set->empty() && set->size() != mesh.vertex_count()) return;
  }
  if (!look->colors.empty() && look->colors.size() != mesh.vertex_count()) return;
  std::vector<std::vector<std::uint32_t>> triangles(look->surfaces.size());
  std::vector<std::size_t> part_of(look->surfaces.size(), 0);
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const mesh::Part& part = mesh.parts()[p];
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      const std::uint32_t s = look->surface_of[t];
      const document::Surface& surface = look->surfaces[s];
      const bool plain = !surface.texture && !surface.unlit && !surface.toon && look->colors.empty() &&
                         s == look->surface_of[part.first_triangle];
      if (plain) continue;
      if (triangles[s].empty()) part_of[s] = p;
      triangles[s].push_back(t);
    }
  }
  for (std::size_t s = 0; s < triangles.size(); ++s) {
    if (triangles[s].empty()) continue;
    LookBatch batch{static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(appearance.look_triangles.size()),
                    static_cast<std::uint32_t>(triangles[s].size())};
    if (part_of[s] < model.materials.size()) {
      const Surface plain = from_material(model.materials[part_of[s]]);
      // Pictures of roughness are not read: what says that it is polished metal mostly has one that says otherwise.
      batch.roughness = std::max(plain.roughness, 0.5F);
      batch.metallic = look->surfaces[s].texture ? 0.0F : plain.metallic;
    }
    batch.moves = model.shapes && std::any_of(triangles[s].begin(), triangles[s].end(), [&](std::uint32_t t) {
                    return !model.shapes->entries_of(mesh.triangles()[t][0]).empty();
                  });
    appearance.batches.push_back(batch);
    appearance.look_triangles.insert(appearance.look_triangles.end(), triangles[s].begin(), triangles[s].end());
  }
  if (!appearance.batches.empty()) appearance.look = look;
}

/// An eye that has an iris of its own keeps this distance from the axis: it is wet, and nothing is painted on it.
constexpr float k_no_iris = 0.7F;
/// In radii of an eyeball: what is called so and within it belongs to it.
constexpr double k_around_eye = 1.3;

/// Whether nothing in the file paints an iris on it: all of it has one colour and no picture.
bool is_blank(const document::Model& model, const Appearance& appearance, std::uint32_t component) {
  const mesh::TriangleMesh& mesh = *model.mesh;
  if (model.look && !model.look->colors.empty()) return false;
  for (const LookBatch& batch : appearance.batches) {
    const document::Surface& surface = model.look->surfaces[batch.surface];
    if (!surface.texture && !surface.toon && !surface.unlit) continue;
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
      if (mesh.components()[mesh.triangles()[appearance.look_triangles[i]][0]] == component) return false;
    }
  }
  std::optional<std::uint16_t> surface;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.components()[v] != component) continue;
    if (surface && *surface != appearance.surface_of_vertex[v]) return false;
    surface = appearance.surface_of_vertex[v];
  }
  return true;
}

/// Which vertices are of what is called an eyeball; empty: none.
std::vector<bool> vertices_called_eyes(const document::Model& model) {
  const mesh::TriangleMesh& mesh = *model.mesh;
  std::vector<bool> called;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const mesh::Part& part = mesh.parts()[p];
    std::string material;
    if (model.look && part.triangle_count > 0 && part.first_triangle < model.look->surface_of.size()) {
      const std::uint32_t s = model.look->surface_of[part.first_triangle];
      if (s < model.look->surfaces.size()) material = model.look->surfaces[s].name;
    }
    if (!names_eyeball(part.name) && !names_eyeball(material)) continue;
    called.resize(mesh.vertex_count(), false);
    std::fill_n(called.begin() + part.first_vertex, part.vertex_count, true);
  }
  return called;
}

/// How far each vertex of an eyeball is from where it looks, so that it is wet, and an iris where it has none.
void add_gaze(const document::Model& model, std::span<const geometry::ModelPoint> rest, const FaceParts& face,
              Appearance& appearance) {
  std::vector<Eye> eyes = face.eyes;
  const std::vector<bool> called = eyes.empty() ? vertices_called_eyes(model) : std::vector<bool>();
  if (!called.empty()) eyes = find_called_eyes(*model.mesh, rest, called);
  if (!called.empty() && eyes.size() != 2) return;
  const geometry::ModelVector forward =
      eyes.size() == 2 ? forward_of(eyes[0], eyes[1], rest) : geometry::ModelVector{0};
  const auto components = model.mesh->components();
  for (Eye& eye : eyes) {
    if (called.empty() && face.kind_of_component[eye.component] != PartKind::eyeball) continue;
    if (eye.gaze == geometry::ModelVector{0}) eye.gaze = forward;
    if (eye.gaze == geometry::ModelVector{0}) continue;
    const float nearest = is_blank(model, appearance, eye.component) ? 0.0F : k_no_iris;
    appearance.gaze.resize(rest.size(), 1.0F);
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const geometry::ModelVector d = rest[v] - eye.center;
      const bool is_of_it = called.empty() ? components[v] == eye.component
                                           : called[v] && geometry::length(d) < k_around_eye * eye.radius;
      if (!is_of_it) continue;
      const double along = glm::dot(d, eye.gaze);
      const double away = geometry::length(d - eye.gaze * along) / eye.radius;
      appearance.gaze[v] = along > 0 ? std::clamp(static_cast<float>(away), nearest, 1.0F) : 1.0F;
    }
  }
}

}  // namespace

Appearance make_appearance(const document::Model& model, const AppearanceOptions& options) {
  const mesh::TriangleMesh& mesh = *model.mesh;
  Appearance look;
  const std::size_t parts = mesh.parts().size();
  for (std::size_t p = 0; p < parts && p < 60000; ++p) {
    look.surfaces.push_back(p < model.materials.size() ? from_material(model.materials[p]) : Surface{});
  }
  const std::size_t first_kind = look.surfaces.size();
  for (std::size_t k = 0; k < k_kinds; ++k) look.surfaces.push_back(from_kind(static_cast<PartKind>(k)));

  std::vector<geometry::ModelPoint> rest(mesh.vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  FaceParts face;
  if (options.recognise) face = recognise_face_parts(mesh, rest);
  face.kind_of_component.resize(mesh.component_count(), PartKind::surface);
  for (const auto& [component, kind] : options.kinds) {
    if (component < face.kind_of_component.size()) face.kind_of_component[component] = kind;
  }

  look.surface_of_vertex.resize(mesh.vertex_count());
  for (std::size_t p = 0; p < parts; ++p) {
    const mesh::Part& part = mesh.parts()[p];
    const auto surface = static_cast<std::uint16_t>(std::min(p, first_kind - 1));
    std::fill_n(look.surface_of_vertex.begin() + part.first_vertex, part.vertex_count, surface);
  }
  const std::uint32_t body = largest_component(mesh);
  const auto body_vertex = static_cast<std::size_t>(
      std::find(mesh.components().begin(), mesh.components().end(), body) - mesh.components().begin());
  const Color skin = look.surfaces[look.surface_of_vertex[body_vertex]].base_color;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const PartKind kind = face.kind_of_component[mesh.components()[v]];
    const bool plain = look.surfaces[look.surface_of_vertex[v]].base_color == skin;
    if (kind != PartKind::surface && plain) {
      look.surface_of_vertex[v] = static_cast<std::uint16_t>(first_kind + static_cast<std::size_t>(kind));
    }
  }
  if (!face.eyes.empty()) fade_lashes(mesh, rest, face, look.opacity);
  take_look(model, look);
  if (options.recognise) add_gaze(model, rest, face, look);
  return look;
}

PosedMesh posed_mesh(const document::Model& model) {
  rig::SurfacePoser poser(model.rig);
  poser.update(model.pose);
  const auto positions = poser.positions();
  const auto normals = poser.normals();
  return {{positions.begin(), positions.end()}, {normals.begin(), normals.end()}};
}

Scene scene_of(const document::Model& model, const PosedMesh& posed, const Appearance& appearance) {
  Scene scene;
  scene.positions = posed.positions;
  scene.normals = posed.normals;
  scene.triangles = model.mesh->triangles();
  scene.appearance = &appearance;
  return scene;
}

}  // namespace penpose::render
