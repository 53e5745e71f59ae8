#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "replay/session/session_player.h"
#include "ui/app/cast/cast.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/face/kept_features.h"
#include "ui/app/files/player.h"
#include "ui/app/files/recording.h"
#include "ui/app/playback/performer.h"
#include "ui/app/preferences.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/files/load_model.h"

namespace penpose::app {

/// What is opened, played, saved and exported.
class Files {
 public:
  struct Parts {
    std::string state_folder;                ///< where copies are kept; empty: in a folder of this run alone
    const decode::TabletTable* own_tablets;  ///< may be null
    std::string program;
    std::function<std::int64_t()> clock;
    EditingSession& editing;
    Recording& recording;
    Cast& cast;
    Player& player;
    Performer& performer;
    Notices& notices;
    Preferences& preferences;
    Dialogs& dialogs;
    TourGuide& tour;
    KeptFeatures& features;
    std::function<void()> opened;    ///< tells everybody else that the document is another
    std::function<void()> switched;  ///< tells them that another character of the same scene is worked on
  };
  explicit Files(Parts parts) : parts_(std::move(parts)) {}

  /// Opens a model, a project, or a session, whose end is gone on from; "tour:NAME" begins a tour.
  base::Status open(const std::string& path);
  /// The same with the notice of a refusal. Of a session of an older edition it asks first.
  void try_open(const std::string& path);
  /// Draws a session of an older edition again with today's reading, into a new session that is gone on with, and shows
  /// how it came out.
  base::Status draw_again(const std::string& path);
  /// Plays a trace into the document in place of a tablet.
  base::Status play_trace(const std::string& path);
  /// Goes on with a session that a crash has ended, in its own file.
  base::Status bring_back(const std::string& path);
  /// The same of all characters that were worked on together (cast_note.h). Those that cannot be brought back are told.
  base::Status bring_back_cast(const io::Cast& cast);

  // Several characters.
  /// Opens a model or a project beside what is open, places it there, and works on it. Errors: as open; there is no
  /// room for one more.
  base::Status add(const std::string& path);
  /// Works on another character. Nothing happens while a pen draws.
  void work_on(std::size_t character);
  /// Takes a character away; another one is worked on where it was the one.
  void remove(std::size_t character);

  base::Status save(const std::string& path);
  /// Writes a copy for other programs; the work stays where it is saved.
  base::Status export_to(const std::string& path);

  /// Notes where the work is saved after moves in time, so that a crash leaves nothing to bring back then.
  void follow();
  /// Writes every character into a file of its own, which is named after the path and the character.
  base::Status export_each(const std::string& path);
  [[nodiscard]] bool has_several() const { return parts_.cast.several(); }
  /// Whether anything of any character was changed since it was saved.
  [[nodiscard]] bool unsaved() const { return parts_.editing.unsaved() || parts_.cast.unsaved(); }

  /// Says what is lost where a file of that name is written; empty: nothing is, or only what was saved before.
  [[nodiscard]] std::string lost_by_writing(const std::string& path) const;

  /// Where Save writes; empty: it asks. Never a model that others made.
  [[nodiscard]] const std::string& project() const { return project_; }
  /// What was opened.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  /// What is opened stands alone, or beside what was open and was set aside.
  struct Joins {
    bool beside;
    const io::CastMember* like;  ///< of a project; null: it gets a place
  };
  static const Joins k_alone;
  base::Status open_session(const std::string& path);
  void begin_session(document::Document document, const std::string& path, const Joins& joins);
  void resume(replay::ReplayResult played, std::unique_ptr<SessionFile> file, const Joins& joins);
  void join(const Joins& joins);
  /// The tool that is in hand after opening something.
  void take_first_tool();
  void open_cast(files::LoadedCast loaded, const std::string& path, bool beside);
  base::Status bring_back_member(const io::CastMember& member, const Joins& joins);
  base::Status save_all(const std::string& path);
  /// `by_today` also draws what is of an older edition.
  base::Result<replay::ReplayResult> played_session(const std::string& path, replay::PlayerObserver* observer = nullptr,
                                                    bool by_today = false);
  bool asks_about_edition(const std::string& path);
  void set_project(const std::string& path);
  /// The sound as a project at that path names it; nothing: as now, or there is none.
  [[nodiscard]] std::optional<document::SetSound> renamed_sound(const document::Document& document,
                                                                const std::string& opened,
                                                                const std::string& path) const;

  /// The same of the reference.
  [[nodiscard]] std::optional<document::SetReference> renamed_reference(const std::string& path) const;

  Parts parts_;
  std::string project_;
  std::string path_;
  std::uint64_t noted_ = 0;  ///< the revision whose state is noted beside the session
};

}  // namespace penpose::app
