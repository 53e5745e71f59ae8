#include "core/io/model/formats.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::io {
namespace {

/// A binary STL file has no mark of its own, but a size that follows from its count: 84 bytes and 50 a triangle.
bool is_binary_stl(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  if (!reader.seek(80)) return false;
  const auto count = reader.read<std::uint32_t>();
  return count && *count > 0 && bytes.size() == 84 + 50 * std::uint64_t{*count};
}

/// OFF with its letters for colours, normals, texture coordinates and so on in front.
bool is_off_keyword(std::string_view word) {
  return word.ends_with("OFF") && word.find_first_not_of("STCN4n", 0) >= word.size() - 3;
}

bool looks_like_obj(std::string_view text) {
  constexpr std::array<std::string_view, 6> k_starts = {"v ", "o ", "g ", "mtllib ", "vn ", "v\t"};
  for (int line = 0; line < 100 && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view content = base::trim(text.substr(0, end));
    if (std::any_of(k_starts.begin(), k_starts.end(), [&](auto start) { return content.starts_with(start); }))
      return true;
    if (!content.empty() && content.front() != '#') return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace

std::optional<Format> format_of_name(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string extension = base::lower_case(file_name.substr(dot + 1));
  constexpr std::array<std::pair<std::string_view, Format>, 6> k_names = {{{"glb", Format::glb},
                                                                           {"gltf", Format::gltf},
                                                                           {"obj", Format::obj},
                                                                           {"ply", Format::ply},
                                                                           {"off", Format::off},
                                                                           {"stl", Format::stl}}};
  for (const auto& [name, format] : k_names) {
    if (extension == name) return format;
  }
  return std::nullopt;
}

std::optional<Format> format_of_content(base::Bytes bytes) {
  std::string_view text = base::as_text(bytes);
  if (text.starts_with("glTF")) return Format::glb;
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return Format::ply;
  if (is_binary_stl(bytes)) return Format::stl;
  text = base::without_mark(text);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("{")) return Format::gltf;
  if (is_off_keyword(text.substr(0, std::min<std::size_t>(text.find_first_of(" \t\r\n#"), 8)))) return Format::off;
  if (text.starts_with("solid") && text.find("facet") != std::string_view::npos) return Format::stl;
  if (looks_like_obj(text)) return Format::obj;
  return std::nullopt;
}

}  // namespace penpose::io
