#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ui/app/files/session_files.h"
#include "ui/app/notices.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The file in which the session is recorded as it happens.
class Recording {
 public:
  struct Options {
    std::string state_folder;                ///< sessions are below it; empty: nothing is kept
    std::string first;                       ///< the first session is written there instead; empty: it is not
    std::string program;                     ///< that writes it
    std::function<std::string()> date = {};  ///< names sessions; empty: "session"
  };
  Recording(Options options, const EditingSession& editing, Notices& notices);

  /// Ends the session that there is, and makes the file of the next one; null where nothing is kept, or where it cannot
  /// be made, which is said.
  [[nodiscard]] std::unique_ptr<SessionFile> next();
  /// The same while the session that there is goes on.
  [[nodiscard]] std::unique_ptr<SessionFile> beside();
  /// Ends the session that there is. One in which nothing was done leaves no file.
  void end();
  /// Records into a file from now on; null: into none.
  void take(std::unique_ptr<SessionFile> file);
  /// Gives the file away, with the session that goes on in it while another one is recorded.
  struct Aside {
    std::unique_ptr<SessionFile> file;
    bool keep = false;
  };
  [[nodiscard]] Aside set_aside();
  /// Records into a file again that was set aside.
  void take_up(Aside aside);
  /// Ends a session that was set aside, as `end` does.
  void end(Aside& aside, const document::History& history);

  /// Leaves the session as after a crash when it ends.
  void leave_work(bool leaves) { leaves_work_ = leaves; }
  [[nodiscard]] bool leaves_work() const { return leaves_work_; }

  /// Where it is recorded; empty: nowhere.
  [[nodiscard]] std::string path() const { return file_ ? file_->path() : std::string(); }
  /// Whether what is done is being written down.
  [[nodiscard]] bool records() const { return file_ && !file_->writer().broken(); }
  /// All sessions, the newest first.
  [[nodiscard]] std::vector<std::string> past() const { return past_sessions(options_.state_folder + "/sessions"); }
  /// Keeps beside the session where the work is saved.
  void note_project(const std::string& project, const std::string& state);
  /// Keeps a copy of the model that the session began on. Errors: it cannot be read, or there is no room for the copy.
  base::Status keep_model(const std::string& model);
  /// Says that the file cannot be written, and that it can again.
  void follow();

 private:
  Options options_;
  const EditingSession& editing_;
  Notices& notices_;
  std::unique_ptr<SessionFile> file_;
  bool keep_ = false;       ///< a session that was asked for by name is kept, whatever is in it
  bool keep_next_ = false;  ///< the next one is
  bool leaves_work_ = false;
  bool broken_told_ = false;
};

}  // namespace penpose::app
