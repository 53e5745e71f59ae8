#include "core/io/gltf/read/internal/gltf_schema.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/io/gltf/read/internal/checks/gltf_checks.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

// On a 32-bit machine no more than tinygltf's size_t holds: a larger one must not be cut to another that fits.
constexpr std::int64_t k_most_schema_bytes =
    static_cast<std::int64_t>(std::min<std::uint64_t>(std::uint64_t{1} << 40, std::numeric_limits<std::size_t>::max()));
// tinygltf keeps several of these in an int.
constexpr std::int64_t k_most_int = 0x7fffffff;

enum class Kind : std::uint8_t {
  text,
  flag,
  number,
  whole,
  index,
  numbers,
  indices,
  object,
  objects,
  attributes,
  attribute_list
};

struct Member {
  const char* name;
  Kind kind;
  bool required = false;
  std::int64_t minimum = 0;           ///< whole: least value; numbers: how many (0: any number of them)
  std::int64_t maximum = k_most_int;  ///< whole: greatest value
  const char* target = nullptr;       ///< index, indices: the array of the document that is meant
  std::span<const Member> members{};  ///< object, objects
};

constexpr auto k_asset = std::to_array<Member>({{"version", Kind::text}});
constexpr auto k_buffer_view = std::to_array<Member>({
    {"buffer", Kind::index, true, 0, 0, "buffers"},
    {"byteOffset", Kind::whole, false, 0, k_most_schema_bytes},
    {"byteLength", Kind::whole, true, 0, k_most_schema_bytes},
    {"byteStride", Kind::whole, false, 0, 252},
});
constexpr auto k_sparse_indices = std::to_array<Member>({
    {"bufferView", Kind::index, true, 0, 0, "bufferViews"},
    {"byteOffset", Kind::whole, false, 0, k_most_int},
    {"componentType", Kind::whole, true, 5120, 5126},
});
constexpr auto k_sparse_values = std::to_array<Member>({
    {"bufferView", Kind::index, true, 0, 0, "bufferViews"},
    {"byteOffset", Kind::whole, false, 0, k_most_int},
});
constexpr auto k_sparse = std::to_array<Member>({
    {"count", Kind::whole, true, 1, k_most_int},
    {"indices", Kind::object, true, 0, 0, nullptr, k_sparse_indices},
    {"values", Kind::object, true, 0, 0, nullptr, k_sparse_values},
});
constexpr auto k_accessor = std::to_array<Member>({
    {"bufferView", Kind::index, false, 0, 0, "bufferViews"},
    {"byteOffset", Kind::whole, false, 0, k_most_schema_bytes},
    {"componentType", Kind::whole, true, 5120, 5126},
    {"normalized", Kind::flag},
    {"count", Kind::whole, true, 0, k_most_int},
    {"type", Kind::text, true},
    {"sparse", Kind::object, false, 0, 0, nullptr, k_sparse},
});
constexpr auto k_primitive = std::to_array<Member>({
    {"attributes", Kind::attributes, true},
    {"indices", Kind::index, false, 0, 0, "accessors"},
    {"material", Kind::index, false, 0, 0, "materials"},
    {"mode", Kind::whole, false, 0, 6},
    {"targets", Kind::attribute_list},
});
constexpr auto k_mesh = std::to_array<Member>({
    {"name", Kind::text},
    {"primitives", Kind::objects, true, 0, 0, nullptr, k_primitive},
    {"weights", Kind::numbers},
});
constexpr auto k_node = std::to_array<Member>({
    {"name", Kind::text},
    {"children", Kind::indices, false, 0, 0, "nodes"},
    {"skin", Kind::index, false, 0, 0, "skins"},
    {"mesh", Kind::index, false, 0, 0, "meshes"},
    {"matrix", Kind::numbers, false, 16},
    {"translation", Kind::numbers, false, 3},
    {"rotation", Kind::numbers, false, 4},
    {"scale", Kind::numbers, false, 3},
    {"weights", Kind::numbers},
});
constexpr auto k_scene = std::to_array<Member>({{"nodes", Kind::indices, false, 0, 0, "nodes"}});
constexpr auto k_skin = std::to_array<Member>({
    {"name", Kind::text},
    {"inverseBindMatrices", Kind::index, false, 0, 0, "accessors"},
    {"joints", Kind::indices, true, 0, 0, "nodes"},
});
constexpr auto k_channel_target = std::to_array<Member>({
    {"node", Kind::index, false, 0, 0, "nodes"},
    {"path", Kind::text, true},
});
constexpr auto k_sampler = std::to_array<Member>({
    {"input", Kind::index, true, 0, 0, "accessors"},
    {"interpolation", Kind::text},
    {"output", Kind::index, true, 0, 0, "accessors"},
});
constexpr auto k_channel = std::to_array<Member>({
    {"sampler", Kind::whole, true, 0, k_most_int},
    {"target", Kind::object, true, 0, 0, nullptr, k_channel_target},
});
constexpr auto k_animation = std::to_array<Member>({
    {"name", Kind::text},
    {"channels", Kind::objects, true, 0, 0, nullptr, k_channel},
    {"samplers", Kind::objects, true, 0, 0, nullptr, k_sampler},
});
constexpr auto k_metallic = std::to_array<Member>({
    {"baseColorFactor", Kind::numbers, false, 4},
    {"metallicFactor", Kind::number},
    {"roughnessFactor", Kind::number},
});
constexpr auto k_material = std::to_array<Member>({
    {"name", Kind::text},
    {"pbrMetallicRoughness", Kind::object, false, 0, 0, nullptr, k_metallic},
});
// Buffers are not here: their bytes are resolved and checked apart, without a copy.
constexpr auto k_root = std::to_array<Member>({
    {"asset", Kind::object, true, 0, 0, nullptr, k_asset},
    {"bufferViews", Kind::objects, false, 0, 0, nullptr, k_buffer_view},
    {"accessors", Kind::objects, false, 0, 0, nullptr, k_accessor},
    {"materials", Kind::objects, false, 0, 0, nullptr, k_material},
    {"meshes", Kind::objects, false, 0, 0, nullptr, k_mesh},
    {"nodes", Kind::objects, false, 0, 0, nullptr, k_node},
    {"skins", Kind::objects, false, 0, 0, nullptr, k_skin},
    {"animations", Kind::objects, false, 0, 0, nullptr, k_animation},
    {"scenes", Kind::objects, false, 0, 0, nullptr, k_scene},
    {"scene", Kind::index, false, 0, 0, "scenes"},
});

