#include "core/io/gltf/read/compression/unpack_gltf.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/io/gltf/read/compression/draco_stream.h"
#include "core/io/gltf/read/compression/meshopt_stream.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

// Honest files unpack to some 20 times their size.
constexpr std::uint64_t k_most_times = 40;
constexpr std::uint64_t k_free_bytes = std::uint64_t{1} << 20;
constexpr std::int64_t k_most_whole = std::int64_t{1} << 40;
constexpr std::array<const char*, 2> k_meshopt = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr const char* k_draco = "KHR_draco_mesh_compression";

const json::Json* extension(const json::Json& object, const char* name) {
  const json::Json* extensions = json::find(object, "extensions");
  return extensions == nullptr ? nullptr : json::find(*extensions, name);
}

base::Error damaged(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), k_export_again};
}

base::Error at(base::Error error, std::string pointer) {
  error.place = std::move(pointer);
  return error;
}

std::size_t size_of(const json::Json& list) { return list.is_array() ? list.size() : 0; }

std::optional<std::size_t> whole(const json::Json& object, const char* name, std::int64_t least) {
  const json::Json* found = json::find(object, name);
  const auto number = found == nullptr ? std::nullopt : json::whole_number(*found, least, k_most_whole);
  return number ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
}

std::size_t components_of(const json::Json& accessor) {
  const auto& type = accessor["type"].get_ref<const std::string&>();
  if (type == "SCALAR") return 1;
  return type.size() == 4 && type.starts_with("VEC") ? static_cast<std::size_t>(type[3] - '0') : 0;
}

class Unpacker {
 public:
  Unpacker(GltfDocument& document, json::Json& vetted, std::uint64_t file_bytes)
      : document_(document),
        vetted_(vetted),
        left_(k_free_bytes + std::min<std::uint64_t>(file_bytes, std::uint64_t{1} << 31) * k_most_times),
        all_(left_) {}

  base::Result<std::uint64_t> unpack() {
    const json::Json* views = json::find(document_.json, "bufferViews");
    for (std::size_t i = 0; views != nullptr && i < size_of(*views); ++i) {
      for (const char* name : k_meshopt) {
        const json::Json* packed = extension((*views)[i], name);
        if (packed == nullptr) continue;
        const std::string pointer = json::child(json::child("/bufferViews", i), "extensions");
        if (auto status = view(i, *packed, json::child(pointer, name)); !status) return status.error();
        break;
      }
    }
    const json::Json* meshes = json::find(document_.json, "meshes");
    for (std::size_t m = 0; meshes != nullptr && m < size_of(*meshes); ++m) {
      const json::Json& primitives = (*meshes)[m]["primitives"];
      for (std::size_t p = 0; p < size_of(primitives); ++p) {
        const json::Json* packed = draco_of(primitives[p]);
        if (packed == nullptr) continue;
        const std::string here = json::child(json::child(json::child("/meshes", m), "primitives"), p);
        const std::string pointer = json::child(json::child(here, "extensions"), k_draco);
        if (auto status = primitive(vetted_["meshes"][m]["primitives"][p], *packed, pointer); !status) {
          return status.error();
        }
      }
    }
    return all_ - left_;
  }

 private:
  /// Bytes of a run inside a buffer.
  base::Result<base::Bytes> run(std::size_t buffer, std::size_t offset, std::size_t length,
                                const std::string& pointer) const {
    if (buffer >= document_.buffers.size()) return damaged("the buffer does not exist", pointer);
    const base::Bytes bytes = document_.buffers[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset) {
      return damaged(
          "the compressed bytes reach past the end of their buffer (" + std::to_string(bytes.size()) + " bytes)",
          pointer);
    }
    return bytes.subspan(offset, length);
  }

  /// Takes a new buffer in.
  std::size_t add_buffer(std::vector<std::uint8_t> bytes) {
    left_ -= std::min<std::uint64_t>(left_, bytes.size());
    document_.owned.push_back(std::make_unique<std::vector<std::uint8_t>>(std::move(bytes)));
    document_.buffers.emplace_back(*document_.owned.back());
    return document_.buffers.size() - 1;
  }

