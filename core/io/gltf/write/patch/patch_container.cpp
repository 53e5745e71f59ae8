#include "core/io/gltf/write/patch/patch_container.h"

#include <algorithm>
#include <set>

#include "core/base/byte_reader.h"
#include "core/io/gltf/read/uri/uri.h"

namespace penpose::io {
namespace {

constexpr std::array<std::uint8_t, 4> k_zeros{};

std::size_t padding_of(std::size_t length) { return (4 - length % 4) % 4; }

/// Views of a compressed stream say in an extension where that is.
constexpr std::array<const char*, 2> k_streams{"EXT_meshopt_compression", "KHR_meshopt_compression"};

std::string mime_type_of(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (text.starts_with("\x89PNG")) return "image/png";
  if (text.starts_with("\xff\xd8")) return "image/jpeg";
  if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "image/webp";
  if (text.starts_with("\xabKTX 20")) return "image/ktx2";
  return "application/octet-stream";
}

void move_view(json::Json& view, const std::vector<std::size_t>& buffers, const std::vector<std::size_t>& offsets) {
  const json::Json* named = json::find(view, "buffer");
  const auto buffer =
      named == nullptr ? std::nullopt : json::whole_number(*named, 0, static_cast<std::int64_t>(buffers.size()) - 1);
  if (!buffer) return;
  const auto index = static_cast<std::size_t>(*buffer);
  view["buffer"] = buffers[index];
  if (offsets[index] == 0) return;
  const json::Json* offset = json::find(view, "byteOffset");
  const auto was = offset == nullptr ? std::nullopt : json::whole_number(*offset, 0, std::int64_t{1} << 40);
  view["byteOffset"] = static_cast<std::size_t>(was.value_or(0)) + offsets[index];
}

}  // namespace

FileResolver resolver_of(const document::SourceFile& source) {
  return [&source](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    const auto found = source.files.find(path);
    if (found == source.files.end()) return base::Error{"is not there", "", "put it beside the model"};
    return found->second;
  };
}

PatchContainer::PatchContainer(const document::SourceFile& source, const GltfDocument& document,
                               GltfContainer container, std::string stem)
    : source_(source), from_(document), container_(container), stem_(std::move(stem)), json_(document.json) {
  const json::Json* buffers = json::find(json_, "buffers");
  in_binary_ =
      is_glb(*source.bytes) && buffers != nullptr && !buffers->empty() && json::find((*buffers)[0], "uri") == nullptr;
  if (container_ == GltfContainer::binary) {
    gather();
  } else if (in_binary_) {
    pieces_.push_back(from_.buffers.front());
    length_ = from_.buffers.front().size();
  } else {
    buffer_ = buffers == nullptr ? 0 : buffers->size();
  }
  start_ = length_ + padding_of(length_);
}

/// Joins all buffers that have bytes to one, in their order.
void PatchContainer::gather() {
  const json::Json* found = json::find(json_, "buffers");
  if (found == nullptr) return;
  const json::Json buffers = *found;
  std::vector<std::size_t> numbers(buffers.size(), 0);
  std::vector<std::size_t> offsets(buffers.size(), 0);
  json::Json merged = json::Json::array();
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const bool has_bytes = json::find(buffers[i], "uri") != nullptr || (i == 0 && in_binary_);
    if (!has_bytes) continue;
    if (merged.empty()) merged.push_back(buffers[i]);
    if (const std::size_t padding = padding_of(length_); padding > 0) {
      pieces_.emplace_back(k_zeros.data(), padding);
      length_ += padding;
    }
    offsets[i] = length_;
    pieces_.push_back(from_.buffers[i]);
    length_ += from_.buffers[i].size();
  }
  if (merged.empty()) merged.push_back(json::Json::object());
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    if (json::find(buffers[i], "uri") != nullptr || (i == 0 && in_binary_)) continue;
    numbers[i] = merged.size();
    merged.push_back(buffers[i]);
  }
  if (merged[0].contains("uri")) merged[0].erase("uri");
  merged[0]["byteLength"] = length_;
  json_["buffers"] = std::move(merged);
  const json::Json* views = json::find(json_, "bufferViews");
  for (std::size_t v = 0; views != nullptr && v < views->size(); ++v) {
    json::Json& view = json_["bufferViews"][v];
    move_view(view, numbers, offsets);
    const json::Json* extensions = json::find(view, "extensions");
    for (const char* name : k_streams) {
      if (extensions != nullptr && json::find(*extensions, name) != nullptr)
        move_view(view["extensions"][name], numbers, offsets);
    }
  }
}

