#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/azure_chunks.h"
#include "core/io/tracks/values/bare_values.h"
#include "core/io/tracks/values/json_values.h"
#include "core/io/tracks/values/value_names.h"
#include "core/io/tracks/values/value_rows.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {
namespace {

using json::Json;
using ValueProblem = std::optional<base::Error>;

constexpr std::size_t k_most_names = 10'000;

base::Error wrong_values(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer),
          "export the take again: MediaPipe's faceBlendshapes, or Audio2Face's facsNames and weightMat"};
}

/// The first member that an object has of some names, and which it is.
const Json* first_of(const Json& object, std::initializer_list<const char*> names, std::string* name = nullptr) {
  for (const char* one : names) {
    const Json* found = json::find(object, one);
    if (found == nullptr || found->is_null()) continue;
    if (name != nullptr) *name = one;
    return found;
  }
  return nullptr;
}

const Json* scores_of(const Json& object, std::string* name = nullptr) {
  return first_of(object,
                  {"faceBlendshapes", "face_blendshapes", "blendShapes", "blendshapes", "blend_shapes", "BlendShapes",
                   "categories", "weights", "Weights", "scores", "shapes", "values"},
                  name);
}

const Json* names_of(const Json& object) {
  const Json* names = first_of(object, {"facsNames", "blendShapeNames", "blendshapeNames", "blend_shape_names",
                                        "shapeNames", "blendShapes", "blendshapes", "blend_shapes", "names", "Names"});
  const bool texts = names != nullptr && names->is_array() && !names->empty() &&
                     std::all_of(names->begin(), names->end(), [](const Json& name) { return name.is_string(); });
  return texts ? names : nullptr;
}

/// What programs wrap the scores of a frame in: page listeners, services, streams to game engines.
const Json* wrapped_in(const Json& frame, std::string& name) {
  const Json* inner = first_of(
      frame,
      {"results", "result", "faceLandmarkerResult", "face_landmarker_result", "Audio2Face", "Facial", "face", "data"},
      &name);
  return inner != nullptr && inner->is_object() ? inner : nullptr;
}

/// Collects rows whose names come as they please.
class Rows {
 public:
  explicit Rows(double fps) : fps_(fps), clock_(fps > 0 ? fps : k_common_fps) {}

  void begin(std::string named) {
    rows_.named.push_back(std::move(named));
    rows_.why.emplace_back();
    rows_.values.emplace_back();
  }
  void hold(std::string why) { rows_.why.back() = std::move(why); }
  ValueProblem set(std::string_view name, const Json& value, const std::string& place) {
    if (base::same_but_case(name, "_neutral")) return std::nullopt;
    auto at = index_.find(name);
    if (at == index_.end()) {
      if (rows_.names.size() >= k_most_names) return wrong_values("a take has at most 10,000 names", place);
      at = index_.emplace(std::string(name), rows_.names.size()).first;
      rows_.names.emplace_back(name);
    }
    auto& values = rows_.values.back();
    if (at->second >= values.size()) {
      held_ += at->second + 1 - values.size();
      if (held_ > k_most_values) return wrong_values("a take has at most 50,000,000 values", place);
      values.resize(at->second + 1);
    }
    const auto number = json::number(value);
    const bool hole = value.is_null() || (value.is_string() && is_hole(value.get_ref<const std::string&>()));
    if (!number || !(std::abs(*number) < 1e6)) {
      if (!hole && !value.is_number()) return wrong_values("a number was expected", place);
      if (!hole) hold("a value is missing or no number");
      if (hole) rows_.holes.push_back({rows_.values.size() - 1, at->second});
      return std::nullopt;
    }
    values[at->second] = *number;
    return std::nullopt;
  }
  void tell_time(const Json& frame) {
    std::string name;
    const Json* told = first_of(
        frame, {"timestamp_ms", "timestampMs", "timestamp", "timeCode", "time_code", "timecode", "time", "time_s", "t"},
        &name);
    timed_ = timed_ || told != nullptr;
    if (told != nullptr && told->is_string()) {
      const auto& text = told->get_ref<const std::string&>();
      return clock_.add(text, base::parse_double(text));
    }
    clock_.add("", told == nullptr ? std::nullopt : json::number(*told));
  }
  void untimed() { clock_.add("", std::nullopt); }
  void note(std::string text) { rows_.notes.push_back(std::move(text)); }
  [[nodiscard]] std::size_t count() const { return rows_.values.size(); }
  [[nodiscard]] bool any_name() const { return !rows_.names.empty(); }