  base::Status view(std::size_t index, const json::Json& packed, const std::string& pointer) {
    const auto buffer = whole(packed, "buffer", 0);
    const auto length = whole(packed, "byteLength", 1);
    const auto count = whole(packed, "count", 1);
    const auto stride = whole(packed, "byteStride", 1);
    if (!buffer || !length || !count || !stride) {
      return damaged("buffer, byteLength, byteStride and count were expected", pointer);
    }
    MeshoptLayout layout{.count = *count, .stride = *stride};
    const auto text = [&](const char* name, std::string_view otherwise) {
      const json::Json* found = json::find(packed, name);
      return found != nullptr && found->is_string() ? found->get<std::string>() : std::string(otherwise);
    };
    const std::string mode = text("mode", "");
    const std::string filter = text("filter", "NONE");
    if (mode == "TRIANGLES") {
      layout.mode = MeshoptMode::triangles;
    } else if (mode == "INDICES") {
      layout.mode = MeshoptMode::indices;
    } else if (mode != "ATTRIBUTES") {
      return base::Error{"the compression mode \"" + mode + "\" is not known", json::child(pointer, "mode"),
                         "export the file without compression"};
    }
    if (filter == "OCTAHEDRAL") {
      layout.filter = MeshoptFilter::octahedral;
    } else if (filter == "QUATERNION") {
      layout.filter = MeshoptFilter::quaternion;
    } else if (filter == "EXPONENTIAL") {
      layout.filter = MeshoptFilter::exponential;
    } else if (filter != "NONE") {
      return base::Error{"the compression filter \"" + filter + "\" is not known", json::child(pointer, "filter"),
                         "export the file without compression"};
    }
    const auto bytes = run(*buffer, whole(packed, "byteOffset", 0).value_or(0), *length, pointer);
    if (!bytes) return bytes.error();
    auto unpacked = unpack_meshopt(*bytes, layout, left_);
    if (!unpacked) return at(unpacked.error(), pointer);
    json::Json plain = json::Json::object();
    plain["byteLength"] = json::Json(static_cast<std::int64_t>(unpacked->size()));
    plain["buffer"] = json::Json(static_cast<std::int64_t>(add_buffer(std::move(unpacked).value())));
    if (layout.mode == MeshoptMode::attributes && layout.stride <= 252) {
      plain["byteStride"] = json::Json(static_cast<std::int64_t>(layout.stride));
    }
    vetted_["bufferViews"][index] = std::move(plain);
    return base::Done{};
  }

  /// A buffer view of bytes of our own.
  std::int64_t add_view(std::vector<std::uint8_t> bytes) {
    json::Json plain = json::Json::object();
    plain["byteLength"] = json::Json(static_cast<std::int64_t>(bytes.size()));
    plain["buffer"] = json::Json(static_cast<std::int64_t>(add_buffer(std::move(bytes))));
    vetted_["bufferViews"].push_back(std::move(plain));
    return static_cast<std::int64_t>(vetted_["bufferViews"].size()) - 1;
  }

  /// What an accessor says of attributes that a stream gives. One that another stream has filled already is copied:
  /// exporters let primitives of one shape share their accessors.
  std::size_t own_accessor(std::size_t accessor, const std::string& stream) {
    json::Json& accessors = vetted_["accessors"];
    const auto [found, is_new] = filled_.try_emplace(accessor, stream);
    if (is_new || found->second == stream) return accessor;
    json::Json copy = accessors[accessor];
    accessors.push_back(std::move(copy));
    filled_.emplace(accessors.size() - 1, stream);
    return accessors.size() - 1;
  }

  void fill(std::size_t accessor, std::vector<std::uint8_t> bytes, std::size_t count) {
    const std::int64_t view = add_view(std::move(bytes));
    json::Json& one = vetted_["accessors"][accessor];
    one["bufferView"] = json::Json(view);
    one["byteOffset"] = json::Json(std::int64_t{0});
    one["count"] = json::Json(static_cast<std::int64_t>(count));
  }

