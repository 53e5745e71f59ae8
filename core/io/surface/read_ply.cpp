#include "core/io/surface/read_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/numbers.h"
#include "core/io/model/model_formats.h"
#include "core/io/remedies.h"
#include "core/io/surface/polygon.h"
#include "core/io/surface/surface_model.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {
namespace {

enum class Number : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<Number> number_type(std::string_view name) {
  struct Name {
    std::string_view name;
    Number type;
  };
  constexpr auto k_names = std::to_array<Name>({{"char", Number::i8},
                                                {"int8", Number::i8},
                                                {"uchar", Number::u8},
                                                {"uint8", Number::u8},
                                                {"short", Number::i16},
                                                {"int16", Number::i16},
                                                {"ushort", Number::u16},
                                                {"uint16", Number::u16},
                                                {"int", Number::i32},
                                                {"int32", Number::i32},
                                                {"uint", Number::u32},
                                                {"uint32", Number::u32},
                                                {"float", Number::f32},
                                                {"float32", Number::f32},
                                                {"double", Number::f64},
                                                {"float64", Number::f64}});
  const auto found = std::find_if(k_names.begin(), k_names.end(), [&](const Name& n) { return n.name == name; });
  return found == k_names.end() ? std::nullopt : std::optional(found->type);
}

std::size_t size_of(Number type) {
  constexpr std::array<std::size_t, 8> k_sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return k_sizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Number type = Number::f32;
  std::optional<Number> list_count;  ///< the type of the count; nothing: one number
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding : std::uint8_t { text, little, big };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::size_t lines = 0;
  base::Bytes body;
};

base::Status read_property(TextLines& lines, std::string_view line, std::vector<Element>& elements) {
  if (elements.empty()) return lines.error("a property before the first element", k_copy_again);
  Property property;
  std::string_view type = take_word(line);
  if (type == "list") {
    property.list_count = number_type(take_word(line));
    if (!property.list_count || size_of(*property.list_count) > 4 || *property.list_count == Number::f32) {
      return lines.error("a list whose count is no whole number", k_copy_again);
    }
    type = take_word(line);
  }
  const auto number = number_type(type);
  if (!number) return lines.error("the type \"" + std::string(type.substr(0, 20)) + "\" is not known", k_copy_again);
  property.type = *number;
  property.name = take_word(line);
  elements.back().properties.push_back(std::move(property));
  return base::Done{};
}

base::Result<Header> read_header(base::Bytes bytes) {
  Header header;
  TextLines lines(base::as_text(bytes));
  std::optional<Encoding> encoding;
  if (lines.next() != "ply") return lines.error("the file does not begin with ply", "choose a PLY file");
  while (true) {
    const auto next = lines.next();
    if (!next) return lines.error("the header has no end", k_copy_again);
    std::string_view line = *next;
    const std::string_view keyword = take_word(line);
    if (keyword == "end_header") break;
    if (keyword == "format") {
      const std::string_view name = take_word(line);
      if (name == "ascii") encoding = Encoding::text;
      if (name == "binary_little_endian") encoding = Encoding::little;
      if (name == "binary_big_endian") encoding = Encoding::big;
      if (!encoding) return lines.error("the format is not known", k_copy_again);
    } else if (keyword == "element") {
      Element element;
      element.name = take_word(line);
      const auto count = base::parse_uint(take_word(line));
      if (!count) return lines.error("the number of elements was expected", k_copy_again);
      element.count = *count;
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (auto status = read_property(lines, line, header.elements); !status) return status.error();
    }
  }
  if (!encoding) return lines.error("the header names no format", k_copy_again);
  header.encoding = *encoding;
  header.lines = lines.number();
  header.body = base::as_bytes(lines.rest());
  return header;
}

/// Gives one number after the other, whatever the encoding. Whole numbers up to 32 bits are exact in a double.
class NumberSource {
 public:
  NumberSource(const Header& header, std::size_t file_size)
      : encoding_(header.encoding),
        bytes_(header.body),
        lines_(base::as_text(header.body)),
        first_line_(header.lines),
        first_byte_(file_size - header.body.size()) {}

