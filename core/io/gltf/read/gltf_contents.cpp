#include "core/io/gltf/read/gltf_contents.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/base/edition.h"
#include "core/base/json/json.h"
#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {
namespace {

using json::Json;

/// Read by penpose: how the shape or its look is stored, and names of poses.
constexpr std::array<std::string_view, 9> k_read{"KHR_mesh_quantization",
                                                 "KHR_draco_mesh_compression",
                                                 "EXT_meshopt_compression",
                                                 "KHR_texture_transform",
                                                 "KHR_materials_unlit",
                                                 "EXT_texture_webp",
                                                 "VRM",
                                                 "VRMC_vrm",
                                                 "VRMC_vrm_animation"};
/// Known, and nothing that posing has to do with.
constexpr std::array<std::string_view, 10> k_passed{
    "KHR_materials_", "KHR_lights_punctual", "KHR_texture_basisu",      "KHR_animation_pointer", "KHR_xmp",
    "VRMC_",          "EXT_lights_",         "EXT_mesh_gpu_instancing", "KHR_node_visibility",   "EXT_texture_avif"};

base::Bytes json_of(base::Bytes bytes) {
  if (!base::as_text(bytes).starts_with("glTF")) return bytes;
  base::ByteReader reader(bytes);
  (void)reader.take(12);
  const auto size = reader.read<std::uint32_t>();
  const auto type = reader.read<std::uint32_t>();
  constexpr std::uint32_t k_json = 0x4e4f534a;
  if (!size || !type || *type != k_json) return {};
  return reader.take(std::min<std::size_t>(*size, reader.remaining())).value_or(base::Bytes());
}

std::string text_member(const Json& object, const char* name) {
  const Json* found = json::find(object, name);
  return found != nullptr && found->is_string() ? found->get_ref<const std::string&>() : std::string();
}

std::size_t count_of(const Json& root, const char* name) {
  const Json* list = json::find(root, name);
  return list != nullptr && list->is_array() ? list->size() : 0;
}

std::string type_of(const Json& image) {
  std::string type = text_member(image, "mimeType");
  if (!type.empty()) return type;
  const std::string uri = text_member(image, "uri");
  if (uri.starts_with("data:")) return uri.substr(5, std::min(uri.find_first_of(";,"), std::size_t{60}) - 5);
  const auto ends = [&](std::string_view ending) { return uri.size() > ending.size() && uri.ends_with(ending); };
  if (ends(".png") || ends(".PNG")) return "image/png";
  if (ends(".jpg") || ends(".jpeg") || ends(".JPG")) return "image/jpeg";
  return ends(".webp") ? "image/webp" : ends(".ktx2") ? "image/ktx2" : "";
}

/// The edition of a project; 0: of a newer one, or none, and then only the model is read; or the file is no project.
std::uint32_t project_edition(const Json& root) {
  const Json* extras = json::find(root, "extras");
  const Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
  if (own == nullptr || json::find(*own, "project") == nullptr) return 0;
  const Json* edition = json::find(*own, "edition");
  const auto number = edition == nullptr ? std::nullopt : json::whole_number(*edition, 1, base::k_edition);
  return static_cast<std::uint32_t>(number.value_or(0));
}

}  // namespace

GltfContents gltf_contents(base::Bytes bytes) {
  GltfContents contents;
  const auto root = json::parse_json(json_of(bytes));
  if (!root || !root->is_object() || json::find(*root, "asset") == nullptr) return contents;
  const std::uint32_t edition = project_edition(*root);
  contents.is_project = edition == base::k_edition;
  contents.is_older_project = edition > 0 && !contents.is_project;
  if (const Json* images = json::find(*root, "images"); images != nullptr && images->is_array()) {
    for (const Json& image : *images) {
      GltfTexture texture{text_member(image, "name"), type_of(image)};
      const std::string uri = text_member(image, "uri");
      if (texture.name.empty() && !uri.starts_with("data:")) texture.name = uri;
      contents.textures.push_back(std::move(texture));
    }
  }
  std::set<std::string> seen;
  const auto tell = [&](const std::string& name) {
    if (!seen.insert(name).second || std::find(k_read.begin(), k_read.end(), name) != k_read.end()) return;
    const bool known = std::any_of(k_passed.begin(), k_passed.end(),
                                   [&](std::string_view prefix) { return std::string_view(name).starts_with(prefix); });
    (known ? contents.passed_through : contents.not_understood).push_back(name);
  };
  for (const char* list_name : {"extensionsUsed", "extensionsRequired"}) {
    const Json* list = json::find(*root, list_name);
    for (std::size_t i = 0; list != nullptr && list->is_array() && i < list->size(); ++i) {
      if ((*list)[i].is_string()) tell((*list)[i].get_ref<const std::string&>());
    }
  }
  // Extensions of the root that the lists forget.
  if (const Json* extensions = json::find(*root, "extensions"); extensions != nullptr && extensions->is_object()) {
    for (const auto& extension : extensions->items()) tell(extension.first);
  }
  if (const std::size_t cameras = count_of(*root, "cameras"); cameras > 0) {
    contents.passed_through.push_back(std::to_string(cameras) + (cameras == 1 ? " camera" : " cameras"));
  }
  const std::size_t scenes = count_of(*root, "scenes");
  if (scenes > 1) contents.passed_through.push_back(std::to_string(scenes) + " scenes");
  return contents;
}

}  // namespace penpose::io
