#include "core/io/gltf/write/plain_textures.h"

#include <algorithm>
#include <limits>

#include "core/base/json/json.h"
#include "core/picture/decode_picture.h"

namespace penpose::io {
namespace {

constexpr std::uint32_t k_glb = 0x46546c67, k_json = 0x4e4f534a, k_bin = 0x004e4942;
constexpr const char* k_webp = "EXT_texture_webp";
constexpr int k_most_px = 16384;

void put_word(std::vector<std::uint8_t>& out, std::size_t word) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

std::size_t number_in(const json::Json& object, const char* name, std::size_t otherwise) {
  const json::Json* value = json::find(object, name);
  const auto number = value == nullptr ? std::nullopt : json::whole_number(*value, 0, std::int64_t{1} << 40);
  return number ? static_cast<std::size_t>(*number) : otherwise;
}

bool is_webp(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  return text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP");
}

class PlainTextures {
 public:
  PlainTextures(json::Json& root, std::vector<std::uint8_t>& binary, std::vector<std::string>& notes)
      : root_(root), binary_(binary), notes_(notes) {}

  void run() {
    if (!root_.contains("images")) return;
    std::vector<bool> plain(root_["images"].size(), true);
    for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = make_plain(i);
    bool any_left = false;
    for (std::size_t t = 0; root_.contains("textures") && t < root_["textures"].size(); ++t)
      any_left = !use_plain(root_["textures"][t], plain) || any_left;
    if (!any_left) forget_extension();
    if (root_.contains("buffers") && !root_["buffers"].empty()) root_["buffers"][0]["byteLength"] = binary_.size();
  }

 private:
  /// Returns whether an image is one that every program shows; it was made one where it was not.
  bool make_plain(std::size_t index) {
    json::Json& image = root_["images"][index];
    const json::Json* type = json::find(image, "mimeType");
    const bool said = type != nullptr && *type == "image/webp";
    if (!image.contains("bufferView")) {
      if (said) notes_.push_back("image " + std::to_string(index) + " lies in a file of its own and stays WebP");
      return !said;
    }
    json::Json& view = root_["bufferViews"][image["bufferView"].get<std::size_t>()];
    const std::size_t from = number_in(view, "byteOffset", 0), size = number_in(view, "byteLength", 0);
    if (number_in(view, "buffer", 0) != 0 || from + size > binary_.size()) return !said;
    const base::Bytes bytes = base::Bytes(binary_).subspan(from, size);
    if (!is_webp(bytes)) return true;
    const auto decoded = picture::decode_picture(bytes, k_most_px);
    const auto png = decoded ? picture::encode_png(*decoded) : base::Result<std::vector<std::uint8_t>>(decoded.error());
    if (!png) {
      notes_.push_back("image " + std::to_string(index) + " stays WebP: " + png.error().what);
      return false;
    }
    // A view of its own: another image, or none, may share the old one.
    while (binary_.size() % 4 != 0) binary_.push_back(0);
    json::Json own = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", png->size()}};
    binary_.insert(binary_.end(), png->begin(), png->end());
    image["bufferView"] = root_["bufferViews"].size();
    root_["bufferViews"].push_back(std::move(own));
    image["mimeType"] = "image/png";
    return true;
  }

  /// Returns whether a texture needs the extension no more.
  static bool use_plain(json::Json& texture, const std::vector<bool>& plain) {
    if (!texture.contains("extensions") || !texture["extensions"].contains(k_webp)) return true;
    const json::Json& webp = texture["extensions"][k_webp];
    const std::size_t source = number_in(webp, "source", plain.size());
    if (source >= plain.size() || !plain[source]) return false;
    texture["source"] = source;
    texture["extensions"].erase(k_webp);
    if (texture["extensions"].empty()) texture.erase("extensions");
    return true;
  }

  void forget_extension() {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      if (!root_.contains(list)) continue;
      json::Json kept = json::Json::array();
      for (const json::Json& name : root_[list]) {
        if (name != k_webp) kept.push_back(name);
      }
      root_.erase(list);
      if (!kept.empty()) root_[list] = std::move(kept);
    }
  }

  json::Json& root_;
  std::vector<std::uint8_t>& binary_;
  std::vector<std::string>& notes_;
};

}  // namespace

base::Result<std::vector<std::uint8_t>> with_plain_textures(base::Bytes glb, std::vector<std::string>& notes) {
  constexpr std::size_t k_header = 12, k_chunk = 8;
  base::ByteReader reader(glb);
  reader.seek(k_header);
  const auto json_size = reader.read<std::uint32_t>();
  reader.seek(k_header + k_chunk);
  const auto text = json_size ? reader.take(*json_size) : std::nullopt;
  auto root = text ? json::parse_json(*text) : base::Result<json::Json>(base::Error{"there is no JSON chunk", "", ""});
  if (!root) return root.error();
  std::vector<std::uint8_t> binary;
  if (const auto size = reader.read<std::uint32_t>(); size && reader.read<std::uint32_t>()) {
    if (const auto bytes = reader.take(*size)) binary.assign(bytes->begin(), bytes->end());
  }
  PlainTextures(*root, binary, notes).run();
  std::string out_text = root->dump();
  while (out_text.size() % 4 != 0) out_text += ' ';
  while (binary.size() % 4 != 0) binary.push_back(0);
  const std::size_t whole = k_header + k_chunk + out_text.size() + (binary.empty() ? 0 : k_chunk + binary.size());
  if (whole > std::numeric_limits<std::uint32_t>::max())
    return base::Error{"a .glb file holds at most 4 GiB", "", "write it without plain textures"};
  std::vector<std::uint8_t> out;
  out.reserve(whole);
  for (const std::size_t word : {std::size_t{k_glb}, std::size_t{2}, whole, out_text.size(), std::size_t{k_json}})
    put_word(out, word);
  out.insert(out.end(), out_text.begin(), out_text.end());
  if (binary.empty()) return out;
  put_word(out, binary.size());
  put_word(out, k_bin);
  out.insert(out.end(), binary.begin(), binary.end());
  return out;
}

}  // namespace penpose::io