  std::optional<double> next(Number type) {
    if (encoding_ == Encoding::text) return next_word();
    auto piece = bytes_.take(size_of(type));
    if (!piece) return std::nullopt;
    std::uint64_t raw = 0;
    for (std::size_t i = 0; i < piece->size(); ++i) {
      const std::size_t shift = encoding_ == Encoding::little ? i : piece->size() - 1 - i;
      raw |= std::uint64_t{(*piece)[i]} << (8 * shift);
    }
    switch (type) {
      case Number::i8:
        return static_cast<std::int8_t>(raw);
      case Number::u8:
        return static_cast<std::uint8_t>(raw);
      case Number::i16:
        return static_cast<std::int16_t>(raw);
      case Number::u16:
        return static_cast<std::uint16_t>(raw);
      case Number::i32:
        return static_cast<std::int32_t>(raw);
      case Number::u32:
        return static_cast<std::uint32_t>(raw);
      case Number::f32:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
      case Number::f64:
        return std::bit_cast<double>(raw);
    }
    return std::nullopt;
  }

  /// At most how many numbers of that type may follow.
  [[nodiscard]] std::uint64_t at_most(Number type) const {
    if (encoding_ != Encoding::text) return bytes_.remaining() / size_of(type);
    return (lines_.rest().size() + word_rest_.size()) / 2 + 1;
  }

  [[nodiscard]] base::Error error(std::string what) const {
    const std::string place = encoding_ == Encoding::text
                                  ? "line " + std::to_string(first_line_ + lines_.number())
                                  : "byte offset " + std::to_string(first_byte_ + bytes_.offset());
    return {std::move(what), place, k_copy_again};
  }

 private:
  std::optional<double> next_word() {
    while (true) {
      const std::string_view word = take_word(word_rest_);
      if (!word.empty()) return base::parse_double(word);
      const auto line = lines_.next();
      if (!line) return std::nullopt;
      word_rest_ = *line;
    }
  }

  Encoding encoding_;
  base::ByteReader bytes_;
  TextLines lines_;
  std::string_view word_rest_;
  std::size_t first_line_;
  std::size_t first_byte_;
};

class PlyReader {
 public:
  PlyReader(const Header& header, std::size_t file_size) : header_(header), numbers_(header, file_size) {}

  base::Result<document::Model> read() {
    for (const Element& element : header_.elements) {
      auto status = element.name == "vertex" ? read_vertices(element)
                    : element.name == "face" ? read_faces(element)
                                             : skip(element);
      if (!status) return status.error();
    }
    return finish();
  }

 private:
  /// Refuses counts that the rest of the file cannot hold.
  base::Status check_count(const Element& element) {
    if (element.count == 0) return base::Done{};
    if (element.properties.empty()) return numbers_.error("element " + element.name + " has no properties");
    const Property& first = element.properties.front();
    if (element.count > numbers_.at_most(first.list_count.value_or(first.type))) {
      return numbers_.error("the file is too short for " + std::to_string(element.count) + " elements " + element.name);
    }
    return base::Done{};
  }

  base::Status skip_property(const Property& property) {
    const auto failed = [&] {
      return numbers_.error("the file ends inside its data, or has a word that is no number");
    };
    std::uint64_t count = 1;
    if (property.list_count) {
      const auto listed = numbers_.next(*property.list_count);
      if (!listed || !(*listed >= 0.0) || *listed > static_cast<double>(numbers_.at_most(property.type)))
        return failed();
      count = static_cast<std::uint64_t>(*listed);
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!numbers_.next(property.type)) return failed();
    }
    return base::Done{};
  }

