#pragma once

#include <string>

#include "ui/app/files/files.h"

namespace penpose::app {

/// The path that a project is saved to where one was chosen: without an extension it is a .glb file.
[[nodiscard]] std::string project_path(const std::string& chosen);

/// Leaves what is being worked on, for another file or for good. Asks about unsaved work first.
class Leaving {
 public:
  Leaving(EditingSession& editing, Files& files, Recording& recording, Dialogs& dialogs, Notices& notices);

  /// Opens a file.
  void ask_to_open(const std::string& path);
  void ask_to_quit();

  // Answers to the question.
  void save_first();
  void go_on_without_saving();
  /// Saves, and goes on with what waited for it.
  void save_from_dialog(const std::string& path);

  void quit() { quit_ = true; }
  /// Quits without asking, because nobody can answer: unsaved work is offered at the next start.
  void quit_at_once();
  [[nodiscard]] bool wants_quit() const { return quit_; }

 private:
  EditingSession& editing_;
  Files& files_;
  Recording& recording_;
  Dialogs& dialogs_;
  Notices& notices_;
  bool quit_ = false;
};

}  // namespace penpose::app
