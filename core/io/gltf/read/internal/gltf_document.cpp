#include "core/io/gltf/read/internal/gltf_document.h"

#include <array>
#include <map>
#include <new>
#include <utility>

#include "core/io/gltf/read/compression/unpack_gltf.h"
#include "core/io/gltf/read/internal/gltf_schema.h"
#include "core/io/gltf/read/uri/uri.h"

namespace penpose::io {
namespace {

constexpr std::uint32_t k_magic = 0x46546c67;       // "glTF"
constexpr std::uint32_t k_json_chunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t k_binary_chunk = 0x004e4942;
// Of files beside the model: more are no model, and all of them are held at once.
constexpr std::size_t k_most_files = 4096;
constexpr std::uint64_t k_most_document_bytes = std::uint64_t{1} << 32;
constexpr const char* k_truncated = "the file is cut off or damaged; copy or export it again";

base::Error at_byte(std::string what, std::size_t offset, std::string remedy = k_truncated) {
  return {std::move(what), "byte offset " + std::to_string(offset), std::move(remedy)};
}

struct Container {
  base::Bytes json;
  base::Bytes binary;
  bool has_binary = false;
};

/// The chunks of a .glb file (glTF 2.0, section 4.4).
base::Result<Container> split_glb(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  reader.seek(4);
  const auto version = reader.read<std::uint32_t>();
  const auto length = reader.read<std::uint32_t>();
  if (!version || !length) return at_byte("the header is cut off", bytes.size());
  if (*version != 2) {
    return at_byte("binary glTF version " + std::to_string(*version), 4, "export the file as glTF 2.0");
  }
  if (*length > bytes.size()) {
    return at_byte("the header says " + std::to_string(*length) + " bytes, but the file has " +
                       std::to_string(bytes.size()) + ": a download or copy that was not finished",
                   8, "download, copy or export it again");
  }
  reader = base::ByteReader(bytes.first(*length));
  reader.seek(12);
  Container container;
  for (int chunk = 0; !reader.at_end(); ++chunk) {
    const std::size_t start = reader.offset();
    const auto size = reader.read<std::uint32_t>();
    const auto type = reader.read<std::uint32_t>();
    const auto data = size && type ? reader.take(*size) : std::nullopt;
    if (!data) return at_byte("the chunk reaches past the end of the file", start);
    if (chunk == 0 && *type != k_json_chunk) return at_byte("the first chunk is no JSON", start);
    if (chunk == 0) container.json = *data;
    if (*type == k_binary_chunk && !container.has_binary) {
      container.binary = *data;
      container.has_binary = true;
    }
  }
  if (container.json.empty()) return at_byte("there is no JSON chunk", 12);
  return container;
}

base::Result<base::Bytes> keep(GltfDocument& document, std::vector<std::uint8_t> bytes) {
  document.owned.push_back(std::make_unique<std::vector<std::uint8_t>>(std::move(bytes)));
  return base::Bytes(*document.owned.back());
}

/// The files that were read already, by name.
using ReadFiles = std::map<std::string, base::Bytes, std::less<>>;

base::Result<base::Bytes> load_uri(GltfDocument& document, const std::string& uri, const std::string& pointer,
                                   const FileResolver& resolve, ReadFiles& files) {
  if (is_data_uri(uri)) {
    auto bytes = decode_data_uri(uri);
    if (!bytes) return base::Error{bytes.error().what, pointer, bytes.error().remedy};
    return keep(document, std::move(bytes).value());
  }
  auto path = path_of_uri(uri);
  if (!path) {
    return base::Error{"the buffer lies outside the folder of the model", pointer,
                       "export the file as .glb, which holds everything"};
  }
  if (!resolve) {
    return base::Error{"the buffer is another file (" + *path + ")", pointer,
                       "export the file as .glb, which holds everything"};
  }
  if (const auto found = files.find(*path); found != files.end()) return found->second;
  if (files.size() == k_most_files) {
    return base::Error{"the model names more than " + std::to_string(k_most_files) + " files", pointer,
                       "export the file as .glb, which holds everything"};
  }
  auto bytes = resolve(*path);
  if (!bytes) {
    // Some programs write the names of files as they are.
    const auto as_written = path_as_written(uri);
    if (as_written && *as_written != *path) {
      if (const auto found = files.find(*as_written); found != files.end()) return found->second;
      if (auto others = resolve(*as_written)) {
        bytes = std::move(others);
        path = as_written;
      }
    }
  }
  if (!bytes) {
    return base::Error{"the buffer " + *path + " " + bytes.error().what, pointer, "put it beside the model"};
  }
  std::uint64_t held = bytes->size();
  for (const auto& owned : document.owned) held += owned->size();
  if (held > k_most_document_bytes) {
    return base::Error{
        "the files of the model are larger than " + std::to_string(k_most_document_bytes >> 20) + " MiB together",
        pointer, "divide the model, or leave something out of it"};
  }
  auto kept = keep(document, std::move(bytes).value());
  if (kept) files.emplace(*path, *kept);
  return kept;
}

base::Status load_buffers(GltfDocument& document, const Container& container, const FileResolver& resolve) {
  const json::Json* buffers = json::find(document.json, "buffers");
  if (buffers == nullptr) return base::Done{};
  ReadFiles files;
  if (!buffers->is_array()) return base::Error{"a list was expected", "/buffers", k_truncated};
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const std::string pointer = json::child("/buffers", i);
    const json::Json* length_value = json::find((*buffers)[i], "byteLength");
    const auto length =
        length_value == nullptr ? std::nullopt : json::whole_number(*length_value, 0, std::int64_t{1} << 40);
    if (!length) return base::Error{"a byteLength was expected", pointer, k_truncated};
    if (is_placeholder((*buffers)[i])) {
      document.buffers.emplace_back();
      continue;
    }
    const json::Json* uri = json::find((*buffers)[i], "uri");
    base::Bytes bytes;
    if (uri == nullptr && i == 0 && container.has_binary) {
      bytes = container.binary;
    } else if (uri != nullptr && uri->is_string()) {
      const auto loaded =
          load_uri(document, uri->get_ref<const std::string&>(), json::child(pointer, "uri"), resolve, files);
      if (!loaded) return loaded.error();
      bytes = *loaded;
    } else {
      return base::Error{"the buffer has no data", pointer, k_truncated};
    }
    if (static_cast<std::uint64_t>(*length) > bytes.size()) {
      return base::Error{
          "the buffer says " + std::to_string(*length) + " bytes, but there are " + std::to_string(bytes.size()),
          json::child(pointer, "byteLength"), k_truncated};
    }
    document.buffers.push_back(bytes.first(static_cast<std::size_t>(*length)));
  }
  return base::Done{};
}

base::Status read_structure(GltfDocument& document, const json::Json& vetted) {
  const base::Error failed{"the structure of the document cannot be read", "/", k_truncated};
  try {
    if (!parse_structure(vetted.dump(), document.model)) return failed;
  } catch (const std::bad_alloc&) {
    throw;  // no fault of what is read
  } catch (const std::exception&) {
    return failed;
  }
  // tinygltf skips what it does not like; then indices would point at other things than in the file.
  const auto same_size = [&](const char* name, std::size_t parsed) {
    const json::Json* array = json::find(vetted, name);
    return (array == nullptr ? 0 : array->size()) == parsed;
  };
  const tinygltf::Model& model = document.model;
  bool same = same_size("bufferViews", model.bufferViews.size()) && same_size("accessors", model.accessors.size()) &&
              same_size("materials", model.materials.size()) && same_size("meshes", model.meshes.size()) &&
              same_size("nodes", model.nodes.size()) && same_size("skins", model.skins.size()) &&
              same_size("animations", model.animations.size()) && same_size("scenes", model.scenes.size());
  for (std::size_t i = 0; same && i < model.meshes.size(); ++i) {
    const json::Json& primitives = vetted["meshes"][i]["primitives"];
    same = primitives.size() == model.meshes[i].primitives.size();
    for (std::size_t p = 0; same && p < primitives.size(); ++p) {
      const json::Json* targets = json::find(primitives[p], "targets");
      same = (targets == nullptr ? 0 : targets->size()) == model.meshes[i].primitives[p].targets.size();
    }
  }
  for (std::size_t i = 0; same && i < model.animations.size(); ++i) {
    same = vetted["animations"][i]["channels"].size() == model.animations[i].channels.size() &&
           vetted["animations"][i]["samplers"].size() == model.animations[i].samplers.size();
  }
  if (!same) return failed;
  return base::Done{};
}

/// A number takes some 14 bytes once it is read: what comes of a file stays below 40 times its size.
std::size_t budget_of(std::size_t bytes) { return (std::size_t{9} << 18) + 2 * bytes + bytes / 2; }

/// What the entries of a document take once they are read, counted as numbers: measured with entries that are empty.
std::uint64_t numbers_of_entries(const json::Json& document) {
  struct Cost {
    const char* list;
    std::uint64_t numbers;
    const char* inner;  ///< lists in each entry, "" for none
    const char* other;
  };
  constexpr std::uint64_t k_inner = 60;
  constexpr auto k_costs = std::to_array<Cost>({{"nodes", 80, "", ""},
                                                {"materials", 290, "", ""},
                                                {"meshes", 90, "primitives", ""},
                                                {"accessors", 140, "", ""},
                                                {"bufferViews", 60, "", ""},
                                                {"skins", 80, "", ""},
                                                {"scenes", 80, "", ""},
                                                {"animations", 110, "channels", "samplers"}});
  std::uint64_t sum = 0;
  for (const Cost& cost : k_costs) {
    const json::Json* list = json::find(document, cost.list);
    if (list == nullptr || !list->is_array()) continue;
    sum += cost.numbers * list->size();
    for (std::size_t i = 0; *cost.inner != '\0' && i < list->size(); ++i) {
      for (const char* name : {cost.inner, cost.other}) {
        const json::Json* inner = *name == '\0' ? nullptr : json::find((*list)[i], name);
        if (inner != nullptr && inner->is_array()) sum += k_inner * inner->size();
      }
    }
  }
  return sum;
}

}  // namespace

