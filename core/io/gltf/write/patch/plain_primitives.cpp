#include "core/io/gltf/write/patch/plain_primitives.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/gltf/read/compression/unpack_gltf.h"

namespace penpose::io {
namespace {

constexpr const char* k_draco_extension = "KHR_draco_mesh_compression";

/// How often primitives of the written file name an accessor.
std::size_t uses_of(const json::Json& root, std::size_t accessor) {
  std::size_t uses = 0;
  const auto count = [&](const json::Json* named) {
    if (named != nullptr && named->is_number() && named->get<std::size_t>() == accessor) ++uses;
  };
  const auto count_all = [&](const json::Json* attributes) {
    if (attributes == nullptr || !attributes->is_object()) return;
    for (const auto& [name, named] : attributes->items()) count(&named);
  };
  const json::Json* meshes = json::find(root, "meshes");
  for (std::size_t m = 0; meshes != nullptr && m < meshes->size(); ++m) {
    for (const json::Json& primitive : (*meshes)[m]["primitives"]) {
      count(json::find(primitive, "indices"));
      count_all(json::find(primitive, "attributes"));
      const json::Json* targets = json::find(primitive, "targets");
      for (std::size_t t = 0; targets != nullptr && t < targets->size(); ++t) count_all(&(*targets)[t]);
    }
  }
  return uses;
}

double number_at(const std::uint8_t* bytes, int component_type) {
  const auto as = [&](auto value) {
    std::memcpy(&value, bytes, sizeof(value));
    return static_cast<double>(value);
  };
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return as(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return as(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return as(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return as(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return as(std::uint32_t{});
    default:
      return as(float{});
  }
}

/// Takes a text off a list; a list without any goes.
void take_off(json::Json& root, const char* list, std::string_view text) {
  const json::Json* found = json::find(root, list);
  if (found == nullptr || !found->is_array()) return;
  json::Json left = json::Json::array();
  for (const json::Json& one : *found) {
    if (!one.is_string() || one.get<std::string>() != text) left.push_back(one);
  }
  if (left.empty()) {
    root.erase(list);
  } else {
    root[list] = std::move(left);
  }
}

}  // namespace

void PlainPrimitives::write(std::size_t mesh, std::size_t primitive, json::Json& object) {
  if (draco_of(object) == nullptr) return;
  took_streams_ = true;
  const tinygltf::Primitive& plain = state_.document.model.meshes[mesh].primitives[primitive];
  for (const auto& [name, accessor] : plain.attributes) {
    const base::Bytes bytes = unpacked(accessor);
    if (bytes.empty()) continue;
    json::Json& named = object["attributes"][name];
    if (!written_.contains(accessor)) put(accessor, named, attribute(accessor, bytes, name == "POSITION"));
    named = written_[accessor];
  }
  const base::Bytes indices = plain.indices < 0 ? base::Bytes() : unpacked(plain.indices);
  if (!indices.empty()) {
    json::Json& named = object["indices"];
    const json::Json* type =
        !named.is_number() ? nullptr
                           : json::find(state_.builder.root["accessors"][named.get<std::size_t>()], "componentType");
    const bool wide = type != nullptr && *type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!written_.contains(plain.indices)) put(plain.indices, named, corners(indices, wide));
    named = written_[plain.indices];
  }
  // Strips have come as the triangles that they are.
  if (json::find(object, "mode") != nullptr && plain.mode == TINYGLTF_MODE_TRIANGLES) object["mode"] = 4;
  object["extensions"].erase(k_draco_extension);
  if (object["extensions"].empty()) object.erase("extensions");
}

void PlainPrimitives::forget_unused() {
  if (!took_streams_) return;
  const json::Json* meshes = json::find(state_.builder.root, "meshes");
  for (std::size_t m = 0; meshes != nullptr && m < meshes->size(); ++m) {
    for (const json::Json& primitive : (*meshes)[m]["primitives"]) {
      if (draco_of(primitive) != nullptr) return;
    }
  }
  take_off(state_.builder.root, "extensionsUsed", k_draco_extension);
  take_off(state_.builder.root, "extensionsRequired", k_draco_extension);
}

/// The tight bytes that came out of a stream; none: the file has the accessor's numbers itself.
base::Bytes PlainPrimitives::unpacked(int index) const {
  const tinygltf::Model& model = state_.document.model;
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const json::Json* views = json::find(state_.document.json, "bufferViews");
  const std::size_t of_file = views == nullptr ? 0 : views->size();
  if (accessor.bufferView < 0 || static_cast<std::size_t>(accessor.bufferView) < of_file) return {};
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  return state_.document.buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

/// Elements start at multiples of 4 bytes (glTF 2.0, section 3.6.2.4).
json::Json PlainPrimitives::attribute(int index, base::Bytes bytes, bool bounds) {
  const tinygltf::Accessor& accessor = state_.document.model.accessors[static_cast<std::size_t>(index)];
  const auto part =
      static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  const auto parts =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  const std::size_t size = part * parts;
  const std::size_t stride = (size + 3) / 4 * 4;
  const std::size_t count = bytes.size() / size;
  std::vector<std::uint8_t> padded(stride * count, 0);
  std::vector<double> least(parts);
  std::vector<double> most(parts);
  for (std::size_t i = 0; i < count; ++i) {
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(i * size), size,
                padded.begin() + static_cast<std::ptrdiff_t>(i * stride));
    for (std::size_t p = 0; p < parts; ++p) {
      const double n = number_at(bytes.data() + i * size + p * part, accessor.componentType);
      least[p] = i == 0 ? n : std::min(least[p], n);
      most[p] = i == 0 ? n : std::max(most[p], n);
    }
  }
  const std::size_t view = state_.builder.add_bytes(padded);
  json::Json& made_view = state_.builder.root["bufferViews"][view];
  made_view["target"] = 34962;
  if (stride != size) made_view["byteStride"] = stride;
  constexpr std::array<const char*, 4> k_types{"SCALAR", "VEC2", "VEC3", "VEC4"};
  json::Json made = {{"bufferView", view},
                     {"componentType", accessor.componentType},
                     {"count", count},
                     {"type", k_types[std::min<std::size_t>(parts, 4) - 1]}};
  if (accessor.normalized) made["normalized"] = true;
  if (bounds) {
    made["min"] = least;
    made["max"] = most;
  }
  return made;
}

/// Corner numbers, which come in 32 bits; in 16 where that is enough and the file does not ask for more.
json::Json PlainPrimitives::corners(base::Bytes bytes, bool wide) {
  std::uint32_t most = 0;
  for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
    most =
        std::max(most, static_cast<std::uint32_t>(number_at(bytes.data() + at, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)));
  }
  const bool is_short = most < 0xffff && !wide;
  std::vector<std::uint8_t> written;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (!is_short || at % 4 < 2) written.push_back(bytes[at]);
  }
  const std::size_t view = state_.builder.add_bytes(written);
  state_.builder.root["bufferViews"][view]["target"] = 34963;
  return {{"bufferView", view},
          {"componentType", is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
          {"count", bytes.size() / 4},
          {"type", "SCALAR"}};
}

void PlainPrimitives::put(int index, json::Json& named, json::Json made) {
  json::Json& accessors = state_.builder.root["accessors"];
  const bool has = named.is_number();
  const std::size_t old = has ? named.get<std::size_t>() : 0;
  for (const char* kept : {"name", "extras"}) {
    const json::Json* was = has ? json::find(accessors[old], kept) : nullptr;
    if (was != nullptr) made[kept] = *was;
  }
  if (has && uses_of(state_.builder.root, old) == 1) {
    accessors[old] = std::move(made);
    written_[index] = old;
  } else {
    written_[index] = state_.builder.add("accessors", std::move(made));
  }
}

}  // namespace penpose::io
