#include "core/io/gltf/write/patch/patch_vrm.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace penpose::io {
namespace {

constexpr std::int64_t k_most_index = 0x7fffffff;

std::optional<std::size_t> index_in(const json::Json& object, const char* name) {
  const json::Json* found = json::find(object, name);
  const auto number = found == nullptr ? std::nullopt : json::whole_number(*found, 0, k_most_index);
  return number ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
}

/// A bind with the number that its target has now; null: the target is gone.
json::Json bind_of(json::Json bind, const MeshTargets& mesh) {
  const auto was = index_in(bind, "index");
  if (!was || *was >= mesh.old_count) return bind;
  for (std::size_t c = 0; c < mesh.columns.size(); ++c) {
    if (mesh.columns[c].old != was) continue;
    if (c != *was) bind["index"] = c;
    return bind;
  }
  return nullptr;
}

json::Json* member(json::Json& object, const char* name) {
  return json::find(object, name) == nullptr ? nullptr : &object[name];
}

bool is_list(const json::Json* value) { return value != nullptr && value->is_array(); }

/// What a list says of a mesh or node is said of each of `mesh`es that came of it.
class Lists {
 public:
  explicit Lists(const std::vector<MeshTargets>& meshes) : meshes_(meshes) {}

  /// Binds of VRM 1.0, each of a node.
  void bind_nodes(json::Json& expression) const {
    json::Json* binds = member(expression, "morphTargetBinds");
    if (!is_list(binds)) return;
    json::Json made = json::Json::array();
    for (const json::Json& bind : *binds) {
      const auto node = index_in(bind, "node");
      const auto of =
          std::find_if(meshes_.begin(), meshes_.end(), [&](const auto& one) { return one.read_node == node; });
      json::Json now = of == meshes_.end() ? bind : bind_of(bind, *of);
      if (now.is_null()) continue;
      if (of != meshes_.end() && of->node != of->read_node) now["node"] = of->node;
      made.push_back(std::move(now));
    }
    *binds = std::move(made);
  }
  /// Binds of VRM 0.x, each of a mesh, wherever it is shown.
  void bind_meshes(json::Json& group) const {
    json::Json* binds = member(group, "binds");
    if (!is_list(binds)) return;
    json::Json made = json::Json::array();
    for (const json::Json& bind : *binds) {
      const auto mesh = index_in(bind, "mesh");
      // Nodes that share the mesh still are told once.
      const auto kept = std::find_if(meshes_.begin(), meshes_.end(),
                                     [&](const auto& one) { return one.mesh == mesh && one.written == mesh; });
      json::Json now = kept == meshes_.end() ? bind : bind_of(bind, *kept);
      if (!now.is_null()) made.push_back(std::move(now));
      for (const MeshTargets& one : meshes_) {
        if (one.mesh != mesh || one.written == mesh) continue;
        json::Json copy = bind_of(bind, one);
        if (copy.is_null()) continue;
        copy["mesh"] = one.written;
        made.push_back(std::move(copy));
      }
    }
    *binds = std::move(made);
  }
  /// First person of VRM 1.0.
  void annotate_nodes(json::Json& first_person) const {
    json::Json* annotations = member(first_person, "meshAnnotations");
    for (std::size_t i = 0; is_list(annotations) && i < annotations->size(); ++i) {
      const auto node = index_in((*annotations)[i], "node");
      for (const MeshTargets& one : meshes_) {
        if (one.read_node == node && one.node != one.read_node) (*annotations)[i]["node"] = one.node;
      }
    }
  }
  /// First person of VRM 0.x.
  void annotate_meshes(json::Json& first_person) const {
    json::Json* annotations = member(first_person, "meshAnnotations");
    if (!is_list(annotations)) return;
    json::Json made = *annotations;
    for (const json::Json& annotation : *annotations) {
      const auto mesh = index_in(annotation, "mesh");
      for (const MeshTargets& one : meshes_) {
        if (one.mesh != mesh || one.written == one.mesh) continue;
        json::Json copy = annotation;
        copy["mesh"] = one.written;
        made.push_back(std::move(copy));
      }
    }
    *annotations = std::move(made);
  }

 private:
  const std::vector<MeshTargets>& meshes_;
};

void patch_vrm1(json::Json& vrm, const Lists& lists) {
  if (json::Json* first_person = member(vrm, "firstPerson")) lists.annotate_nodes(*first_person);
  json::Json* expressions = member(vrm, "expressions");
  if (expressions == nullptr) return;
  for (const char* group : {"preset", "custom"}) {
    json::Json* members = member(*expressions, group);
    if (members == nullptr || !members->is_object()) continue;
    std::vector<std::string> names;
    for (const auto& [name, expression] : members->items()) names.push_back(name);
    for (const std::string& name : names) lists.bind_nodes((*members)[name.c_str()]);
  }
}

void patch_vrm0(json::Json& vrm, const Lists& lists) {
  if (json::Json* first_person = member(vrm, "firstPerson")) lists.annotate_meshes(*first_person);
  json::Json* master = member(vrm, "blendShapeMaster");
  json::Json* groups = master == nullptr ? nullptr : member(*master, "blendShapeGroups");
  for (std::size_t i = 0; is_list(groups) && i < groups->size(); ++i) lists.bind_meshes((*groups)[i]);
}

}  // namespace

void patch_vrm(PatchState& state) {
  const std::vector<MeshTargets>& meshes = state.targets.meshes();
  const bool same = std::all_of(meshes.begin(), meshes.end(), [](const auto& one) {
    return one.same_columns() && one.written == one.mesh && one.node == one.read_node;
  });
  json::Json* extensions = member(state.builder.root, "extensions");
  if (same || extensions == nullptr) return;
  const Lists lists(meshes);
  if (json::Json* vrm = member(*extensions, "VRMC_vrm")) patch_vrm1(*vrm, lists);
  if (json::Json* vrm = member(*extensions, "VRM")) patch_vrm0(*vrm, lists);
}

}  // namespace penpose::io
