#include "core/io/surface/read_obj.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"
#include "core/io/model/model_formats.h"
#include "core/io/remedies.h"
#include "core/io/surface/polygon.h"
#include "core/io/surface/surface_model.h"
#include "core/io/text/names.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {
namespace {

/// What an "o" line begins.
struct Object {
  std::string name;
  std::uint32_t declared = 0;  ///< vertices before it
  std::uint32_t low = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t high = 0;  ///< lowest and highest vertex that its faces use
  std::vector<mesh::Triangle> triangles;
};

class ObjReader {
 public:
  explicit ObjReader(base::Bytes bytes) : lines_(base::as_text(bytes)) {}

  base::Result<document::Model> read() {
    objects_.emplace_back();
    while (const auto line = lines_.next()) {
      if (auto status = read_line(*line); !status) return status.error();
    }
    if (source_.positions.empty()) {
      return base::Error{"the file has no vertices", "line " + std::to_string(lines_.number()),
                         "choose a file with a mesh"};
    }
    std::erase_if(objects_, [](const Object& object) { return object.triangles.empty(); });
    if (has_normals_) {
      source_.normals.resize(source_.positions.size(), glm::vec3(0));
      for (std::size_t v = 0; v < source_.normals.size(); ++v) {
        if (v < normal_of_.size() && normal_of_[v] >= 0)
          source_.normals[v] = normals_[static_cast<std::size_t>(normal_of_[v])];
      }
    }
    make_parts();
    std::vector<std::string> notes(notes_.begin(), notes_.end());
    return surface_model(std::move(source_), std::move(notes));
  }

 private:
  base::Status read_line(std::string_view line) {
    // A backslash at the end of a line joins it with the next.
    std::string joined;
    while (line.ends_with('\\')) {
      joined += line.substr(0, line.size() - 1);
      joined += ' ';
      const auto more = lines_.next();
      if (!more || !more->ends_with('\\')) {
        joined += more.value_or("");
        line = joined;
        break;
      }
      line = *more;
    }
    std::string_view content = line.substr(0, line.find('#'));
    const std::string_view keyword = take_word(content);
    if (keyword == "v") return read_vector(content, [&](const glm::dvec3& v) { source_.positions.push_back(v); });
    if (keyword == "vn") return read_vector(content, [&](const glm::dvec3& v) { normals_.emplace_back(v); });
    if (keyword == "f") return read_face(content);
    if (keyword == "o") {
      Object object;
      object.name = base::valid_utf8(base::trim(content));
      object.declared = static_cast<std::uint32_t>(source_.positions.size());
      objects_.push_back(std::move(object));
    } else if (keyword == "vt") {
      notes_.insert("texture coordinates were left out");
    } else if (keyword == "usemtl" || keyword == "mtllib") {
      notes_.insert("materials were left out");
    } else if (keyword == "l" || keyword == "p") {
      notes_.insert("points and lines were left out");
    } else if (keyword == "curv" || keyword == "surf" || keyword == "cstype") {
      notes_.insert("free-form curves and surfaces were left out");
    }
    return base::Done{};
  }

  template <typename Take>
  base::Status read_vector(std::string_view content, Take take) {
    glm::dvec3 v;
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = parse_coordinate(take_word(content));
      if (!number) return lines_.error("three finite numbers were expected", k_export_again);
      v[axis] = *number;
    }
    if (source_.positions.size() >= 0x7fffffffU) return lines_.error("the model has too many vertices", "reduce it");
    take(v);
    return base::Done{};
  }

  /// A 1-based number, or one counted back from the end when negative; as 0-based.
  static std::optional<std::uint32_t> resolve(std::string_view text, std::size_t count) {
    const auto number = base::parse_int(text);
    if (!number) return std::nullopt;
    const auto size = static_cast<std::int64_t>(count);
    if (*number < -size || *number > size || *number == 0) return std::nullopt;
    return static_cast<std::uint32_t>(*number < 0 ? *number + size : *number - 1);
  }

