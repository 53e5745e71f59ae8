#include "core/base/numbers.h"
#include "core/io/tracks/cues/internal/cue_reader.h"
#include "core/io/tracks/values/json_values.h"
#include "core/phonetics/visemes.h"

namespace penpose::io {
namespace {

/// A mark a line or a list of them: {"time": ms, "type": "viseme" or "word", "value"} (Amazon Polly's documentation,
/// "Speech mark output").
CueProblem read_speech_marks(std::string_view text, CueBuilder& cues) {
  auto root = read_json_values(base::as_bytes(text));
  if (!root) return root.error();
  const json::Json* inner = json_member(*root, {"marks", "speechMarks", "speech_marks", "visemes"});
  const json::Json& list = inner != nullptr && inner->is_array() ? *inner : *root;
  if (!list.is_array()) return cues.wrong("a list of speech marks was expected", "");
  std::size_t strangers = 0;
  std::string stranger;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const json::Json& mark = list[i];
    const std::string place = json::child("", i);
    const auto type = json_text(mark, {"type"});
    const auto value = json_text(mark, {"value"});
    const auto time = json_time(json::find(mark, "time"));
    if (!type || !value) return cues.wrong("a mark with a type and a value was expected", place);
    const std::optional<double> time_s = time ? std::optional(*time / 1000) : std::nullopt;
    if (*type == "word") {
      if (auto problem = cues.word(time_s, std::nullopt, *value, place)) return problem;
    } else if (*type == "viseme") {
      const auto mouth = speech::mouth_of_polly(*value);
      if (!mouth && strangers++ == 0) stranger = std::string(value->substr(0, 20));
      if (auto problem = cues.mouth(time_s, mouth.value_or(speech::NineMouth::consonants), place)) return problem;
    }
  }
  if (strangers > 0)
    cues.note(std::to_string(strangers) + " visemes are none that Polly documents, the first \"" + stranger + "\"");
  return std::nullopt;
}

}  // namespace

CueReader speech_marks_reader() {
  return {"Amazon Polly's speech marks", "synthesise the speech marks again",
          [](std::string_view text) {
            return begins_json(text) && mentions(text, "\"type\"") && mentions(text, "\"value\"") &&
                   mentions(text, "\"time\"") && (mentions(text, "\"viseme\"") || mentions(text, "\"word\""));
          },
          read_speech_marks};
}

}  // namespace penpose::io