  base::Status skip(const Element& element) {
    if (auto status = check_count(element); !status) return status;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (auto status = skip_property(property); !status) return status;
      }
    }
    return base::Done{};
  }

  base::Status read_vertices(const Element& element) {
    if (auto status = check_count(element); !status) return status;
    if (!source_.positions.empty()) return numbers_.error("a second element vertex");
    // Where a property goes: 0..2 position, 3..5 normal, nothing else.
    constexpr std::array<std::string_view, 6> k_names = {"x", "y", "z", "nx", "ny", "nz"};
    std::vector<std::optional<std::size_t>> place;
    std::array<bool, 6> has{};
    for (const Property& property : element.properties) {
      const auto found = std::find(k_names.begin(), k_names.end(), property.name);
      place.emplace_back();
      if (property.name == "red" || property.name == "r") has_colors_ = true;
      if (found == k_names.end() || property.list_count) continue;
      place.back() = static_cast<std::size_t>(found - k_names.begin());
      has[*place.back()] = true;
    }
    // Scenes of Gaussian splats come as PLY too.
    const auto holds = [&](std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const Property& property) { return property.name == name; });
    };
    if (holds("packed_position") || holds("f_dc_0")) {
      return base::Error{"this is a scene of Gaussian splats, not a mesh", "header",
                         "choose a file with a mesh; splats are no surface"};
    }
    if (!has[0] || !has[1] || !has[2]) return numbers_.error("the vertices have no x, y and z");
    const bool normals = has[3] && has[4] && has[5];
    for (std::uint64_t v = 0; v < element.count; ++v) {
      std::array<double, 6> values{};
      for (std::size_t p = 0; p < place.size(); ++p) {
        const Property& property = element.properties[p];
        if (!place[p]) {
          if (auto status = skip_property(property); !status) return status;
          continue;
        }
        const auto value = numbers_.next(property.type);
        if (!value)
          return numbers_.error("vertex " + std::to_string(v) + " ends early or has a word that is no number");
        const bool fits = std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max());
        if (!fits && *place[p] < 3) {
          return numbers_.error("the position of vertex " + std::to_string(v) + " is not a finite number");
        }
        values[*place[p]] = fits ? *value : 0.0;
      }
      source_.positions.emplace_back(values[0], values[1], values[2]);
      if (normals) source_.normals.emplace_back(values[3], values[4], values[5]);
    }
    return base::Done{};
  }

  base::Status read_faces(const Element& element) {
    if (auto status = check_count(element); !status) return status;
    for (std::uint64_t f = 0; f < element.count; ++f) {
      for (const Property& property : element.properties) {
        const bool is_corners =
            property.list_count && (property.name == "vertex_indices" || property.name == "vertex_index");
        auto status = is_corners ? read_corners(property, f) : skip_property(property);
        if (!status) return status;
      }
    }
    return base::Done{};
  }

  base::Status read_corners(const Property& property, std::uint64_t face) {
    const auto count = numbers_.next(*property.list_count);
    if (!count || !(*count >= 0.0) || *count > static_cast<double>(numbers_.at_most(property.type)) ||
        *count != std::floor(*count)) {
      return numbers_.error("face " + std::to_string(face) + " has more corners than the file");
    }
    const std::size_t first = corners_.size();
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(*count); ++i) {
      const auto vertex = numbers_.next(property.type);
      // Faces may come before their vertices; the bounds are checked at the end.
      if (!vertex || !(*vertex >= 0.0) || *vertex > 4294967295.0 || *vertex != std::floor(*vertex)) {
        return numbers_.error("face " + std::to_string(face) + " has a corner that is no vertex");
      }
      corners_.push_back(static_cast<std::uint32_t>(*vertex));
    }
    face_size_.push_back(corners_.size() - first);
    return base::Done{};
  }

  base::Result<document::Model> finish() {
    std::size_t first = 0;
    bool thin = false;
    for (std::size_t f = 0; f < face_size_.size(); ++f) {
      const auto corners = std::span(corners_).subspan(first, face_size_[f]);
      first += face_size_[f];
      for (const std::uint32_t v : corners) {
        if (v < source_.positions.size()) continue;
        return base::Error{"the face names vertex " + std::to_string(v) + ", but there are " +
                               std::to_string(source_.positions.size()) + " vertices",
                           "face " + std::to_string(f), k_copy_again};
      }
      if (corners.size() < 3) {
        thin = true;
      } else {
        triangulate(corners, source_.positions, source_.triangles);
      }
    }
    std::vector<std::string> notes;
    if (has_colors_) notes.emplace_back("vertex colours were left out");
    if (thin) notes.emplace_back("faces of less than three corners were left out");
    return surface_model(std::move(source_), std::move(notes));
  }

  const Header& header_;
  NumberSource numbers_;
  mesh::MeshSource source_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> face_size_;
  bool has_colors_ = false;
};

}  // namespace

base::Result<document::Model> read_ply(base::Bytes bytes) {
  const auto header = read_header(bytes);
  if (!header) return header.error();
  return PlyReader(*header, bytes.size()).read();
}

ModelFormat ply_format() {
  return {.name = "PLY",
          .extension = ".ply",
          .looks_like =
              [](base::Bytes bytes) {
                const std::string_view text = base::as_text(bytes);
                return text.starts_with("ply\n") || text.starts_with("ply\r");
              },
          .read = [](base::Bytes bytes, const FileResolver&) { return read_ply(bytes); }};
}

}  // namespace penpose::io
