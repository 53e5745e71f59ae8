#include "core/io/gltf/read/internal/checks/gltf_checks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text/utf8.h"
#include "core/io/gltf/read/compression/unpack_gltf.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

base::Error wrong_gltf(std::string what, std::string pointer, std::string remedy = k_export_again) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

/// Extensions that change how data is read cannot be skipped; those about looks and sounds, and those that add members
/// beside the ones that are read, can.
bool can_be_read(std::string_view name) {
  constexpr auto k_known = std::to_array<std::string_view>(
      {"KHR_mesh_quantization", "EXT_meshopt_compression", "KHR_meshopt_compression", "KHR_draco_mesh_compression",
       "KHR_animation_pointer", "KHR_xmp_json_ld", "KHR_xmp", "MSFT_lod", "VRM", "KHR_techniques_webgl",
       "KHR_technique_webgl", "KHR_interactivity", "KHR_environment_map", "EXT_mesh_features", "EXT_instance_features",
       "EXT_structural_metadata", "FB_ngon_encoding", "AGI_articulations", "CESIUM_primitive_outline"});
  constexpr auto k_harmless_beginnings = std::to_array<std::string_view>(
      {"KHR_materials_", "EXT_materials_", "KHR_lights_", "EXT_lights_", "VRMC_", "KHR_audio", "MSFT_audio",
       "KHR_texture_", "EXT_texture_", "MSFT_texture_", "MSFT_packing_", "ADOBE_materials_", "KHR_node_",
       "KHR_physics_", "KHR_collision_", "MSFT_physics_", "OMI_"});
  return std::find(k_known.begin(), k_known.end(), name) != k_known.end() ||
         std::any_of(k_harmless_beginnings.begin(), k_harmless_beginnings.end(),
                     [&](std::string_view beginning) { return name.starts_with(beginning); });
}

}  // namespace

std::optional<base::Error> check_version(const json::Json& document) {
  const json::Json* asset = json::find(document, "asset");
  const json::Json* version = asset == nullptr ? nullptr : json::find(*asset, "version");
  std::string text = "2.0";
  if (version != nullptr && version->is_string()) {
    text = version->get<std::string>();
  } else if (version != nullptr && version->is_number()) {
    text = version->dump();
  } else if (version != nullptr && !version->is_null()) {
    return wrong_gltf("a text was expected", "/asset/version");
  } else if (const json::Json* views = json::find(document, "bufferViews"); views != nullptr && views->is_object()) {
    text = "1.0";
  }
  if (text.starts_with("2.") || text == "2") return std::nullopt;
  return wrong_gltf("glTF version \"" + base::valid_utf8(text) + "\" is not supported", "/asset/version",
                    "export the file as glTF 2.0");
}

std::optional<base::Error> check_tree(const json::Json& vetted) {
  const json::Json* nodes = json::find(vetted, "nodes");
  if (nodes == nullptr) return std::nullopt;
  std::vector<std::size_t> parent(nodes->size(), nodes->size());
  for (std::size_t i = 0; i < nodes->size(); ++i) {
    const json::Json* children = json::find((*nodes)[i], "children");
    for (std::size_t k = 0; children != nullptr && k < children->size(); ++k) {
      const auto node = (*children)[k].get<std::size_t>();
      if (parent[node] != nodes->size()) {
        return wrong_gltf("node " + std::to_string(node) + " is a child twice",
                          json::child(json::child(json::child("/nodes", i), "children"), k),
                          "a node may have one parent; export the file again");
      }
      parent[node] = i;
    }
  }
  // 0: not seen, 1: on the way up from here, 2: known to end.
  std::vector<std::uint8_t> state(nodes->size(), 0);
  std::vector<std::size_t> way;
  for (std::size_t i = 0; i < nodes->size(); ++i) {
    way.clear();
    std::size_t at = i;
    for (; at != nodes->size() && state[at] == 0; at = parent[at]) {
      state[at] = 1;
      way.push_back(at);
    }
    if (at != nodes->size() && state[at] == 1) {
      return wrong_gltf("the node is its own ancestor", json::child("/nodes", at),
                        "nodes have to form trees; export the file again");
    }
    for (const std::size_t node : way) state[node] = 2;
  }
  return std::nullopt;
}

std::optional<base::Error> check_indices(const json::Json& vetted, const json::Json& document) {
  const json::Json* meshes = json::find(vetted, "meshes");
  for (std::size_t m = 0; meshes != nullptr && m < meshes->size(); ++m) {
    const json::Json& primitives = (*meshes)[m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const json::Json* indices = json::find(primitives[p], "indices");
      if (indices == nullptr || draco_of(document["meshes"][m]["primitives"][p]) != nullptr) continue;
      const auto accessor = indices->get<std::size_t>();
      if (json::find(vetted["accessors"][accessor], "bufferView") == nullptr) {
        return wrong_gltf("indices without a buffer view", json::child("/accessors", accessor));
      }
    }
  }
  return std::nullopt;
}

std::optional<base::Error> check_samplers(const json::Json& vetted) {
  const json::Json* animations = json::find(vetted, "animations");
  for (std::size_t a = 0; animations != nullptr && a < animations->size(); ++a) {
    const json::Json& animation = (*animations)[a];
    for (std::size_t c = 0; c < animation["channels"].size(); ++c) {
      if (animation["channels"][c]["sampler"].get<std::size_t>() < animation["samplers"].size()) continue;
      return wrong_gltf("the sampler does not exist",
                        json::child(json::child(json::child(json::child("/animations", a), "channels"), c), "sampler"));
    }
  }
  return std::nullopt;
}

std::optional<base::Error> check_extensions(const json::Json& document) {
  const json::Json* required = json::find(document, "extensionsRequired");
  if (required == nullptr) return std::nullopt;
  if (!required->is_array()) return wrong_gltf("a list was expected", "/extensionsRequired");
  for (std::size_t i = 0; i < required->size(); ++i) {
    const std::string pointer = json::child("/extensionsRequired", i);
    if (!(*required)[i].is_string()) return wrong_gltf("a text was expected", pointer);
    const auto name = (*required)[i].get<std::string>();
    if (can_be_read(name)) continue;
    return wrong_gltf(
        "the extension " + base::valid_utf8(name) + ", without which the file cannot be read, is not known", pointer,
        "export the file without it");
  }
  return std::nullopt;
}

}  // namespace penpose::io