base::Error wrong_member(std::string what, std::string pointer, std::string remedy = k_export_again) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

class Vetter {
 public:
  explicit Vetter(const json::Json& root) : root_(root) {}

  base::Result<json::Json> object(const json::Json& value, std::span<const Member> members,
                                  const std::string& pointer) const {
    if (!value.is_object()) return wrong_member("an object was expected", pointer.empty() ? "/" : pointer);
    json::Json vetted = json::Json::object();
    for (const Member& member : members) {
      const json::Json* found = json::find(value, member.name);
      // A null says no more than a member that is missing; names and the like in other types say nothing.
      if (found != nullptr && found->is_null()) found = nullptr;
      if (found != nullptr && member.kind == Kind::text && !member.required && !found->is_string()) found = nullptr;
      if (found == nullptr) {
        if (!member.required) continue;
        return wrong_member("the member \"" + std::string(member.name) + "\" is missing",
                            pointer.empty() ? "/" : pointer);
      }
      auto checked = any(*found, member, json::child(pointer, member.name));
      if (!checked) return checked.error();
      vetted[member.name] = std::move(checked).value();
    }
    return vetted;
  }

 private:
  base::Result<json::Json> any(const json::Json& value, const Member& member, const std::string& pointer) const {
    switch (member.kind) {
      case Kind::text:
        if (!value.is_string()) return wrong_member("a text was expected", pointer);
        return value;
      case Kind::flag:
        if (!value.is_boolean()) return wrong_member("true or false was expected", pointer);
        return value;
      case Kind::number:
        if (!json::number(value)) return wrong_member("a number was expected", pointer);
        return value;
      case Kind::whole: {
        const auto whole = json::whole_number(value, member.minimum, member.maximum);
        if (!whole) {
          return wrong_member("a whole number from " + std::to_string(member.minimum) + " to " +
                                  std::to_string(member.maximum) + " was expected",
                              pointer);
        }
        return json::Json(*whole);
      }
      case Kind::index:
        return index(value, member.target, pointer);
      case Kind::numbers:
        return numbers(value, static_cast<std::size_t>(member.minimum), pointer);
      case Kind::indices:
        return each(value, pointer,
                    [&](const json::Json& item, const std::string& here) { return index(item, member.target, here); });
      case Kind::object:
        return object(value, member.members, pointer);
      case Kind::objects:
        return each(value, pointer, [&](const json::Json& item, const std::string& here) {
          return object(item, member.members, here);
        });
      case Kind::attributes:
        return attributes(value, pointer);
      case Kind::attribute_list:
        return each(value, pointer,
                    [&](const json::Json& item, const std::string& here) { return attributes(item, here); });
    }
    return wrong_member("an unknown member", pointer);
  }

