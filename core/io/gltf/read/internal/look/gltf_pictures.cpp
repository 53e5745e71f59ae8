#include "core/io/gltf/read/internal/look/gltf_pictures.h"

#include <memory>
#include <utility>

#include "core/io/gltf/read/internal/look/lenient_json.h"
#include "core/io/gltf/read/internal/look/picture_head.h"

namespace penpose::io {
namespace {

/// Pictures of one model, together.
constexpr std::uint64_t k_most_picture_bytes = std::uint64_t{1} << 30;
/// A picture of a few bytes may say that it is a huge one: px that are always taken, and px for each byte.
constexpr std::uint64_t k_always_px = 10'000'000;
constexpr std::uint64_t k_px_of_byte = 400;

constexpr std::size_t k_unknown = static_cast<std::size_t>(-1);
constexpr std::size_t k_refused = static_cast<std::size_t>(-2);

base::Error cannot(std::string why) { return {std::move(why), "", ""}; }

/// Names in files may be of any length.
std::string short_name(const std::string& name) {
  constexpr std::size_t k_most_shown = 60;
  if (name.size() <= k_most_shown) return name;
  return "..." + base::valid_utf8(name.substr(name.size() - k_most_shown));
}

}  // namespace

std::optional<std::size_t> GltfPictures::find(std::size_t index) {
  const json::Json* images = member(&document_.json, "images");
  const json::Json* image = item(images, index);
  if (image == nullptr) return refuse("image " + std::to_string(index), "missing in the file");
  if (known_.empty()) known_.resize(images->size(), k_unknown);
  if (known_[index] == k_unknown) {
    const auto taken = take(*image, index);
    known_[index] = taken ? *taken : k_refused;
  }
  return known_[index] == k_refused ? std::nullopt : std::optional(known_[index]);
}

std::nullopt_t GltfPictures::refuse(const std::string& name, const std::string& why) {
  look_.undrawn.push_back(short_name(name) + " (" + why + ")");
  return std::nullopt;
}

base::Result<document::KeptBytes> GltfPictures::bytes_of(const json::Json& image) const {
  if (const auto view_index = index_of(&image, "bufferView")) {
    const auto& views = document_.model.bufferViews;
    if (*view_index >= views.size()) return cannot("its buffer view does not exist");
    const tinygltf::BufferView& view = views[*view_index];
    const base::Bytes buffer = document_.buffers[static_cast<std::size_t>(view.buffer)];
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
      return cannot("reaches past the end of its buffer");
    const base::Bytes bytes = buffer.subspan(view.byteOffset, view.byteLength);
    const base::Bytes file = document_.file ? base::Bytes(*document_.file) : base::Bytes();
    const bool stays = !bytes.empty() && !file.empty() && bytes.data() >= file.data() &&
                       bytes.data() + bytes.size() <= file.data() + file.size();
    if (stays) return document::KeptBytes(document_.file, bytes);
    return document::KeptBytes(std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end()));
  }
  const json::Json* uri = json::find(image, "uri");
  if (uri == nullptr || !uri->is_string()) return cannot("no data");
  const auto& text = uri->get_ref<const std::string&>();
  auto read = read_uri(text, "", resolve_);
  if (read) return document::KeptBytes(std::make_shared<const std::vector<std::uint8_t>>(std::move(read).value()));
  return cannot(text.starts_with("data:") ? "damaged data: URI" : "missing; put it beside the model");
}

std::optional<std::size_t> GltfPictures::take(const json::Json& image, std::size_t index) {
  std::string name = text_of(&image, "name");
  const std::string uri = text_of(&image, "uri");
  if (!uri.empty() && !uri.starts_with("data:")) name = uri;
  const std::string called = name.empty() ? "image " + std::to_string(index) : name;
  auto bytes = bytes_of(image);
  if (!bytes) return refuse(called, bytes.error().what);
  const std::size_t size = bytes->view().size();
  const auto head = read_picture_head(bytes->view());
  if (!head) return refuse(called, "no PNG, JPEG or WebP");
  if (head->mime_type == "image/ktx2") return refuse(called, "KTX2; export it as PNG, JPEG or WebP");
  if (!head->whole) return refuse(called, "cut off");
  const std::uint64_t px = std::uint64_t{head->width} * head->height;
  if (px == 0 || px > k_most_picture_px || px > k_always_px + k_px_of_byte * size)
    return refuse(called, std::to_string(head->width) + " x " + std::to_string(head->height) + " px; too " +
                              (px == 0 ? "small" : "large"));
  if (held_ + size > k_most_picture_bytes) return refuse(called, "more than fits");
  held_ += size;
  look_.images.push_back({std::move(name), head->mime_type, std::move(bytes).value(), head->width, head->height});
  return look_.images.size() - 1;
}

}  // namespace penpose::io
