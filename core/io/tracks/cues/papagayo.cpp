#include "core/base/json/loose_json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

/// The lines of a project, blanks in front of them cut away.
class PgoLines {
 public:
  PgoLines(std::string_view text, const CueBuilder& cues) : lines_(text), cues_(cues) {}
  std::optional<std::string_view> next() {
    const auto line = lines_.next();
    return line ? std::optional(base::trim(*line)) : std::nullopt;
  }
  std::optional<std::int64_t> count(std::int64_t most) {
    const auto line = next();
    const auto number = line ? base::parse_int(*line) : std::nullopt;
    return number && *number >= 0 && *number <= most ? number : std::nullopt;
  }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(lines_.number()); }
  [[nodiscard]] base::Error wrong(const char* what) const { return cues_.wrong(what, place()); }

 private:
  TextLines lines_;
  const CueBuilder& cues_;
};

constexpr std::int64_t k_most_pgo = 1'000'000;

/// Counts the numbers at the end of a line: "word 12 18 3" has 3 of them.
std::vector<std::string_view> last_words(std::string_view line, std::size_t numbers) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < numbers; ++i) {
    const std::size_t gap = line.find_last_of(" \t");
    if (gap == std::string_view::npos) return {};
    words.insert(words.begin(), line.substr(gap + 1));
    line = base::trim(line.substr(0, gap));
  }
  words.insert(words.begin(), line);
  return words;
}

/// A voice that speaks: only the first one's mouth is shown.
class Voice {
 public:
  Voice(double fps, CueBuilder& cues) : fps_(fps), cues_(cues) {}

  void begin(std::string_view name) {
    if (spoke_) others_ += (others_.empty() ? "" : ", ") + base::shown_name(std::string(name.substr(0, 40)));
    silent_ = spoke_;
  }
  CueProblem word(double from, double to, std::string_view text, const std::string& place) {
    if (silent_) return std::nullopt;
    // Between words the mouth stays for a while.
    constexpr double k_stays_s = 0.25;
    if (ended_ && from - *ended_ - 1 > k_stays_s * fps_) {
      if (auto problem = rest(*ended_ + 1, place)) return problem;
    }
    ended_ = to;
    return cues_.word(from / fps_, (to + 1) / fps_, text, place);
  }
  CueProblem phoneme(double frame, std::string_view name, const std::string& place) {
    if (silent_) return std::nullopt;
    spoke_ = true;
    return cues_.label(frame / fps_, std::nullopt, name, place);
  }
  /// Nobody speaks from then on.
  CueProblem rest(double frame, const std::string& place) {
    if (silent_ || !spoke_) return std::nullopt;
    return cues_.label(frame / fps_, std::nullopt, "rest", place);
  }
  void finish() {
    if (!others_.empty()) cues_.note("several voices speak; the first is taken, not " + others_);
  }

 private:
  double fps_;
  CueBuilder& cues_;
  std::optional<double> ended_;
  std::string others_;
  bool spoke_ = false;
  bool silent_ = false;
};