  base::Result<animation::WeightTrack> finish() {
    if (rows_.values.size() * rows_.names.size() > k_most_values)
      return wrong_values("a take has at most 50,000,000 values", "");
    for (std::size_t f = 0; f < rows_.values.size(); ++f) rows_.values[f].resize(rows_.names.size());
    std::vector<std::string_view> names(rows_.names.begin(), rows_.names.end());
    std::vector<std::string> plain = plain_names(names);
    rows_.names = std::move(plain);
    auto track = make_value_track(std::move(rows_), clock_);
    if (track && fps_ > 0 && !timed_) track->rate_note.clear();
    return track;
  }

 private:
  double fps_;
  ValueClock clock_;
  bool timed_ = false;
  ValueRows rows_;
  std::map<std::string, std::size_t, std::less<>> index_;
  std::size_t held_ = 0;
};

class ValueReader {
 public:
  ValueReader(Rows& rows, const Json* names) : rows_(rows), names_(names) {}

  ValueProblem read_frame(const Json& frame, const std::string& place, std::size_t number) {
    rows_.begin("frame " + std::to_string(number));
    if (!frame.is_object()) {
      rows_.untimed();
      if (frame.is_null()) rows_.hold("the tracker found no face");
      return frame.is_null() ? std::nullopt : read_scores(frame, place);
    }
    rows_.tell_time(frame);
    return read_members(frame, place, 0);
  }

  /// Values by name, categories with scores, numbers in the order of the file's names, or a list of faces with any of
  /// these, of which the first counts.
  ValueProblem read_scores(const Json& scores, const std::string& place) {
    if (scores.is_object()) {
      std::string name;
      if (const Json* inner = first_of(scores, {"categories", "values", "weights"}, &name);
          inner != nullptr && !inner->is_number()) {
        return read_scores(*inner, json::child(place, name));
      }
      for (const auto& [key, value] : scores.items()) {
        if (auto problem = rows_.set(key, value, json::child(place, key))) return problem;
      }
      if (scores.empty()) rows_.hold("the tracker found no face");
      return std::nullopt;
    }
    if (!scores.is_array()) return wrong_values("a list or an object of scores was expected", place);
    if (scores.empty()) {
      rows_.hold("the tracker found no face");
      return std::nullopt;
    }
    if (scores[0].is_number() || scores[0].is_null()) return read_numbers(scores, place);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const std::string here = json::child(place, i);
      const Json* name =
          first_of(scores[i], {"categoryName", "category_name", "displayName", "display_name", "name", "shape"});
      const Json* score = first_of(scores[i], {"score", "value", "weight"});
      if (name == nullptr || score == nullptr || !name->is_string()) {
        // A list of faces.
        if (i > 0) return wrong_values("a category with its score was expected", here);
        several_ = several_ || scores.size() > 1;
        return read_scores(scores[0], here);
      }
      if (auto problem = rows_.set(name->get_ref<const std::string&>(), *score, here)) return problem;
    }
    return std::nullopt;
  }

  void finish() {
    if (several_) rows_.note("several faces are seen; the first of each frame is followed");
    if (!usual_.empty()) rows_.note(usual_names_note(usual_.size()));
    usual_.clear();
  }

 private:
  /// The scores of a frame, which may lie in what wraps them.
  ValueProblem read_members(const Json& frame, const std::string& place, int depth) {
    std::string name;
    const Json* scores = scores_of(frame, &name);
    // Streams to game engines name the shapes of every frame.
    if (const Json* own = names_of(frame); own != nullptr && own != scores && scores != nullptr) names_ = own;
    if (scores != nullptr) return read_scores(*scores, json::child(place, name));
    constexpr int k_deepest = 3;
    if (const Json* inner = wrapped_in(frame, name); inner != nullptr && depth < k_deepest)
      return read_members(*inner, json::child(place, name), depth + 1);
    bool any = false;
    for (const auto& [key, value] : frame.items()) {
      if (!value.is_number() || !is_arkit_shape(key)) continue;
      any = true;
      if (auto problem = rows_.set(key, value, json::child(place, key))) return problem;
    }
    if (!any) rows_.hold("it has no scores of blend shapes");
    return std::nullopt;
  }

  ValueProblem read_numbers(const Json& numbers, const std::string& place) {
    if (names_ == nullptr) {
      if (usual_.size() != numbers.size()) usual_ = usual_names(numbers.size());
      if (usual_.empty())
        return wrong_values("there is no list of names for these " + std::to_string(numbers.size()) + " numbers",
                            place);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (auto problem = rows_.set(usual_[i], numbers[i], json::child(place, i))) return problem;
      }
      return std::nullopt;
    }
    if (numbers.size() != names_->size()) {
      return wrong_values(std::to_string(numbers.size()) + " numbers for " + std::to_string(names_->size()) + " names",
                          place);
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (auto problem = rows_.set((*names_)[i].get_ref<const std::string&>(), numbers[i], json::child(place, i))) {
        return problem;
      }
    }
    return std::nullopt;
  }

  Rows& rows_;
  const Json* names_;
  std::vector<std::string> usual_;  ///< of numbers for which the file has no names
  bool several_ = false;
};

