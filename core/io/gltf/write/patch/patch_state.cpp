#include "core/io/gltf/write/patch/patch_state.h"

#include <algorithm>

#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {

std::size_t PatchState::target_named(const std::string& name) const {
  const auto all = morphs.all();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto* one) { return one->parameter.name == name; });
  return found == all.end() ? k_no_target : static_cast<std::size_t>(found - all.begin());
}

std::size_t PatchState::users_of(std::size_t mesh) const {
  const json::Json& nodes = builder.root["nodes"];
  return static_cast<std::size_t>(std::count_if(nodes.begin(), nodes.end(), [&](const json::Json& node) {
    const json::Json* shown = json::find(node, "mesh");
    return shown != nullptr && shown->get<std::size_t>() == mesh;
  }));
}

json::Json& own_extras_of(json::Json& object) {
  const auto member = [](json::Json& of, const char* name) -> json::Json& {
    const json::Json* found = json::find(of, name);
    if (found == nullptr || !found->is_object()) of[name] = json::Json::object();
    return of[name];
  };
  return member(member(object, "extras"), k_extras_key);
}

bool moves_weights_of(const json::Json& channel, std::size_t node) {
  const json::Json* target = json::find(channel, "target");
  const json::Json* moved = target == nullptr ? nullptr : json::find(*target, "node");
  const json::Json* path = target == nullptr ? nullptr : json::find(*target, "path");
  return moved != nullptr && path != nullptr && *path == "weights" && moved->get<std::size_t>() == node;
}

}  // namespace penpose::io