/// Pictures beside the model become views of the buffer.
void PatchContainer::take_pictures(GltfBuilder& builder) const {
  const json::Json* images = json::find(builder.root, "images");
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; images != nullptr && images->is_array() && i < images->size(); ++i) {
    json::Json& image = builder.root["images"][i];
    const json::Json* uri = json::find(image, "uri");
    const auto path = uri != nullptr && uri->is_string() ? path_of_uri(uri->get<std::string>()) : std::nullopt;
    const auto file = path ? source_.files.find(*path) : source_.files.end();
    if (file == source_.files.end() || file->second.empty()) continue;
    const auto [view, is_new] = taken.try_emplace(*path, 0);
    if (is_new) view->second = builder.add_bytes(file->second);
    image.erase("uri");
    image["bufferView"] = view->second;
    // A picture beside the model needs no type; one in a view does, and "image/jpg" is none.
    if (!image.contains("mimeType") || image["mimeType"] == "image/jpg") image["mimeType"] = mime_type_of(file->second);
  }
}

/// "STEM.bin", or another name where the file that was read has one of that name beside it.
std::string PatchContainer::free_name() const {
  std::string name = stem_.empty() ? "model" : stem_;
  while (source_.files.contains(name + ".bin")) name += "_new";
  return name + ".bin";
}

base::Result<std::vector<std::uint8_t>> PatchContainer::finish(
    GltfBuilder& builder, bool changed, std::map<std::string, std::vector<std::uint8_t>>& files) {
  const bool same_kind = is_glb(*source_.bytes) == (container_ == GltfContainer::binary);
  if (container_ == GltfContainer::text) files = source_.files;
  if (!changed && same_kind && (container_ == GltfContainer::text || source_.files.empty())) return *source_.bytes;
  if (container_ == GltfContainer::binary) take_pictures(builder);
  if (!builder.added().empty()) {
    if (const std::size_t padding = start_ - length_; padding > 0) pieces_.emplace_back(k_zeros.data(), padding);
    pieces_.push_back(builder.added());
    length_ = start_ + builder.added().size();
  }
  if (container_ == GltfContainer::binary) {
    if (length_ > 0) {
      if (!builder.root.contains("buffers")) builder.root["buffers"] = json::Json::array({json::Json::object()});
      builder.root["buffers"][0]["byteLength"] = length_;
    }
    auto text = text_of(builder.root, TextOrder::as_made);
    if (!text) return text.error();
    return pack_glb(std::move(text).value(), pieces_);
  }
  if (length_ > 0) {
    std::vector<std::uint8_t>& file = files[free_name()];
    for (const base::Bytes piece : pieces_) file.insert(file.end(), piece.begin(), piece.end());
    if (!builder.root.contains("buffers")) builder.root["buffers"] = json::Json::array();
    while (builder.root["buffers"].size() <= buffer_) builder.root["buffers"].push_back(json::Json::object());
    json::Json& buffer = builder.root["buffers"][buffer_];
    buffer["uri"] = free_name();
    buffer["byteLength"] = length_;
  }
  auto text = text_of(builder.root, TextOrder::as_made);
  if (!text) return text.error();
  return std::vector<std::uint8_t>(text->begin(), text->end());
}

}  // namespace penpose::io