bool is_glb(base::Bytes bytes) { return base::ByteReader(bytes).read<std::uint32_t>() == k_magic; }

base::Result<GltfDocument> open_gltf(base::Bytes bytes, const FileResolver& resolve) {
  Container container{bytes, {}, false};
  if (is_glb(bytes)) {
    auto split = split_glb(bytes);
    if (!split) return split.error();
    container = *split;
  }
  auto json = json::parse_json(container.json);
  if (!json) {
    base::Error error = json.error();
    if (is_glb(bytes)) error.place += " of the JSON chunk";
    return error;
  }
  GltfDocument document;
  document.json = std::move(json).value();
  // Before anything is made of them: "{}" is a node or a material as well, of a thousand bytes and more.
  const std::uint64_t entries = numbers_of_entries(document.json);
  if (entries > budget_of(bytes.size())) {
    return base::Error{"the file lists far more nodes, materials and the like than it has bytes for", "/",
                       "it is damaged or hostile; export it again"};
  }
  auto vetted = vet_gltf(document.json, document.notes);
  if (!vetted) return vetted.error();
  if (const auto loaded = load_buffers(document, container, resolve); !loaded) return loaded.error();
  std::size_t data = bytes.size();
  for (const auto& owned : document.owned) data += owned->size();
  const auto unpacked = unpack_gltf(document, *vetted, data);
  if (!unpacked) return unpacked.error();
  data += static_cast<std::size_t>(*unpacked);
  if (const auto parsed = read_structure(document, *vetted); !parsed) return parsed.error();
  document.budget = budget_of(data) - static_cast<std::size_t>(entries);
  return document;
}

base::Result<GltfDocument> open_kept_gltf(base::Bytes bytes, const FileResolver& resolve) {
  auto file = std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
  auto document = open_gltf(*file, resolve);
  if (document) document->file = std::move(file);
  return document;
}

base::Result<std::vector<std::uint8_t>> read_uri(const std::string& uri, const std::string& pointer,
                                                 const FileResolver& resolve) {
  GltfDocument one;
  ReadFiles files;
  const auto loaded = load_uri(one, uri, pointer, resolve, files);
  if (!loaded) return loaded.error();
  return std::move(*one.owned.back());
}

}  // namespace penpose::io