/// What lies in a file, wherever its members are: messages of services wrap them several times.
struct FoundValues {
  const Json* names = nullptr;
  const Json* frames = nullptr;  ///< a list of frames
  std::string place;
  std::vector<std::pair<const Json*, std::string>> more;  ///< further lists of frames, as streams have a list a message
};

bool is_frames(const Json& value) {
  if (!value.is_array() || value.empty()) return false;
  const Json& first = value[0];
  return first.is_object() || first.is_array();
}

void look(const Json& value, const std::string& place, std::size_t depth, FoundValues& found) {
  constexpr std::size_t k_deepest = 6;
  if (depth > k_deepest) return;
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size() && i < k_most_track_frames; ++i) {
      if (value[i].is_object()) look(value[i], json::child(place, i), depth + 1, found);
    }
    return;
  }
  if (!value.is_object()) return;
  if (found.names == nullptr) found.names = names_of(value);
  for (const char* name : {"blend_shape_weights", "blendShapeWeights", "weightMat", "weight_mat"}) {
    const Json* list = json::find(value, name);
    if (list != nullptr && is_frames(*list)) found.more.emplace_back(list, json::child(place, name));
  }
  for (const auto& [key, inner] : value.items()) {
    if (inner.is_object() || is_frames(inner)) look(inner, json::child(place, key), depth + 1, found);
  }
}

double rate_of(const Json& root) {
  const Json* given = first_of(root, {"exportFps", "fps", "frameRate", "frame_rate"});
  const auto rate = given == nullptr ? std::nullopt : json::number(*given);
  return rate && *rate > 0 && *rate <= 10000 ? *rate : 0;
}

/// A list a name, an entry a frame.
bool is_by_name(const Json& object) {
  return object.is_object() && !object.empty() && std::all_of(object.begin(), object.end(), [](const Json& list) {
           return list.is_array() && !list.empty() && (list[0].is_number() || list[0].is_null());
         });
}

/// Frames that are members called by their numbers, in that order; none where it is anything else.
std::map<std::int64_t, const Json*> numbered_frames(const Json& object) {
  std::map<std::int64_t, const Json*> frames;
  if (!object.is_object() || object.size() > k_most_track_frames) return frames;
  for (const auto& [key, frame] : object.items()) {
    const auto number = base::parse_int(key);
    if (!number || !frame.is_object()) return {};
    frames.emplace(*number, &frame);
  }
  return frames;
}

