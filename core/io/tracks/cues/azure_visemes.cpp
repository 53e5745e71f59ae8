#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/io/tracks/cues/internal/cue_reader.h"
#include "core/io/tracks/increasing_values.h"
#include "core/io/tracks/values/json_values.h"
#include "core/phonetics/visemes.h"

namespace penpose::io {
namespace {

constexpr std::initializer_list<const char*> k_offsets{
    "audioOffset",     "audio_offset", "AudioOffset", "offset",    "Offset",
    "privAudioOffset", "time",         "timestamp",   "startTime", "start"};
constexpr std::initializer_list<const char*> k_visemes{"visemeId",     "viseme_id", "VisemeId", "visemeID",
                                                       "privVisemeId", "viseme",    "id"};

/// The list of events: the file, or the first member that is one.
const json::Json* events_in(const json::Json& root, std::string& place) {
  if (root.is_array()) return &root;
  for (const auto& [name, value] : root.items()) {
    if (!value.is_array() || value.empty() || json_member(value[0], k_visemes) == nullptr) continue;
    place = json::child("", name);
    return &value;
  }
  return nullptr;
}

/// How many units of the offsets are a second: the service counts 100 ns, its samples print milliseconds. Mouths do not
/// stay for 5 s, nor change every 0.1 ms.
double units_of_seconds(const std::vector<std::optional<double>>& offsets, bool by_name) {
  const double step = typical_step(offsets);
  if (step <= 0) return by_name ? 1e7 : 1;
  if (step < 3) return 1;
  return step < 3000 ? 1e3 : 1e7;
}

CueProblem read_azure(std::string_view text, CueBuilder& cues) {
  auto root = read_json_values(base::as_bytes(text));
  if (!root) return root.error();
  std::string place;
  const json::Json* events = events_in(*root, place);
  if (events == nullptr) return cues.wrong("a list of viseme events was expected", "");
  std::vector<std::optional<double>> offsets;
  std::vector<std::int64_t> visemes;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < events->size(); ++i) {
    const json::Json& event = (*events)[i];
    const auto viseme = json_time(json_member(event, k_visemes));
    // Events of words and bookmarks may stand between them.
    if (!viseme) continue;
    const auto offset = json_time(json_member(event, k_offsets));
    if (!offset) return cues.wrong("a viseme without an audioOffset", json::child(place, i));
    if (!speech::mouth_of_azure(static_cast<std::int64_t>(std::clamp(*viseme, -1.0, 1e6))))
      return cues.wrong("visemes of Azure are numbers from 0 to 21", json::child(place, i));
    offsets.push_back(offset);
    visemes.push_back(static_cast<std::int64_t>(*viseme));
    numbers.push_back(i);
  }
  const double unit = units_of_seconds(offsets, mentions(text, "udioOffset") || mentions(text, "audio_offset"));
  for (std::size_t i = 0; i < visemes.size(); ++i) {
    const auto mouth = speech::mouth_of_azure(visemes[i]);
    if (auto problem =
            cues.mouth(*offsets[i] / unit, mouth.value_or(speech::NineMouth::rest), json::child(place, numbers[i]))) {
      return problem;
    }
  }
  return std::nullopt;
}

}  // namespace

CueReader azure_reader() {
  return {
      "Azure's viseme events", "write the events as a list of {\"audioOffset\", \"visemeId\"}",
      [](std::string_view text) {
        if (!begins_json(text)) return false;
        for (const char* name : {"\"visemeId\"", "\"viseme_id\"", "\"VisemeId\"", "\"visemeID\"", "\"privVisemeId\""}) {
          if (mentions(text, name)) return true;
        }
        return mentions(text, "\"viseme\"") && mentions(text, "udioOffset\"");
      },
      read_azure};
}

}  // namespace penpose::io
