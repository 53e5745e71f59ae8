#include "ui/app/mouths/first_pass.h"

#include <chrono>
#include <utility>

#include "core/phonetics/nine_mouths.h"
#include "core/sound/read/read_sound.h"
#include "core/speech/closures.h"
#include "core/speech/mouth_keys.h"
#include "core/speech/usual_mouths.h"
#include "ui/files/files.h"
#include "ui/speech/dictionary.h"

namespace penpose::app {

FirstPass::FirstPass(EditingSession& editing, Notices& notices, Playback& playback, const SoundTrack& track)
    : editing_(editing), notices_(notices), playback_(playback), track_(track) {}

FirstPass::~FirstPass() { stop(); }

void FirstPass::stop() {
  if (listening_) listening_->stopped = true;
}

base::Status FirstPass::listen(const std::string& text) {
  refused_.clear();
  if (listens()) return base::Error{"the sound is being listened to", "", "wait, or stop it"};
  if (editing_.document().mouths.empty()) return base::Error{"no mouth is kept", "", "keep some first"};
  // Nobody wants to wait for what cannot be spoken.
  document::SpokenMouths all;
  for (const std::string_view name : speech::k_mouth_names) all.push_back({0, std::string(name)});
  if (const auto drawn = speech::with_drawn(all, editing_.document().mouths); !drawn) return drawn.error();
  const auto sound = track_.shared_sound();
  if (!sound) return base::Error{"the timeline has no sound", "", "open one first"};
  // One that was stopped ends before.
  if (future_.valid()) future_.wait();
  listening_ = std::make_shared<speech::Listening>();
  heard_sound_ = sound;
  future_ = std::async(std::launch::async, [sound, text, listening = listening_]() -> base::Result<Heard> {
    const auto phones = speech::hear_phones(*sound, text, {}, listening.get());
    if (!phones) return phones.error();
    return Heard{speech::with_closures(speech::cues_of(*phones), *sound), speech::words_heard(*phones)};
  });
  return base::Done{};
}

base::Status FirstPass::take_cues(const std::string& path) {
  const auto bytes = files::read_file(path, files::k_most_text_bytes);
  if (!bytes) return bytes.error();
  if (sound::looks_like_sound(*bytes))
    return base::Error{"this is a sound, no list of cues", path, "open it as the sound"};
  const auto read = speech::read_mouth_cues(*bytes, playback_.rate(), speech::english_dictionary());
  if (!read) return read.error();
  if (const auto keyed = key(read->cues); !keyed) return keyed;
  keep_words(read->words);
  for (const std::string& note : read->notes) notices_.tell(note);
  return base::Done{};
}

void FirstPass::follow() {
  if (!future_.valid() || future_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  auto heard = future_.get();
  if (listening_->stopped) return;
  if (!heard) {
    refused_ = heard.error().line();
  } else if (track_.shared_sound() != heard_sound_) {
    refused_ = "the sound on the timeline has changed";
  } else if (const auto keyed = key(heard->cues); !keyed) {
    refused_ = keyed.error().line();
  } else {
    keep_words(heard->words);
  }
  if (!refused_.empty()) notices_.tell(refused_, true);
}

base::Status FirstPass::key(const speech::Cues& cues) {
  const document::Document& document = editing_.document();
  if (document.mouths.empty()) return base::Error{"no mouth is kept", "", "keep some first"};
  const double offset_s = document.sound ? document.sound->offset_s : 0;
  const double rate = playback_.rate();
  const auto keys = speech::with_drawn(speech::mouth_keys(cues, {rate, offset_s}), document.mouths);
  if (!keys) return keys.error();
  document::KeyMouths command;
  for (const document::SpokenMouth& key : *keys) {
    command.times_s.push_back(key.time_s);
    command.mouths.push_back(key.mouth);
  }
  // What is wrong with it is told before anything changes.
  if (const auto after = editing_.after(command); !after) return after.error();
  editing_.perform(command);
  editing_.perform_with(document::GoToTime{playback_.time_s()});
  notices_.tell("it speaks: " + std::to_string(keys->size()) + " keys of mouths; Undo takes them back");
  return base::Done{};
}

void FirstPass::keep_words(const std::vector<speech::HeardWord>& heard) {
  const document::SetWords command = speech::words_kept(heard);
  if (editing_.document().sound && (!command.words.empty() || editing_.document().words != nullptr))
    editing_.perform_with(command);
}

}  // namespace penpose::app
