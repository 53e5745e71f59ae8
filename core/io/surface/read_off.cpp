#include "core/io/surface/read_off.h"

#include <array>
#include <optional>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/model/model_formats.h"
#include "core/io/remedies.h"
#include "core/io/surface/polygon.h"
#include "core/io/surface/surface_model.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {
namespace {

class OffReader {
 public:
  explicit OffReader(base::Bytes bytes) : lines_(base::as_text(bytes)) {}

  base::Result<document::Model> read() {
    if (auto status = read_header(); !status) return status.error();
    for (std::size_t i = 0; i < vertices_; ++i) {
      if (auto status = read_vertex(); !status) return status.error();
    }
    for (std::size_t i = 0; i < faces_; ++i) {
      if (auto status = read_face(); !status) return status.error();
    }
    std::vector<std::string> notes;
    if (has_colors_) notes.emplace_back("colours were left out");
    if (has_thin_) notes.emplace_back("points and lines were left out");
    return surface_model(std::move(source_), std::move(notes));
  }

 private:
  base::Status read_header() {
    auto line = lines_.next_content();
    std::string_view content = base::without_mark(line.value_or(""));
    const std::string_view keyword = take_word(content);
    if (!keyword.ends_with("OFF")) return lines_.error("the file does not begin with OFF", "choose an OFF file");
    const std::string_view kind = keyword.substr(0, keyword.size() - 3);
    if (kind != "" && kind != "C" && kind != "N" && kind != "CN") {
      return lines_.error("the kind " + std::string(keyword.substr(0, 12)) + " is not supported",
                          "export the file as plain OFF");
    }
    has_normals_ = kind.ends_with('N');
    has_colors_ = kind.starts_with('C');
    if (base::trim(content).empty()) {
      line = lines_.next_content();
      content = line.value_or("");
    }
    if (base::trim(content).starts_with("BINARY")) {
      return lines_.error("binary OFF is not supported", "export the file as text");
    }
    const auto vertices = base::parse_uint(take_word(content));
    const auto faces = base::parse_uint(take_word(content));
    if (!vertices || !faces) return lines_.error("the counts of vertices and faces were expected", k_export_again);
    // A vertex takes at least 6 characters ("0 0 0" and a line end), a face at least 2.
    const std::size_t left = lines_.rest().size() + 1;
    if (*vertices > left / 6 || *faces > left / 2) {
      return lines_.error("the file is too short for " + std::to_string(*vertices) + " vertices and " +
                              std::to_string(*faces) + " faces",
                          k_export_again);
    }
    vertices_ = static_cast<std::size_t>(*vertices);
    faces_ = static_cast<std::size_t>(*faces);
    source_.positions.reserve(vertices_);
    return base::Done{};
  }

  static std::optional<glm::dvec3> read_vector(std::string_view& line) {
    glm::dvec3 v;
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = parse_coordinate(take_word(line));
      if (!number) return std::nullopt;
      v[axis] = *number;
    }
    return v;
  }

  base::Status read_vertex() {
    auto line = lines_.next_content();
    if (!line) return lines_.error("the file ends before its last vertex", k_export_again);
    const auto position = read_vector(*line);
    const auto normal = has_normals_ ? read_vector(*line) : std::optional(glm::dvec3(0));
    if (!position || !normal) return lines_.error("finite coordinates were expected", k_export_again);
    source_.positions.push_back(*position);
    if (has_normals_) source_.normals.emplace_back(*normal);
    has_colors_ = has_colors_ || !base::trim(*line).empty();
    return base::Done{};
  }

  base::Status read_face() {
    auto line = lines_.next_content();
    if (!line) return lines_.error("the file ends before its last face", k_export_again);
    const auto count = base::parse_uint(take_word(*line));
    if (!count || *count > line->size()) return lines_.error("the number of corners was expected", k_export_again);
    corners_.clear();
    for (std::uint64_t i = 0; i < *count; ++i) {
      const auto vertex = base::parse_uint(take_word(*line));
      if (!vertex || *vertex >= vertices_) {
        return lines_.error("a corner that is no vertex from 0 to " + std::to_string(vertices_ - 1), k_export_again);
      }
      corners_.push_back(static_cast<std::uint32_t>(*vertex));
    }
    has_colors_ = has_colors_ || !base::trim(*line).empty();
    if (corners_.size() < 3) {
      has_thin_ = true;
    } else {
      triangulate(corners_, source_.positions, source_.triangles);
    }
    return base::Done{};
  }

  TextLines lines_;
  mesh::MeshSource source_;
  std::vector<std::uint32_t> corners_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  bool has_normals_ = false;
  bool has_colors_ = false;
  bool has_thin_ = false;
};

}  // namespace

base::Result<document::Model> read_off(base::Bytes bytes) { return OffReader(bytes).read(); }

ModelFormat off_format() {
  return {.name = "OFF",
          .extension = ".off",
          .looks_like =
              [](base::Bytes bytes) {
                const std::string_view text = first_text(bytes);
                const auto word = text.substr(0, std::min<std::size_t>(text.find_first_of(" \t\r\n#"), 8));
                // Letters for colours, normals, texture coordinates and so on may stand in front.
                return word.ends_with("OFF") && word.find_first_not_of("STCN4n") >= word.size() - 3;
              },
          .read = [](base::Bytes bytes, const FileResolver&) { return read_off(bytes); }};
}

}  // namespace penpose::io