  base::Status read_face(std::string_view content) {
    corners_.clear();
    for (std::string_view word = take_word(content); !word.empty(); word = take_word(content)) {
      const std::size_t slash = word.find('/');
      const auto vertex = resolve(word.substr(0, slash), source_.positions.size());
      if (!vertex) {
        return lines_.error("the face names vertex \"" + std::string(word.substr(0, slash)) + "\", but there are " +
                                std::to_string(source_.positions.size()) + " vertices so far",
                            k_export_again);
      }
      const std::size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
      if (second != std::string_view::npos && second + 1 < word.size()) {
        const auto normal = resolve(word.substr(second + 1), normals_.size());
        if (!normal) return lines_.error("the face names a normal that does not exist", k_export_again);
        note_normal(*vertex, *normal);
      }
      corners_.push_back(*vertex);
    }
    if (corners_.size() < 3) return lines_.error("the face has less than three corners", k_export_again);
    Object& object = objects_.back();
    for (const std::uint32_t v : corners_) {
      object.low = std::min(object.low, v);
      object.high = std::max(object.high, v);
    }
    triangulate(corners_, source_.positions, object.triangles);
    return base::Done{};
  }

  /// A vertex keeps its normal as long as all corners agree.
  void note_normal(std::uint32_t vertex, std::uint32_t normal) {
    constexpr std::int64_t k_unknown = -1;
    constexpr std::int64_t k_conflict = -2;
    has_normals_ = true;
    if (normal_of_.size() <= vertex) normal_of_.resize(source_.positions.size(), k_unknown);
    std::int64_t& known = normal_of_[vertex];
    if (known == k_unknown) {
      known = normal;
    } else if (known >= 0 && normals_[static_cast<std::size_t>(known)] != normals_[normal]) {
      known = k_conflict;
    }
  }

  /// One part an object where their vertices do not mix, else one part.
  void make_parts() {
    std::stable_sort(objects_.begin(), objects_.end(), [](const Object& a, const Object& b) { return a.low < b.low; });
    bool apart = true;
    for (std::size_t i = 1; i < objects_.size(); ++i) apart = apart && objects_[i - 1].high < objects_[i].low;
    std::vector<std::string> names;
    for (const Object& object : objects_) names.push_back(object.name);
    make_unique(names);
    const auto vertices = static_cast<std::uint32_t>(source_.positions.size());
    if (!apart) notes_.insert("objects that share vertices became one part");
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const Object& object = objects_[i];
      const auto first_triangle = static_cast<std::uint32_t>(source_.triangles.size());
      source_.triangles.insert(source_.triangles.end(), object.triangles.begin(), object.triangles.end());
      if (!apart) continue;
      mesh::Part part{names[i], 0, 0, first_triangle, static_cast<std::uint32_t>(object.triangles.size())};
      if (i > 0) {
        // Vertices that nothing uses belong to the object below whose line they stand.
        const bool declared = object.declared > objects_[i - 1].high && object.declared <= object.low;
        part.first_vertex = declared ? object.declared : object.low;
        mesh::Part& previous = source_.parts.back();
        previous.vertex_count = part.first_vertex - previous.first_vertex;
      }
      part.vertex_count = vertices - part.first_vertex;
      source_.parts.push_back(std::move(part));
    }
  }

  TextLines lines_;
  mesh::MeshSource source_;
  std::vector<Object> objects_;
  std::vector<glm::vec3> normals_;
  std::vector<std::int64_t> normal_of_;
  std::vector<std::uint32_t> corners_;
  std::set<std::string> notes_;
  bool has_normals_ = false;
};

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

base::Result<document::Model> read_obj(base::Bytes bytes) { return ObjReader(bytes).read(); }

ModelFormat obj_format() {
  return {.name = "OBJ",
          .extension = ".obj",
          .looks_like = [](base::Bytes bytes) { return looks_like_obj(first_text(bytes)); },
          .read = [](base::Bytes bytes, const FileResolver&) { return read_obj(bytes); },
          .write = [](const document::Model& model, const WriteOptions&, WriteReport&) { return write_obj(model); },
          .holds = "This pose alone",
          .detail = "The face as it is now"};
}

}  // namespace penpose::io
