#include "core/io/gltf/write/lost_content.h"

#include <string_view>
#include <vector>

#include "core/document/source_file.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/write/patch/patch_container.h"

namespace penpose::io {

std::string lost_without_source(const document::Model& model) {
  const auto opened = open_gltf(*model.source->bytes, resolver_of(*model.source));
  if (!opened) return {};
  std::vector<std::string> lost;
  const auto has = [&](const char* name) {
    const json::Json* list = json::find(opened->json, name);
    return list != nullptr && !list->empty();
  };
  const auto has_attribute = [&](std::string_view prefix) {
    for (const auto& mesh : opened->model.meshes) {
      for (const auto& primitive : mesh.primitives) {
        for (const auto& [name, accessor] : primitive.attributes) {
          if (name.starts_with(prefix)) return true;
        }
      }
    }
    return false;
  };
  if (has("textures") || has("images")) lost.emplace_back("textures");
  if (has_attribute("TEXCOORD_")) lost.emplace_back("texture coordinates");
  if (has_attribute("COLOR_")) lost.emplace_back("vertex colours");
  if (has_attribute("TANGENT")) lost.emplace_back("tangents");
  if (has("cameras")) lost.emplace_back("cameras");
  if (has("extensionsUsed")) lost.emplace_back("extensions");
  std::string text;
  for (const std::string& one : lost) text += (text.empty() ? "" : ", ") + one;
  return text;
}

}  // namespace penpose::io
