#include "core/model_io/gltf_structure.h"

#include <array>
#include <utility>

namespace penpose::model_io {
namespace {

constexpr const char* k_export_again = "the file is damaged or was written wrongly; export it again";

base::Error wrong(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), k_export_again};
}

/// Puts the member into `value` where there is one. vet_gltf has looked at its kind.
template <typename T>
void take(const Json& object, const char* name, T& value) {
  if (const Json* found = find(object, name)) value = found->get<T>();
}

template <typename Each>
base::Status for_each(const Json& object, const char* name, const std::string& pointer, const Each& each) {
  const Json* list = find(object, name);
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if (auto done = each((*list)[i], child(child(pointer, name), i)); !done) return done;
  }
  return base::Done{};
}

base::Result<tinygltf::BufferView> buffer_view(const Json& json, const std::string& pointer) {
  tinygltf::BufferView view;
  take(json, "buffer", view.buffer);
  take(json, "byteOffset", view.byteOffset);
  take(json, "byteLength", view.byteLength);
  take(json, "byteStride", view.byteStride);
  if (view.byteStride % 4 != 0) return wrong("a stride that is no multiple of 4", pointer + "/byteStride");
  return view;
}

base::Result<int> type_number(const Json& type, const std::string& pointer) {
  constexpr std::array<std::pair<const char*, int>, 7> k_types{{{"SCALAR", TINYGLTF_TYPE_SCALAR},
                                                                {"VEC2", TINYGLTF_TYPE_VEC2},
                                                                {"VEC3", TINYGLTF_TYPE_VEC3},
                                                                {"VEC4", TINYGLTF_TYPE_VEC4},
                                                                {"MAT2", TINYGLTF_TYPE_MAT2},
                                                                {"MAT3", TINYGLTF_TYPE_MAT3},
                                                                {"MAT4", TINYGLTF_TYPE_MAT4}}};
  const auto& name = type.get_ref<const std::string&>();
  for (const auto& [known, number] : k_types) {
    if (name == known) return number;
  }
  return wrong("an accessor of the unknown type \"" + name + "\"", pointer + "/type");
}

base::Result<tinygltf::Accessor> accessor(const Json& json, const std::string& pointer) {
  tinygltf::Accessor made;
  const auto type = type_number(json["type"], pointer);
  if (!type) return type.error();
  made.type = *type;
  take(json, "bufferView", made.bufferView);
  take(json, "byteOffset", made.byteOffset);
  take(json, "normalized", made.normalized);
  take(json, "componentType", made.componentType);
  take(json, "count", made.count);
  const Json* sparse = find(json, "sparse");
  if (sparse == nullptr) return made;
  made.sparse = {};
  made.sparse.isSparse = true;
  take(*sparse, "count", made.sparse.count);
  const Json& indices = (*sparse)["indices"];
  take(indices, "bufferView", made.sparse.indices.bufferView);
  take(indices, "byteOffset", made.sparse.indices.byteOffset);
  take(indices, "componentType", made.sparse.indices.componentType);
  const Json& values = (*sparse)["values"];
  take(values, "bufferView", made.sparse.values.bufferView);
  take(values, "byteOffset", made.sparse.values.byteOffset);
  return made;
}

tinygltf::Material material(const Json& json) {
  tinygltf::Material made;
  take(json, "name", made.name);
  if (const Json* look = find(json, "pbrMetallicRoughness")) {
    take(*look, "baseColorFactor", made.pbrMetallicRoughness.baseColorFactor);
    take(*look, "metallicFactor", made.pbrMetallicRoughness.metallicFactor);
    take(*look, "roughnessFactor", made.pbrMetallicRoughness.roughnessFactor);
  }
  return made;
}

tinygltf::Mesh mesh(const Json& json) {
  tinygltf::Mesh made;
  take(json, "name", made.name);
  take(json, "weights", made.weights);
  for (const Json& part : json["primitives"]) {
    tinygltf::Primitive& primitive = made.primitives.emplace_back();
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    take(part, "attributes", primitive.attributes);
    take(part, "indices", primitive.indices);
    take(part, "material", primitive.material);
    take(part, "mode", primitive.mode);
    take(part, "targets", primitive.targets);
  }
  return made;
}

tinygltf::Node node(const Json& json) {
  tinygltf::Node made;
  take(json, "name", made.name);
  take(json, "children", made.children);
  take(json, "skin", made.skin);
  take(json, "mesh", made.mesh);
  take(json, "weights", made.weights);
  take(json, "matrix", made.matrix);
  if (!made.matrix.empty()) return made;  // it stands for the three
  take(json, "translation", made.translation);
  take(json, "rotation", made.rotation);
  take(json, "scale", made.scale);
  return made;
}

tinygltf::Skin skin(const Json& json) {
  tinygltf::Skin made;
  take(json, "name", made.name);
  take(json, "joints", made.joints);
  take(json, "inverseBindMatrices", made.inverseBindMatrices);
  return made;
}

base::Result<tinygltf::Animation> animation(const Json& json, const std::string& pointer) {
  tinygltf::Animation made;
  take(json, "name", made.name);
  const auto channels =
      for_each(json, "channels", pointer, [&](const Json& part, const std::string& here) -> base::Status {
        tinygltf::AnimationChannel& channel = made.channels.emplace_back();
        take(part, "sampler", channel.sampler);
        take(part["target"], "node", channel.target_node);
        take(part["target"], "path", channel.target_path);
        if (channel.target_node < 0) return wrong("a channel that moves no node", here + "/target");
        return base::Done{};
      });
  if (!channels) return channels.error();
  for (const Json& part : json["samplers"]) {
    tinygltf::AnimationSampler& sampler = made.samplers.emplace_back();
    take(part, "input", sampler.input);
    take(part, "interpolation", sampler.interpolation);
    take(part, "output", sampler.output);
  }
  return made;
}

/// Appends what `make` makes of each item; `make` gives it, or a Result of it.
template <typename Made, typename Make>
base::Status append(const Json& root, const char* name, std::vector<Made>& list, const Make& make) {
  return for_each(root, name, "", [&](const Json& item, const std::string& pointer) -> base::Status {
    base::Result<Made> made = make(item, pointer);
    if (!made) return made.error();
    list.push_back(std::move(made).value());
    return base::Done{};
  });
}

}  // namespace

base::Result<tinygltf::Model> gltf_structure(const Json& vetted) {
  tinygltf::Model model;
  const auto plain = [](auto make) { return [make](const Json& json, const std::string&) { return make(json); }; };
  for (const auto& done :
       {append(vetted, "bufferViews", model.bufferViews, buffer_view),
        append(vetted, "accessors", model.accessors, accessor),
        append(vetted, "materials", model.materials, plain(material)),
        append(vetted, "meshes", model.meshes, plain(mesh)), append(vetted, "nodes", model.nodes, plain(node)),
        append(vetted, "skins", model.skins, plain(skin)), append(vetted, "animations", model.animations, animation)}) {
    if (!done) return done.error();
  }
  if (const Json* scenes = find(vetted, "scenes")) {
    for (const Json& one : *scenes) take(one, "nodes", model.scenes.emplace_back().nodes);
  }
  take(vetted, "scene", model.defaultScene);
  return model;
}

}  // namespace penpose::model_io
