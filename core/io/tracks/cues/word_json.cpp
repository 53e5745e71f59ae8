#include <algorithm>

#include "core/base/numbers.h"
#include "core/io/tracks/cues/internal/cue_reader.h"
#include "core/io/tracks/increasing_values.h"
#include "core/io/tracks/values/json_values.h"

namespace penpose::io {
namespace {

using json::Json;

constexpr std::initializer_list<const char*> k_starts{"start", "startTime", "start_time", "begin",
                                                      "from",  "startMs",   "start_ms",   "offset"};
constexpr std::initializer_list<const char*> k_ends{"end", "endTime", "end_time", "to", "stop", "endMs", "end_ms"};
constexpr std::initializer_list<const char*> k_texts{"word",    "punctuated_word", "text",  "alignedWord",
                                                     "content", "value",           "label", "transcript"};

/// A time, also as "1.300s" of Google's services.
std::optional<double> word_time(const Json* value) {
  if (value != nullptr && value->is_string()) {
    const std::string_view text = base::trim(value->get_ref<const std::string&>());
    return base::parse_double(text.ends_with('s') ? text.substr(0, text.size() - 1) : text);
  }
  return json_time(value);
}

/// A word, or a stretch of text, and where its times stand, which may be beside or below it.
struct TimedText {
  std::optional<double> from, to;
  std::string text;
  const Json* phones = nullptr;  ///< of Gentle: each with its duration
  std::string place;
};

std::optional<TimedText> timed_text(const Json& object, const std::string& place) {
  if (!object.is_object()) return std::nullopt;
  auto text = json_text(object, k_texts);
  // Amazon Transcribe: the first of several readings.
  if (const Json* readings = json::find(object, "alternatives");
      !text && readings != nullptr && readings->is_array() && !readings->empty())
    text = json_text((*readings)[0], k_texts);
  if (!text) return std::nullopt;
  const Json* times = json_member(object, {"offsets", "timestamp", "timing"});
  const Json& where = times != nullptr && times->is_object() ? *times : object;
  TimedText out{word_time(json_member(where, k_starts)), word_time(json_member(where, k_ends)), std::string(*text),
                json::find(object, "phones"), place};
  // [from, to] of other writers of Whisper's words.
  if (times != nullptr && times->is_array() && times->size() == 2) {
    out.from = word_time(&(*times)[0]);
    out.to = word_time(&(*times)[1]);
  }
  if (!out.to && out.from) {
    if (const auto length = word_time(json_member(object, {"duration", "dur"}))) out.to = *out.from + *length;
  }
  return out;
}

/// Lists of words or of stretches of text, as deep as the first of them.
struct FoundTexts {
  std::vector<std::pair<const Json*, std::string>> words, stretches;
  std::size_t words_depth = 100, stretches_depth = 100;
};

bool names_words(std::string_view name) {
  for (const char* one :
       {"words", "word_segments", "word_timestamps", "wordTimestamps", "items", "result", "Words", "chunks"}) {
    if (name == one) return true;
  }
  return false;
}

void look_for_texts(const Json& value, std::string_view name, const std::string& place, std::size_t depth,
                    FoundTexts& found) {
  constexpr std::size_t k_deepest = 8;
  if (depth > k_deepest || !(value.is_object() || value.is_array())) return;
  if (value.is_array()) {
    bool timed = false;
    for (std::size_t i = 0; i < value.size() && i < 50 && !timed; ++i) {
      const auto text = timed_text(value[i], "");
      timed = text && text->from;
    }
    if (timed) {
      const bool words = names_words(name) || json::find(value[0], "word") != nullptr;
      auto& lists = words ? found.words : found.stretches;
      std::size_t& at = words ? found.words_depth : found.stretches_depth;
      if (depth < at) lists.clear();
      if (depth <= at) lists.emplace_back(&value, place);
      at = std::min(at, depth);
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!value[i].is_object()) continue;
      // The entries below a list of words are their letters and sounds.
      if (timed && depth >= found.words_depth) break;
      look_for_texts(value[i], name, json::child(place, i), depth + 1, found);
    }
    return;
  }
  for (const auto& [key, inner] : value.items()) {
    if (key == "chars" || key == "tokens" || key == "phones" || key == "phonemes") continue;
    look_for_texts(inner, key, json::child(place, key), depth + 1, found);
  }
}

/// "hh_B" and the like, one after the other.
CueProblem add_gentle(const TimedText& word, double unit, CueBuilder& cues) {
  double at = word.from.value_or(0);
  for (const Json& phone : *word.phones) {
    const auto name = json_text(phone, {"phone", "label", "text"});
    const auto length = json_time(json_member(phone, {"duration"}));
    if (!name || !length || !(*length >= 0)) return cues.wrong("a phone and its duration were expected", word.place);
    if (auto problem = cues.phone(at / unit, (at + *length) / unit, *name, word.place)) return problem;
    at += *length;
  }
  return std::nullopt;
}

CueProblem add_texts(std::vector<TimedText> texts, CueBuilder& cues) {
  std::vector<std::optional<double>> starts;
  for (const TimedText& one : texts) starts.push_back(one.from);
  // No two words are 20 s apart: these are milliseconds.
  const double unit = typical_step(starts) >= 20 ? 1000 : 1;
  bool sounds = false;
  for (const TimedText& one : texts) sounds = sounds || (one.phones != nullptr && one.phones->is_array());
  std::size_t unheard = 0;
  std::optional<double> ended;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    TimedText word = texts[i];
    if (!word.from) {
      // Words without times lie between those that have some.
      if (base::trim(word.text).empty()) continue;
      ++unheard;
      std::size_t next = i + 1;
      while (next < texts.size() && !texts[next].from) {
        word.text.append(" ").append(texts[next].text);
        ++unheard;
        ++next;
      }
      i = next - 1;
      if (!ended || next >= texts.size() || !(*texts[next].from > *ended)) continue;
      word.from = ended;
      word.to = texts[next].from;
    }
    if (word.to) ended = word.to;
    const auto to_s = word.to ? std::optional(*word.to / unit) : std::nullopt;
    if (auto problem = cues.word(*word.from / unit, to_s, word.text, word.place)) return problem;
    if (!sounds) continue;
    if (word.phones != nullptr && word.phones->is_array() && !word.phones->empty()) {
      if (auto problem = add_gentle(word, unit, cues)) return problem;
    } else if (auto problem = cues.phone(*word.from / unit, to_s, "spn", word.place)) {
      return problem;
    }
  }
  if (unheard > 0)
    cues.note(std::to_string(unheard) + " words have no times: they are spoken between their neighbours");
  return std::nullopt;
}

