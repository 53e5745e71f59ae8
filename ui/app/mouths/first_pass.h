#pragma once

#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/speech/cues.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_track.h"
#include "ui/speech/hear_phones.h"

namespace penpose::app {

/// The first pass of a sound that is spoken: which mouth is when, as keys. The sound is listened to beside what goes on
/// in the window.
class FirstPass {
 public:
  FirstPass(EditingSession& editing, Notices& notices, Playback& playback, const SoundTrack& track);
  /// What is not done is given up.
  ~FirstPass();
  FirstPass(const FirstPass&) = delete;
  FirstPass& operator=(const FirstPass&) = delete;

  /// Listens to the sound beside the timeline. `text`: what is said; empty: by ear alone. Errors: there is no sound, no
  /// mouth is kept, or it listens already.
  base::Status listen(const std::string& text);
  /// Takes a file of cues, at the moment at which the sound begins. Errors: those of the file, no mouth is kept.
  base::Status take_cues(const std::string& path);

  [[nodiscard]] bool listens() const { return future_.valid() && !listening_->stopped; }
  [[nodiscard]] double share() const { return listens() ? listening_->share.load() : 0; }
  void stop();
  /// The last pass was.
  [[nodiscard]] bool stopped() const { return listening_ && listening_->stopped; }
  /// Keys what was heard as soon as it is.
  void follow();
  /// Why the last pass came to nothing; empty: it did not.
  [[nodiscard]] const std::string& refused() const { return refused_; }

 private:
  struct Heard {
    speech::Cues cues;
    std::vector<speech::HeardWord> words;
  };
  base::Status key(const speech::Cues& cues);
  /// Takes the words down in the document, as a part of what was keyed before.
  void keep_words(const std::vector<speech::HeardWord>& heard);

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  const SoundTrack& track_;
  std::shared_ptr<speech::Listening> listening_;
  std::future<base::Result<Heard>> future_;
  std::shared_ptr<const sound::Sound> heard_sound_;  ///< that is listened to, or was
  std::string refused_;
};

}  // namespace penpose::app