  /// A primitive of an open file, `plain`, whose triangles and attributes stand in a Draco stream.
  base::Status primitive(json::Json& plain, const json::Json& packed, const std::string& pointer) {
    const auto view_index = whole(packed, "bufferView", 0);
    const json::Json* ids = json::find(packed, "attributes");
    const json::Json* views = json::find(vetted_, "bufferViews");
    if (!view_index || ids == nullptr || !ids->is_object()) {
      return damaged("bufferView and attributes were expected", pointer);
    }
    if (views == nullptr || *view_index >= views->size()) {
      return damaged("the buffer view does not exist", json::child(pointer, "bufferView"));
    }
    std::vector<DracoAttribute> wanted;
    std::vector<std::string> names;
    std::string stream = std::to_string(*view_index);
    bool is_plain = true;
    const auto has_data = [&](std::size_t accessor) {
      return json::find(vetted_["accessors"][accessor], "bufferView") != nullptr && !filled_.contains(accessor);
    };
    for (const auto& [name, id] : ids->items()) {
      const json::Json* attribute = json::find(plain["attributes"], name.c_str());
      const auto unique = json::whole_number(id, 0, 0xffffffffLL);
      if (!unique) return damaged("an attribute's number was expected", json::child(pointer, "attributes"));
      if (attribute == nullptr) continue;
      const auto accessor = attribute->get<std::size_t>();
      const json::Json& one = vetted_["accessors"][accessor];
      wanted.push_back({static_cast<std::uint32_t>(*unique), one["componentType"].get<int>(), components_of(one)});
      names.push_back(name);
      stream += "," + name + ":" + std::to_string(*unique);
      is_plain = is_plain && has_data(accessor);
    }
    const json::Json* indices = json::find(plain, "indices");
    is_plain = is_plain && indices != nullptr && has_data(indices->get<std::size_t>());
    // The same once more, for readers that do not know the extension.
    if (is_plain) return base::Done{};

    const json::Json& holder = (*views)[*view_index];
    const auto bytes = run(holder["buffer"].get<std::size_t>(), whole(holder, "byteOffset", 0).value_or(0),
                           holder["byteLength"].get<std::size_t>(), json::child(pointer, "bufferView"));
    if (!bytes) return bytes.error();
    auto mesh = unpack_draco(*bytes, wanted, left_);
    if (!mesh) return at(mesh.error(), pointer);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::size_t accessor = own_accessor(plain["attributes"][names[i]].get<std::size_t>(), stream);
      fill(accessor, std::move(mesh->attributes[i]), mesh->points);
      plain["attributes"][names[i]] = json::Json(static_cast<std::int64_t>(accessor));
    }
    std::vector<std::uint8_t> corners;
    corners.reserve(mesh->corners.size() * 4);
    for (const std::uint32_t corner : mesh->corners) {
      for (unsigned shift = 0; shift < 32; shift += 8) corners.push_back(static_cast<std::uint8_t>(corner >> shift));
    }
    std::size_t accessor = 0;
    if (indices != nullptr) {
      accessor = own_accessor(indices->get<std::size_t>(), stream + ",indices");
    } else {
      vetted_["accessors"].push_back(json::Json::object());
      accessor = vetted_["accessors"].size() - 1;
    }
    fill(accessor, std::move(corners), mesh->corners.size());
    json::Json& triangles = vetted_["accessors"][accessor];
    triangles["type"] = json::Json("SCALAR");
    triangles["componentType"] = json::Json(std::int64_t{5125});
    plain["indices"] = json::Json(static_cast<std::int64_t>(accessor));
    // Strips come as the triangles that they are.
    plain["mode"] = json::Json(std::int64_t{4});
    return base::Done{};
  }

  GltfDocument& document_;
  json::Json& vetted_;
  std::uint64_t left_;
  std::uint64_t all_;
  std::map<std::size_t, std::string> filled_;  ///< accessors, and which stream they come from
};

}  // namespace

bool is_placeholder(const json::Json& buffer) {
  return std::any_of(k_meshopt.begin(), k_meshopt.end(), [&](const char* name) {
    const json::Json* found = extension(buffer, name);
    const json::Json* marked = found == nullptr ? nullptr : json::find(*found, "fallback");
    return marked != nullptr && marked->is_boolean() && marked->get<bool>();
  });
}

const json::Json* draco_of(const json::Json& primitive) { return extension(primitive, k_draco); }

base::Result<std::uint64_t> unpack_gltf(GltfDocument& document, json::Json& vetted, std::uint64_t file_bytes) {
  return Unpacker(document, vetted, file_bytes).unpack();
}

}  // namespace penpose::io