const Json* list_of(const Json& object, std::initializer_list<const char*> names) {
  const Json* list = json_member(object, names);
  return list != nullptr && list->is_array() ? list : nullptr;
}

/// Lists side by side: letters with their times (ElevenLabs), words and visemes with theirs in ms (TalkingHead).
CueProblem read_side_by_side(const Json& object, const std::string& place, CueBuilder& cues) {
  const auto time_at = [](const Json* list, std::size_t i) -> std::optional<double> {
    return list != nullptr && i < list->size() ? json_time(&(*list)[i]) : std::nullopt;
  };
  if (const Json* letters = list_of(object, {"characters"})) {
    const Json* starts = list_of(object, {"character_start_times_seconds", "characterStartTimesSeconds"});
    const Json* ends = list_of(object, {"character_end_times_seconds", "characterEndTimesSeconds"});
    std::string word;
    std::optional<double> from, to;
    for (std::size_t i = 0; i <= letters->size(); ++i) {
      const bool is_text = i < letters->size() && (*letters)[i].is_string();
      const std::string letter = is_text ? (*letters)[i].get<std::string>() : " ";
      if (!base::trim(letter).empty()) {
        if (word.empty()) from = time_at(starts, i);
        to = time_at(ends, i);
        word += letter;
        continue;
      }
      if (!word.empty()) {
        if (auto problem = cues.word(from, to, word, json::child(place, i))) return problem;
      }
      word.clear();
    }
    return std::nullopt;
  }
  constexpr double k_ms = 1000;
  for (const bool words : {false, true}) {
    const Json* names = list_of(object, {words ? "words" : "visemes"});
    const Json* times = list_of(object, {words ? "wtimes" : "vtimes"});
    const Json* lengths = list_of(object, {words ? "wdurations" : "vdurations"});
    for (std::size_t i = 0; names != nullptr && times != nullptr && i < names->size(); ++i) {
      const std::string here = json::child(place, i);
      if (!(*names)[i].is_string()) return cues.wrong("a name was expected", here);
      auto from = time_at(times, i);
      if (!from) return cues.wrong("a time was expected", here);
      *from = std::max(0.0, *from / k_ms);
      const auto length = time_at(lengths, i);
      const auto to = length ? std::optional(*from + *length / k_ms) : std::nullopt;
      const auto& name = (*names)[i].get_ref<const std::string&>();
      if (auto problem = words ? cues.word(from, to, name, here) : cues.shape(from, name, here)) return problem;
      if (!words && to) cues.end(*to);
    }
  }
  return std::nullopt;
}