ValueProblem read_by_name(const Json& lists, const std::string& place, Rows& rows) {
  std::size_t count = 0;
  for (const Json& list : lists) count = std::max(count, list.size());
  if (count > k_most_track_frames) return wrong_values("a track has at most 1,000,000 frames", place);
  for (std::size_t f = 0; f < count; ++f) {
    rows.begin("frame " + std::to_string(f));
    rows.untimed();
    for (const auto& [name, list] : lists.items()) {
      const std::string here = json::child(json::child(place, name), f);
      if (f >= list.size()) {
        rows.hold("a value is missing or no number");
      } else if (auto problem = rows.set(name, list[f], here)) {
        return problem;
      }
    }
  }
  return std::nullopt;
}

ValueProblem read_all(const Json& root, Rows& rows) {
  FoundValues found;
  look(root, "", 0, found);
  ValueReader reader(rows, found.names);
  const auto read_list = [&](const Json& list, const std::string& place) -> ValueProblem {
    if (list.size() > k_most_track_frames - rows.count())
      return wrong_values("a track has at most 1,000,000 frames", place);
    for (std::size_t f = 0; f < list.size(); ++f) {
      if (auto problem = reader.read_frame(list[f], json::child(place, f), rows.count())) return problem;
    }
    reader.finish();
    return std::nullopt;
  };
  if (found.names != nullptr && !found.more.empty()) {
    for (const auto& [list, place] : found.more) {
      if (auto problem = read_list(*list, place)) return problem;
    }
    return std::nullopt;
  }
  if (root.is_array()) return read_list(root, "");
  std::string name;
  const Json* scores = scores_of(root, &name);
  if (scores != nullptr && is_by_name(*scores)) return read_by_name(*scores, json::child("", name), rows);
  const Json* frames = first_of(root, {"frames", "animation", "results", "data", "poses"}, &name);
  if (frames != nullptr && frames->is_array()) return read_list(*frames, json::child("", name));
  // A frame a list, or a single one.
  if (found.names != nullptr && scores != nullptr && is_frames(*scores) && (*scores)[0].is_array()) {
    return read_list(*scores, json::child("", name));
  }
  if (is_by_name(root)) return read_by_name(root, "", rows);
  if (const auto numbered = numbered_frames(root); !numbered.empty()) {
    for (const auto& [number, frame] : numbered) {
      const std::string place = json::child("", std::to_string(number));
      if (auto problem = reader.read_frame(*frame, place, rows.count())) return problem;
    }
    reader.finish();
    return std::nullopt;
  }
  auto problem = reader.read_frame(root, "", 0);
  reader.finish();
  return problem;
}

}  // namespace

bool mentions_values(std::string_view json) {
  // A result of MediaPipe has the points of a face before its scores.
  constexpr std::size_t k_beginning = 1 << 18;
  const std::string text = base::lower_case(json.substr(0, k_beginning));
  for (const char* word : {"blendshape", "blend_shape", "categoryname", "category_name", "facsnames", "weightmat",
                           "\"jawopen\"", "\"eyeblinkleft\"", "\"eyeblink_l\""}) {
    if (text.find(word) != std::string::npos) return true;
  }
  // A list of lists of as many numbers as ARKit has shapes.
  return text.find("landmark") == std::string::npos && !usual_names(first_numbers(json)).empty();
}

base::Result<animation::WeightTrack> read_value_json(base::Bytes bytes) {
  const auto root = read_json_values(bytes);
  if (!root) return root.error();
  if (auto chunks = read_azure_chunks(*root)) return *std::move(chunks);
  Rows rows(root->is_object() ? rate_of(*root) : 0);
  if (auto problem = read_all(*root, rows)) return *problem;
  return rows.finish();
}

}  // namespace penpose::io
