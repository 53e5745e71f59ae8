#include "ui/app/files/leaving.h"

#include <filesystem>
#include <utility>

#include "ui/app/dialogs/entries.h"

namespace penpose::app {

Leaving::Leaving(EditingSession& editing, Files& files, Recording& recording, Dialogs& dialogs, Notices& notices)
    : editing_(editing), files_(files), recording_(recording), dialogs_(dialogs), notices_(notices) {}

void Leaving::ask_to_open(const std::string& path) {
  if (!files_.unsaved()) return files_.try_open(path);
  dialogs_.state<UnsavedWork>().then_opens = path;
  dialogs_.show(Dialog::unsaved);
}

void Leaving::ask_to_quit() {
  if (files_.unsaved() && dialogs_.open() != Dialog::unsaved) {
    dialogs_.state<UnsavedWork>().then_opens.clear();
    dialogs_.show(Dialog::unsaved);
    return;
  }
  quit_ = true;
}

void Leaving::quit_at_once() {
  // A stroke that goes on ends here, as if the tablet had been unplugged.
  for (const int device : editing_.session().pens().drawing()) editing_.input().disconnect(device);
  recording_.leave_work(files_.unsaved());
  quit_ = true;
}

std::string project_path(const std::string& chosen) {
  return std::filesystem::path(chosen).has_extension() ? chosen : chosen + ".glb";
}

void Leaving::save_from_dialog(const std::string& chosen) {
  const std::string path = project_path(chosen);
  if (const auto saved = files_.save(path); !saved) return notices_.tell(saved.error().line(path), true);
  dialogs_.show(Dialog::none);
  dialogs_.state<FileChoice>().name.clear();
  if (std::exchange(dialogs_.state<UnsavedWork>().saves_first, false) && !files_.unsaved()) go_on_without_saving();
}

void Leaving::save_first() {
  dialogs_.state<UnsavedWork>().saves_first = true;
  if (const std::string project = files_.project(); !project.empty()) return save_from_dialog(project);
  dialogs_.state<FileChoice>().name.clear();
  dialogs_.show(Dialog::save);
}

void Leaving::go_on_without_saving() {
  dialogs_.show(Dialog::none);
  const std::string& next = dialogs_.state<UnsavedWork>().then_opens;
  if (!next.empty()) return files_.try_open(next);
  quit_ = true;
}

}  // namespace penpose::app