/// Tiers as JSON, as the Montreal Forced Aligner writes them: {"tiers": {NAME: {"entries": [[from, to, label]]}}}.
CueProblem read_tiers_json(const Json& tiers, CueBuilder& cues) {
  for (const auto& [name, tier] : tiers.items()) {
    const Json* entries = list_of(tier, {"entries"});
    const bool phones = name.find("phone") != std::string::npos;
    for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i) {
      const Json& entry = (*entries)[i];
      const std::string place = json::child(json::child("/tiers", name), i);
      if (!entry.is_array() || entry.size() < 3 || !entry[2].is_string())
        return cues.wrong("a list of two times and a label was expected", place);
      const auto from = json_time(&entry[0]), to = json_time(&entry[1]);
      const auto& label = entry[2].get_ref<const std::string&>();
      if (auto problem = phones ? cues.phone(from, to, label, place) : cues.word(from, to, label, place))
        return problem;
    }
  }
  return std::nullopt;
}

CueProblem read_word_json(std::string_view text, CueBuilder& cues) {
  const auto root = read_json_values(base::as_bytes(text));
  if (!root) return root.error();
  if (const Json* tiers = json::find(*root, "tiers"); tiers != nullptr && tiers->is_object())
    return read_tiers_json(*tiers, cues);
  for (const char* inner : {"", "alignment", "normalized_alignment"}) {
    const Json* object = *inner == 0 ? &*root : json::find(*root, inner);
    if (object == nullptr || !object->is_object()) continue;
    if (auto problem = read_side_by_side(*object, "", cues)) return problem;
    if (!cues.empty()) return std::nullopt;
  }
  FoundTexts found;
  look_for_texts(*root, "", "", 0, found);
  const auto& lists = found.words.empty() ? found.stretches : found.words;
  if (lists.empty()) return cues.wrong("no words with their times are in it", "");
  std::vector<TimedText> texts;
  for (const auto& [list, place] : lists) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      if (texts.size() >= 300'000) return cues.wrong("a list has at most 300,000 words", place);
      if (auto one = timed_text((*list)[i], json::child(place, i))) texts.push_back(*std::move(one));
    }
  }
  return add_texts(std::move(texts), cues);
}

}  // namespace

CueReader word_json_reader() {
  return {"JSON of words (WhisperX, Whisper, Gentle)", "write words with \"start\" and \"end\" in seconds",
          [](std::string_view text) {
            if (!begins_json(text)) return false;
            for (const char* name :
                 {"\"words\"", "\"word\"", "\"segments\"", "\"word_segments\"", "\"transcription\"", "\"tiers\"",
                  "\"characters\"", "\"vtimes\"", "\"transcript\"", "\"wtimes\"", "\"start_time\"", "\"startTime\""}) {
              if (mentions(text, name)) return true;
            }
            return false;
          },
          read_word_json};
}

}  // namespace penpose::io
