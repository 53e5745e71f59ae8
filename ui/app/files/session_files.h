#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/session/session_writer.h"
#include "ui/files/append_file.h"

namespace penpose::app {

/// Where the app keeps what it writes by itself. Empty: nothing is kept.
struct Folders {
  std::string state;       ///< sessions, the list of recent files
  std::string config;      ///< settings
  std::string poses;       ///< the library of poses, where no other folder is chosen
  std::string cache = {};  ///< pictures of films, which may be lost
};

/// Those of the XDG base directory specification: $XDG_STATE_HOME/penpose (~/.local/state/penpose),
/// $XDG_CONFIG_HOME/penpose (~/.config/penpose), files::usual_pose_folder and $XDG_CACHE_HOME/penpose
/// (~/.cache/penpose). Empty where there is neither a variable nor a home.
[[nodiscard]] Folders standard_folders();

/// A session being written, with a lock beside it that says so and that goes with the program, however that ends.
class SessionFile {
 public:
  /// Errors: the file is there already or cannot be written.
  static base::Result<std::unique_ptr<SessionFile>> create(const std::string& path, const std::string& program);
  /// `stem.session` in a folder, which is made where it is missing; `stem-2.session` where that is taken.
  static base::Result<std::unique_ptr<SessionFile>> create_in(const std::string& folder, const std::string& stem,
                                                              const std::string& program);
  /// As after a crash, unless `finish` came before.
  /// Goes on with a file whose program died. Errors: another program has it; it cannot be written.
  static base::Result<std::unique_ptr<SessionFile>> resume(const std::string& path, const std::string& program);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  [[nodiscard]] replay::SessionWriter& writer() { return writer_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Keeps beside the session, for after a crash, where the work is saved, and as of which state (a hash, or empty).
  void note_project(const std::string& project, const std::string& state);
  /// Keeps a copy of the model that the session began on, before that is written over: the session replays on it.
  /// Errors: it cannot be read, or there is no room for the copy.
  base::Status keep_model(const std::string& model);
  /// The session ended as it should. `keep` false: nothing was done in it, and it is not worth a file.
  void finish(bool keep);

 private:
  SessionFile(std::string path, files::AppendFile file, const std::string& program);

  std::string path_;
  files::AppendFile file_;
  replay::SessionWriter writer_;
  int lock_ = -1;
  std::string model_copy_;
};

/// Where the work of an abandoned session was saved; empty: nowhere.
[[nodiscard]] std::string project_of_session(const std::string& path);
/// Returns the name of the file in which a session's work was saved, else of the model that it began on; empty if
/// neither is known.
[[nodiscard]] std::string work_of_session(const std::string& path);
/// Sessions of a folder that were never finished and that no running program writes, the newest first. Those in which
/// nothing was done are tidied away, those whose work was saved count as finished.
[[nodiscard]] std::vector<std::string> abandoned_sessions(const std::string& folder);
/// Whether a session was not finished, or is being written.
[[nodiscard]] bool is_open_session(const std::string& path);
/// The session counts as finished from now on.
void settle_session(const std::string& path);
/// All sessions of a folder, the newest first.
[[nodiscard]] std::vector<std::string> past_sessions(const std::string& folder);
/// A free path `folder/stem.extension`, with a number where that is taken.
[[nodiscard]] std::string free_path(const std::string& folder, const std::string& stem, const std::string& extension);

}  // namespace penpose::app
