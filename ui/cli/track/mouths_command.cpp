#include <iostream>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/base/text/utf8.h"
#include "core/document/document_hash.h"
#include "core/document/history.h"
#include "core/io/model/model_formats.h"
#include "core/io/tracks/cues/cue_file.h"
#include "core/sound/read/read_sound.h"
#include "core/speech/closures.h"
#include "core/speech/cues.h"
#include "core/speech/mouth_file.h"
#include "core/speech/mouth_keys.h"
#include "core/speech/usual_mouths.h"
#include "ui/cli/number_range.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/files/sound/sound_file.h"
#include "ui/speech/dictionary.h"
#include "ui/speech/hear_phones.h"

namespace penpose::cli {
namespace {

struct MouthArguments {
  io::WriteOptions glb;
  std::string model;
  std::string sound;
  std::string mouths;
  std::string text;
  std::string out;
  double fps = 24;
  double lead_s = speech::KeyOptions().lead_s;
  bool json = false;
};

/// The cues of a sound, or of a file of cues.
struct Heard {
  speech::Cues cues;
  std::vector<speech::HeardWord> words;
  std::optional<document::SoundReference> sound;
};

base::Result<Heard> hear(const MouthArguments& arguments) {
  const auto bytes = files::read_file(arguments.sound, files::k_most_sound_bytes);
  if (!bytes) return bytes.error();
  if (!sound::looks_like_sound(*bytes)) {
    auto read = speech::read_mouth_cues(*bytes, arguments.fps, speech::english_dictionary());
    if (!read) return read.error();
    for (const std::string& note : read->notes) files::warn(note, arguments.sound);
    return Heard{std::move(read->cues), std::move(read->words), std::nullopt};
  }
  const auto loaded = files::load_sound(arguments.sound, arguments.out);
  if (!loaded) return loaded.error();
  const auto phones = speech::hear_phones(loaded->sound, arguments.text);
  if (!phones) return phones.error();
  return Heard{speech::with_closures(speech::cues_of(*phones), loaded->sound), speech::words_heard(*phones),
               loaded->reference};
}

/// The mouths of a file, else those of the project, else those that the names of its controls tell.
base::Result<std::vector<document::Mouth>> mouths_for(const MouthArguments& arguments,
                                                      const document::Document& document) {
  if (!arguments.mouths.empty()) {
    const auto bytes = files::read_file(arguments.mouths, files::k_most_text_bytes);
    if (!bytes) return bytes.error();
    return speech::read_mouth_file(*bytes);
  }
  if (!document.mouths.empty()) return std::vector<document::Mouth>();
  auto usual = speech::usual_mouths(*document.model);
  if (usual.empty())
    return base::Error{"the model has no mouths, and no control is called like one", "", "draw them, or give --mouths"};
  return usual;
}

json::Json json_of(const document::Document& document, const document::SpokenMouths& keys,
                   const std::vector<speech::HeardWord>& said) {
  json::Json list = json::Json::array();
  for (const document::SpokenMouth& key : keys) list.push_back({{"time_s", key.time_s}, {"mouth", key.mouth}});
  json::Json mouths = json::Json::array();
  for (const auto& mouth : document.mouths) {
    json::Json values = json::Json::object();
    for (const auto& one : mouth->values) values[one.name] = one.value;
    mouths.push_back({{"name", mouth->name}, {"values", std::move(values)}});
  }
  json::Json words = json::Json::array();
  for (const speech::HeardWord& one : said)
    words.push_back({{"from_s", one.from_s}, {"to_s", one.to_s}, {"word", base::valid_utf8(one.word)}});
  return {{"keys", std::move(list)},
          {"words", std::move(words)},
          {"mouths", std::move(mouths)},
          {"state", document::DocumentHasher()(document).whole.hex()}};
}

int speak(const MouthArguments& arguments) {
  files::FileRoles roles;
  for (const std::string* file : {&arguments.model, &arguments.sound, &arguments.mouths}) roles.reads(*file);
  if (!arguments.out.empty()) {
    if (const auto fits = roles.writes(arguments.out, "-o"); !fits) return files::report(fits.error(), arguments.out);
    if (!io::keeps_everything(arguments.out))
      return files::report(
          {"animations are not kept in such a file", "", "name the output " + io::extensions_that_keep_everything()},
          arguments.out);
  }
  auto document = files::load_document(arguments.model);
  if (!document) return files::report(document.error(), arguments.model);
  for (const std::string& note : document->model->notes) files::warn(note, arguments.model);
  const auto mouths = mouths_for(arguments, *document);
  if (!mouths) return files::report(mouths.error(), arguments.mouths.empty() ? arguments.model : arguments.mouths);
  const auto heard = hear(arguments);
  if (!heard) return files::report(heard.error(), arguments.sound);
  document::History history(std::move(document).value());
  document::ApplyWorkspace work;
  for (const document::Mouth& mouth : *mouths) {
    if (const auto kept = history.perform(document::SetMouth{mouth.name, mouth.values}, work); !kept)
      return files::report(kept.error(), arguments.mouths.empty() ? arguments.model : arguments.mouths);
  }
  const double offset_s = history.document().sound ? history.document().sound->offset_s : 0;
  const auto keys = speech::with_drawn(speech::mouth_keys(heard->cues, {arguments.fps, offset_s, arguments.lead_s}),
                                       history.document().mouths);
  if (!keys) return files::report(keys.error(), arguments.sound);
  document::KeyMouths command;
  for (const document::SpokenMouth& key : *keys) {
    command.times_s.push_back(key.time_s);
    command.mouths.push_back(key.mouth);
  }
  base::Status done = history.perform(command, work);
  if (done && heard->sound)
    done = history.perform(document::SetSound{heard->sound->file, heard->sound->content, offset_s}, work);
  // A sound that is there already keeps the words of its cues.
  if (auto words = speech::words_kept(heard->words); done && !words.words.empty() && history.document().sound)
    done = history.perform(words, work);
  if (!done) return files::report(done.error(), arguments.model);
  if (!arguments.out.empty()) {
    if (const auto saved =
            files::save_as_it_came(history.document(), arguments.out, files::SaveNotes::loud, arguments.glb);
        !saved)
      return files::report(saved.error(), arguments.out);
  }
  if (arguments.json) {
    std::cout << json_of(history.document(), *keys, heard->words).dump_as_made() << '\n';
    return k_success;
  }
  for (const document::SpokenMouth& key : *keys)
    std::cout << base::format_fixed(key.time_s, 3) << '\t' << base::shown_name(key.mouth) << '\n';
  return k_success;
}

void add_mouth_options(const Command& command, MouthArguments& arguments) {
  command.add_option("MODEL", arguments.model, "Model with controls, or a project with mouths").required();
  command
      .add_option("SOUND", arguments.sound,
                  "Speech (WAV, FLAC, OGG, MP3, AIFF), or mouth cues of " + io::cue_format_names())
      .required();
  command.add_option("--text", arguments.text, "What is said, in English: far more certain than hearing alone");
  command.add_option("--mouths", arguments.mouths,
                     "JSON file of mouths (default: those of the project, or what the names of controls tell)");
  command.add_option("-o", arguments.out, "Write the model with its keys, " + io::extensions_that_keep_everything());
  command.add_option("--fps", arguments.fps, "Frames a second on which keys lie")
      .check(number_range(1.0, 1000.0), "1 to 1000")
      .show_default();
  command.add_option("--lead", arguments.lead_s, "How long before its sound a mouth is there at least, s")
      .check(number_range(0.0, 1.0), "0 to 1")
      .show_default();
  command.add_flag("--json", arguments.json, "Print one JSON object");
  add_tolerance_option(command, arguments.glb);
}

}  // namespace

Subcommand mouths_subcommand() {
  return subcommand<MouthArguments>("mouths", files::Rights::no_programs, "Keys the mouths that speak a sound",
                                    add_mouth_options, speak,
                                    {"penpose mouths builtin:demo cues.tsv -o talks.glb", "keys from cues of Rhubarb"},
                                    {"penpose mouths builtin:demo words.srt --json", "which mouth when, for scripts"},
                                    {{"--text", Completes::nothing}});
}

}  // namespace penpose::cli