/// "lipsync version 1", the sound, frames a second, their number, the number of voices; of each its name, its text, the
/// number of phrases; of each its text, first and last frame, the number of words; of each a line "word first last
/// count", and so many lines "frame phoneme" (Papagayo's source, LipsyncDoc.py).
CueProblem read_pgo(std::string_view text, CueBuilder& cues) {
  PgoLines lines(text, cues);
  lines.next();
  lines.next();
  const auto rate = lines.next();
  const auto fps = rate ? base::parse_double(*rate) : std::nullopt;
  if (!fps || !(*fps > 0) || !(*fps <= 1000)) return lines.wrong("a number of frames a second was expected");
  const auto frames = lines.next();
  if (const auto length = frames ? base::parse_double(*frames) : std::nullopt; length && *length < 1e9)
    cues.end(*length / *fps);
  const auto voices = lines.count(k_most_pgo);
  if (!voices) return lines.wrong("the number of voices was expected");
  Voice voice(*fps, cues);
  for (std::int64_t v = 0; v < *voices; ++v) {
    const auto name = lines.next();
    if (!name) break;
    voice.begin(*name);
    lines.next();
    const auto phrases = lines.count(k_most_pgo);
    if (!phrases) return lines.wrong("the number of phrases was expected");
    for (std::int64_t p = 0; p < *phrases; ++p) {
      lines.next();
      const auto first = lines.count(k_most_pgo * 1000);
      const auto last = lines.count(k_most_pgo * 1000);
      const auto words = lines.count(k_most_pgo);
      if (!first || !last || !words) return lines.wrong("the frames of a phrase and its number of words were expected");
      for (std::int64_t w = 0; w < *words; ++w) {
        const auto line = lines.next();
        const auto parts = line ? last_words(*line, 3) : std::vector<std::string_view>();
        const auto from = parts.size() == 4 ? base::parse_int(parts[1]) : std::nullopt;
        const auto to = parts.size() == 4 ? base::parse_int(parts[2]) : std::nullopt;
        const auto count = parts.size() == 4 ? base::parse_int(parts[3]) : std::nullopt;
        if (!from || !to || !count || *count < 0 || *count > k_most_pgo)
          return lines.wrong("a word, its first and last frame and its number of phonemes were expected");
        if (auto problem = voice.word(static_cast<double>(*from), static_cast<double>(*to), parts[0], lines.place()))
          return problem;
        for (std::int64_t k = 0; k < *count; ++k) {
          const auto phoneme = lines.next();
          const auto pair = phoneme ? phoneme->find_first_of(" \t") : std::string_view::npos;
          const auto frame =
              pair == std::string_view::npos ? std::nullopt : base::parse_double(phoneme->substr(0, pair));
          if (!frame) return lines.wrong("a frame and a phoneme were expected");
          if (auto problem = voice.phoneme(*frame, base::trim(phoneme->substr(pair)), lines.place())) return problem;
        }
      }
      if (auto problem = voice.rest(static_cast<double>(*last) + 1, lines.place())) return problem;
    }
  }
  voice.finish();
  return std::nullopt;
}

double frame_of(const json::Json& object, const char* name) {
  return json_time(json::find(object, name)).value_or(-1e9);
}

const json::Json& list_in(const json::Json& object, const char* name) {
  static const json::Json none = json::Json::array();
  const json::Json* list = json::find(object, name);
  return list != nullptr && list->is_array() ? *list : none;
}

/// The same as JSON (.pg2).
CueProblem read_pg2(std::string_view text, CueBuilder& cues) {
  const auto root = json::parse_loose_json(base::as_bytes(text));
  if (!root) return root.error();
  const auto fps = json_time(json::find(*root, "fps"));
  if (!fps || !(*fps > 0) || !(*fps <= 1000)) return cues.wrong("a number of frames a second was expected", "/fps");
  const double length = frame_of(*root, "sound_duration");
  if (length > 0 && length < 1e9) cues.end(length / *fps);
  Voice speaker(*fps, cues);
  const json::Json& voices = list_in(*root, "voices");
  for (std::size_t v = 0; v < voices.size(); ++v) {
    speaker.begin(json_text(voices[v], {"name"}).value_or(""));
    const json::Json& phrases = list_in(voices[v], "phrases");
    for (std::size_t p = 0; p < phrases.size(); ++p) {
      const std::string place = json::child(json::child(json::child("/voices", v), "phrases"), p);
      for (const json::Json& word : list_in(phrases[p], "words")) {
        if (auto problem = speaker.word(frame_of(word, "start_frame"), frame_of(word, "end_frame"),
                                        json_text(word, {"text"}).value_or(""), place)) {
          return problem;
        }
        for (const json::Json& phoneme : list_in(word, "phonemes")) {
          if (auto problem =
                  speaker.phoneme(frame_of(phoneme, "frame"), json_text(phoneme, {"text"}).value_or(""), place)) {
            return problem;
          }
        }
      }
      if (auto problem = speaker.rest(frame_of(phrases[p], "end_frame") + 1, place)) return problem;
    }
  }
  speaker.finish();
  return std::nullopt;
}

}  // namespace

CueReader papagayo_reader() {
  return {"Papagayo (.pgo, .pg2)", "save the project again in Papagayo",
          [](std::string_view text) {
            const auto first = text.find_first_not_of(" \t\r\n");
            if (first != std::string_view::npos && text.substr(first).starts_with("lipsync version")) return true;
            return begins_json(text) && mentions(text, "\"voices\"") &&
                   (mentions(text, "\"phrases\"") || mentions(text, "\"num_voices\""));
          },
          [](std::string_view text, CueBuilder& cues) {
            return begins_json(text) ? read_pg2(text, cues) : read_pgo(text, cues);
          }};
}

}  // namespace penpose::io
