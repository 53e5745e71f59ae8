#include "core/io/surface/read_stl.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"
#include "core/io/model/model_formats.h"
#include "core/io/remedies.h"
#include "core/io/surface/surface_model.h"
#include "core/io/text/names.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {
namespace {

/// Gathers loose triangles and makes corners at one place one vertex.
class Soup {
 public:
  void begin_solid(std::string name) {
    known_.clear();
    names_.push_back(std::move(name));
    source_.parts.push_back({"", static_cast<std::uint32_t>(source_.positions.size()), 0,
                             static_cast<std::uint32_t>(source_.triangles.size()), 0});
  }
  void add(const std::array<std::array<float, 3>, 3>& corners) {
    mesh::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      // Adding zero makes the two zeros one.
      const std::array<float, 3> key{corners[i][0] + 0.0F, corners[i][1] + 0.0F, corners[i][2] + 0.0F};
      const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(source_.positions.size()));
      if (is_new) source_.positions.emplace_back(key[0], key[1], key[2]);
      triangle[i] = at->second;
    }
    source_.triangles.push_back(triangle);
  }
  base::Result<document::Model> finish() {
    make_unique(names_);
    for (std::size_t i = 0; i < source_.parts.size(); ++i) {
      mesh::Part& part = source_.parts[i];
      const bool last = i + 1 == source_.parts.size();
      part.name = names_[i];
      part.vertex_count =
          (last ? static_cast<std::uint32_t>(source_.positions.size()) : source_.parts[i + 1].first_vertex) -
          part.first_vertex;
      part.triangle_count =
          (last ? static_cast<std::uint32_t>(source_.triangles.size()) : source_.parts[i + 1].first_triangle) -
          part.first_triangle;
    }
    std::erase_if(source_.parts, [](const mesh::Part& part) { return part.triangle_count == 0; });
    return surface_model(std::move(source_), {});
  }

 private:
  mesh::MeshSource source_;
  std::vector<std::string> names_;
  std::map<std::array<float, 3>, std::uint32_t> known_;
};

base::Result<document::Model> read_binary(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  const auto count = reader.seek(80) ? reader.read<std::uint32_t>() : std::nullopt;
  if (!count) return base::Error{"the header is cut off", "byte offset " + std::to_string(bytes.size()), k_copy_again};
  if (*count > reader.remaining() / 50) {
    return base::Error{"the file says " + std::to_string(*count) + " triangles, but there is room for " +
                           std::to_string(reader.remaining() / 50),
                       "byte offset 80", k_copy_again};
  }
  Soup soup;
  soup.begin_solid("");
  for (std::uint32_t t = 0; t < *count; ++t) {
    const std::size_t offset = reader.offset();
    (void)reader.take(12);  // the normal, which follows from the corners
    std::array<std::array<float, 3>, 3> corners{};
    for (auto& corner : corners) {
      for (float& coordinate : corner) {
        coordinate = reader.read_f32().value_or(0.0F);
        if (std::isfinite(coordinate)) continue;
        return base::Error{"a coordinate of triangle " + std::to_string(t) + " is not a finite number",
                           "byte offset " + std::to_string(offset), "export the model again without NaN"};
      }
    }
    (void)reader.take(2);
    soup.add(corners);
  }
  return soup.finish();
}

base::Result<document::Model> read_text(base::Bytes bytes) {
  TextLines lines(base::as_text(bytes));
  Soup soup;
  std::array<std::array<float, 3>, 3> corners{};
  std::size_t corner = 0;
  bool in_solid = false;
  while (const auto line = lines.next()) {
    std::string_view content = *line;
    const std::string_view keyword = take_word(content);
    if (keyword == "solid") {
      soup.begin_solid(base::valid_utf8(base::trim(content)));
      in_solid = true;
    } else if (keyword == "vertex") {
      if (!in_solid || corner >= 3) return lines.error("a vertex outside a facet of three", k_copy_again);
      for (float& coordinate : corners[corner]) {
        const auto number = parse_coordinate(take_word(content));
        if (!number) return lines.error("three finite numbers were expected", k_copy_again);
        coordinate = static_cast<float>(*number);
      }
      ++corner;
    } else if (keyword == "endfacet") {
      if (corner != 3) return lines.error("a facet without three vertices", k_copy_again);
      soup.add(corners);
      corner = 0;
    }
  }
  if (corner != 0) return lines.error("the file ends inside a facet", k_copy_again);
  return soup.finish();
}

/// A binary file has no mark of its own, but a size that follows from its count: 84 bytes and 50 a triangle.
bool is_binary(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  if (!reader.seek(80)) return false;
  const auto count = reader.read<std::uint32_t>();
  return count && *count > 0 && bytes.size() == 84 + 50 * std::uint64_t{*count};
}

bool starts_a_text(base::Bytes bytes) {
  std::string_view text = base::without_mark(base::as_text(bytes));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text.starts_with("solid") && text.find("facet") != std::string_view::npos;
}

}  // namespace

base::Result<document::Model> read_stl(base::Bytes bytes) {
  // A binary file may begin with the word "solid" too; only a text file has facets.
  const std::string_view text = base::as_text(bytes);
  const bool is_text = base::trim(text).starts_with("solid") && text.find("facet") != std::string_view::npos &&
                       text.substr(0, 80).find('\0') == std::string_view::npos;
  return is_text ? read_text(bytes) : read_binary(bytes);
}

ModelFormat stl_format() {
  return {.name = "STL",
          .extension = ".stl",
          .looks_like = [](base::Bytes bytes) { return is_binary(bytes) || starts_a_text(bytes); },
          .read = [](base::Bytes bytes, const FileResolver&) { return read_stl(bytes); }};
}

}  // namespace penpose::io
