#include "core/io/tracks/values/azure_chunks.h"

#include <algorithm>
#include <cmath>

#include "core/base/json/loose_json.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/bare_values.h"
#include "core/io/tracks/values/value_rows.h"

namespace penpose::io {
namespace {

constexpr double k_azure_fps = 60;

const json::Json* member_of(const json::Json& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const json::Json* found = json::find(object, name);
    if (found != nullptr) return found;
  }
  return nullptr;
}

class ChunkReader {
 public:
  ChunkReader() : clock_(k_azure_fps) {}

  /// Chunks wherever they lie. Returns false where one is wrong.
  bool look(const json::Json& value, const std::string& place, int depth) {
    constexpr int k_deepest = 6;
    if (depth > k_deepest) return true;
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i].is_object() && !look(value[i], json::child(place, i), depth + 1)) return false;
        if (value[i].is_string() && !look_in_text(value[i], json::child(place, i), depth)) return false;
      }
      return true;
    }
    if (!value.is_object()) return true;
    const json::Json* index = member_of(value, {"FrameIndex", "frameIndex", "frame_index"});
    const json::Json* rows = member_of(value, {"BlendShapes", "blendShapes", "blendshapes", "blend_shapes"});
    if (index != nullptr && rows != nullptr && rows->is_array() && !rows->empty() && (*rows)[0].is_array())
      return take(*index, *rows, place);
    for (const auto& [key, inner] : value.items()) {
      const std::string here = json::child(place, key);
      if (inner.is_string() ? !look_in_text(inner, here, depth) : !look(inner, here, depth + 1)) return false;
    }
    return true;
  }

  [[nodiscard]] bool any() const { return !rows_.values.empty(); }
  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }

  base::Result<animation::WeightTrack> finish() {
    rows_.names = usual_names(width_);
    rows_.notes.push_back(usual_names_note(width_));
    auto track = make_value_track(std::move(rows_), clock_);
    // The service documents 60 frames a second.
    if (track) track->rate_note.clear();
    return track;
  }

 private:
  bool look_in_text(const json::Json& value, const std::string& place, int depth) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.find("FrameIndex") == std::string::npos) return true;
    const auto inner = json::parse_loose_json(base::as_bytes(text));
    return !inner || look(*inner, place, depth + 1);
  }

  bool take(const json::Json& index, const json::Json& rows, const std::string& place) {
    double first = json::number(index).value_or(next_);
    if (!(first >= 0 && first < 1e9)) first = next_;
    if (first == 0 && next_ > 0) shift_ += next_;
    for (std::size_t f = 0; f < rows.size(); ++f) {
      const std::string here = json::child(json::child(place, "BlendShapes"), f);
      const json::Json& row = rows[f];
      if (width_ == 0 && row.is_array()) width_ = row.size();
      if (!row.is_array() || row.size() != width_ || usual_names(width_).empty()) {
        error_ = base::Error{"rows of 55 numbers were expected", here, "write the chunks as the service sends them"};
        return false;
      }
      if (rows_.values.size() >= k_most_track_frames) {
        error_ = base::Error{"a track has at most 1,000,000 frames", here, "cut the take"};
        return false;
      }
      auto& values = rows_.values.emplace_back();
      rows_.why.emplace_back();
      rows_.named.push_back("frame " + std::to_string(rows_.named.size()));
      clock_.add("", shift_ + first + static_cast<double>(f));
      for (std::size_t i = 0; i < row.size(); ++i) {
        const auto number = json::number(row[i]);
        if (!number) rows_.holes.push_back({rows_.values.size() - 1, i});
        values.push_back(number && std::abs(*number) < 1e6 ? *number : 0);
      }
    }
    next_ = std::max(first == 0 ? 0 : next_, first + static_cast<double>(rows.size()));
    return true;
  }

  ValueClock clock_;
  ValueRows rows_;
  std::size_t width_ = 0;
  double next_ = 0;   ///< the number of the frame after the last one of its sentence
  double shift_ = 0;  ///< frames of the sentences before
  std::optional<base::Error> error_;
};

}  // namespace

std::optional<base::Result<animation::WeightTrack>> read_azure_chunks(const json::Json& root) {
  ChunkReader reader;
  reader.look(root, "", 0);
  if (reader.error()) return base::Result<animation::WeightTrack>(*reader.error());
  if (!reader.any()) return std::nullopt;
  return reader.finish();
}

}  // namespace penpose::io
