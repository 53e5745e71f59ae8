#include "core/io/project/internal/project_sound.h"

#include <memory>
#include <utility>

namespace penpose::io {
namespace {

using document::Mouth;
using document::SpokenMouth;

constexpr std::size_t k_most_spoken = 100000;

/// The text of a member; nothing where it is none, or empty.
std::string text_of(const json::Json& object, const char* name) {
  const json::Json* value = json::find(object, name);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

std::optional<double> number_of(const json::Json& object, const char* name, double least) {
  const json::Json* value = json::find(object, name);
  const auto number = value == nullptr ? std::nullopt : json::number(*value);
  return number && *number >= least && *number <= document::k_latest_key_s ? number : std::nullopt;
}

Problem read_sound_reference(const json::Json& project, const std::string& pointer, document::Document& out) {
  const json::Json* value = json::find(project, "sound");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "sound");
  document::SoundReference sound;
  sound.file = text_of(*value, "file");
  if (sound.file.empty() || sound.file.size() > document::k_longest_sound_path)
    return project_error("the name of a file was expected", json::child(here, "file"));
  const auto content = base::parse_hash(text_of(*value, "content"));
  if (!content) return project_error("32 hexadecimal digits were expected", json::child(here, "content"));
  sound.content = *content;
  const auto offset = number_of(*value, "offset_s", -document::k_latest_key_s);
  if (!offset) return project_error("seconds from -36000 to 36000 were expected", json::child(here, "offset_s"));
  sound.offset_s = *offset;
  out.sound = std::make_shared<const document::SoundReference>(std::move(sound));
  return std::nullopt;
}

Problem read_mouth(const json::Json& value, const std::string& here, Mouth& out) {
  out.name = text_of(value, "name");
  if (out.name.empty()) return project_error("a name was expected", json::child(here, "name"));
  const json::Json* values = json::find(value, "values");
  const std::string list = json::child(here, "values");
  if (values == nullptr || !values->is_object()) return project_error("controls and their values were expected", list);
  for (const auto& [name, number] : values->items()) {
    const auto moved = json::number(number);
    if (!moved) return project_error("a number was expected", json::child(list, name));
    out.values.push_back({name, *moved});
  }
  return std::nullopt;
}

Problem read_mouths(const json::Json& project, const std::string& pointer, document::Document& out) {
  const json::Json* mouths = json::find(project, "mouths");
  if (mouths == nullptr) return std::nullopt;
  const std::string list = json::child(pointer, "mouths");
  if (!mouths->is_array() || mouths->size() > document::k_most_mouths)
    return project_error("a list of at most 100 mouths was expected", list);
  document::Mouths read;
  for (std::size_t i = 0; i < mouths->size(); ++i) {
    const std::string here = json::child(list, i);
    Mouth mouth;
    if (auto problem = read_mouth((*mouths)[i], here, mouth)) return problem;
    if (document::find_mouth(read, mouth.name) != nullptr)
      return project_error("a name of its own was expected", json::child(here, "name"));
    read.push_back(std::make_shared<const Mouth>(std::move(mouth)));
  }
  out.mouths = document::mouths_of_rig(read, out.model->rig->parameters());
  return std::nullopt;
}

Problem read_words(const json::Json& project, const std::string& pointer, document::Document& out) {
  const json::Json* value = json::find(project, "words");
  if (value == nullptr) return std::nullopt;
  const std::string list = json::child(pointer, "words");
  if (!value->is_array() || value->empty() || value->size() > document::k_most_words)
    return project_error("a list of words was expected", list);
  if (!out.sound) return project_error("words of no sound were not expected", list);
  document::SpokenWords words;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string here = json::child(list, i);
    const auto from = number_of((*value)[i], "from_s", 0);
    if (!from || (!words.empty() && *from < words.back().from_s))
      return project_error("moments were expected that ascend from 0", json::child(here, "from_s"));
    std::string word = text_of((*value)[i], "word");
    if (word.empty() || word.size() > document::k_longest_word)
      return project_error("a word of 1 to 200 bytes was expected", json::child(here, "word"));
    words.push_back({*from, std::move(word)});
  }
  out.words = std::make_shared<const document::SpokenWords>(std::move(words));
  return std::nullopt;
}

}  // namespace

Problem read_spoken(const json::Json& object, const std::string& pointer, const document::Mouths& mouths,
                    std::shared_ptr<const document::SpokenMouths>& out) {
  const json::Json* value = json::find(object, "spoken");
  if (value == nullptr) return std::nullopt;
  const std::string list = json::child(pointer, "spoken");
  if (!value->is_array() || value->empty() || value->size() > k_most_spoken)
    return project_error("a list of mouths was expected", list);
  document::SpokenMouths spoken;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string here = json::child(list, i);
    SpokenMouth one;
    const auto time = number_of((*value)[i], "time_s", 0);
    if (!time || (!spoken.empty() && *time <= spoken.back().time_s))
      return project_error("moments were expected that ascend from 0", json::child(here, "time_s"));
    one.time_s = *time;
    one.mouth = text_of((*value)[i], "mouth");
    if (document::find_mouth(mouths, one.mouth) == nullptr)
      return project_error("the name of a mouth was expected", json::child(here, "mouth"));
    spoken.push_back(std::move(one));
  }
  out = std::make_shared<const document::SpokenMouths>(std::move(spoken));
  return std::nullopt;
}

Problem read_project_sound(const json::Json& project, const std::string& pointer, document::Document& out) {
  for (const auto read : {read_sound_reference, read_words, read_mouths}) {
    if (auto problem = read(project, pointer, out)) return problem;
  }
  return read_spoken(project, pointer, out.mouths, out.spoken);
}

void write_spoken(const document::SpokenMouths& spoken, json::Json& object) {
  json::Json list = json::Json::array();
  for (const SpokenMouth& one : spoken) list.push_back({{"time_s", one.time_s}, {"mouth", one.mouth}});
  object["spoken"] = std::move(list);
}

void write_project_sound(const document::Document& document, json::Json& project) {
  if (document.sound) {
    project["sound"] = {{"file", document.sound->file},
                        {"content", document.sound->content.hex()},
                        {"offset_s", document.sound->offset_s}};
  }
  if (!document.mouths.empty()) {
    json::Json mouths = json::Json::array();
    for (const auto& mouth : document.mouths) {
      json::Json values = json::Json::object();
      for (const auto& one : mouth->values) values[one.name] = one.value;
      mouths.push_back({{"name", mouth->name}, {"values", std::move(values)}});
    }
    project["mouths"] = std::move(mouths);
  }
  if (document.spoken) write_spoken(*document.spoken, project);
  if (!document.words) return;
  json::Json words = json::Json::array();
  for (const document::SpokenWord& one : *document.words) words.push_back({{"from_s", one.from_s}, {"word", one.word}});
  project["words"] = std::move(words);
}

}  // namespace penpose::io