  base::Result<json::Json> index(const json::Json& value, const char* target, const std::string& pointer) const {
    const json::Json* array = json::find(root_, target);
    const std::size_t size = array != nullptr && array->is_array() ? array->size() : 0;
    const auto whole = json::whole_number(value, 0, k_most_int);
    if (!whole) return wrong_member("an index into " + std::string(target) + " was expected", pointer);
    if (static_cast<std::size_t>(*whole) >= size) {
      return wrong_member("index " + std::to_string(*whole) + " into " + target + ", which has " + std::to_string(size),
                          pointer);
    }
    return json::Json(*whole);
  }

  template <typename Check>
  static base::Result<json::Json> each(const json::Json& value, const std::string& pointer, Check check) {
    if (!value.is_array()) return wrong_member("a list was expected", pointer);
    json::Json vetted = json::Json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      auto checked = check(value[i], json::child(pointer, i));
      if (!checked) return checked.error();
      vetted.push_back(std::move(checked).value());
    }
    return vetted;
  }

  static base::Result<json::Json> numbers(const json::Json& value, std::size_t count, const std::string& pointer) {
    if (!value.is_array() || (count != 0 && value.size() != count)) {
      return wrong_member("a list of " + (count == 0 ? "" : std::to_string(count) + " ") + "numbers was expected",
                          pointer);
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!json::number(value[i])) return wrong_member("a number was expected", json::child(pointer, i));
    }
    return value;
  }

  base::Result<json::Json> attributes(const json::Json& value, const std::string& pointer) const {
    if (!value.is_object()) return wrong_member("an object of attributes was expected", pointer);
    json::Json vetted = json::Json::object();
    for (const auto& [name, accessor] : value.items()) {
      auto checked = index(accessor, "accessors", json::child(pointer, name));
      if (!checked) return checked.error();
      vetted[name] = std::move(checked).value();
    }
    return vetted;
  }

  const json::Json& root_;
};

/// Channels without a node are for extensions to say (glTF 2.0, section 3.11: such a channel is to be ignored).
void drop_channels_without_node(json::Json& vetted, std::vector<std::string>& notes) {
  if (json::find(vetted, "animations") == nullptr) return;
  json::Json& animations = vetted["animations"];
  std::size_t dropped = 0;
  for (std::size_t a = 0; a < animations.size(); ++a) {
    const json::Json& channels = animations[a]["channels"];
    json::Json kept = json::Json::array();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const json::Json& target = channels[c]["target"];
      if (json::find(target, "node") != nullptr && target["path"].get<std::string>() != "pointer") {
        kept.push_back(channels[c]);
      }
    }
    dropped += channels.size() - kept.size();
    if (kept.size() != channels.size()) animations[a]["channels"] = std::move(kept);
  }
  if (dropped == 0) return;
  notes.push_back(std::to_string(dropped) + (dropped == 1 ? " channel" : " channels") +
                  " of animations without a node (as of KHR_animation_pointer) " + (dropped == 1 ? "was" : "were") +
                  " left alone");
}

}  // namespace

base::Result<json::Json> vet_gltf(const json::Json& document, std::vector<std::string>& notes) {
  if (!document.is_object()) return wrong_member("an object was expected", "/");
  if (json::find(document, "asset") == nullptr && json::find(document, "meshes") == nullptr) {
    return wrong_member("this is JSON, but no glTF: it has neither \"asset\" nor \"meshes\"", "/",
                        "choose a file with a model, or download the file itself");
  }
  // First: what another version or an extension changes must not be called damaged.
  if (auto error = check_version(document)) return *error;
  if (auto error = check_extensions(document)) return *error;
  auto vetted = Vetter(document).object(document, k_root, "");
  if (!vetted) return vetted.error();
  if (auto error = check_tree(*vetted)) return *error;
  if (auto error = check_indices(*vetted, document)) return *error;
  if (auto error = check_samplers(*vetted)) return *error;
  drop_channels_without_node(*vetted, notes);
  return vetted;
}

}  // namespace penpose::io
