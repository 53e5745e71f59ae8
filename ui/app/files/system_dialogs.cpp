#include "ui/app/files/system_dialogs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/io/model/model_formats.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/files/file_kinds.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array k_of_files{Dialog::open, Dialog::save, Dialog::export_as, Dialog::backdrop, Dialog::sound};
constexpr std::int64_t k_look_for_us = 6'000'000;
constexpr int k_look_ms = 200;

std::vector<portal::FileFilter> filters_of(const std::vector<FileKind>& kinds) {
  std::vector<portal::FileFilter> filters;
  for (const FileKind& one : kinds) filters.push_back({one.label, one.extensions});
  return filters;
}

std::vector<portal::FileFilter> filters_to_export() {
  std::vector<portal::FileFilter> filters;
  for (const io::ModelFormat& format : io::model_formats()) {
    if (!format.holds.empty()) filters.push_back({std::string(format.holds), {std::string(format.extension)}});
  }
  return filters;
}

}  // namespace

void SystemDialogs::set_portal(std::unique_ptr<portal::FilePortal> portal, std::function<std::string()> window) {
  portal_ = std::move(portal);
  window_ = std::move(window);
  asked_ = Dialog::none;
}

portal::FileQuestion SystemDialogs::question_for(Dialog dialog) const {
  portal::FileQuestion question;
  question.parent = window_ ? window_() : std::string();
  question.folder = parts_.dialogs.state<FileChoice>().folder;
  question.saves = dialog == Dialog::save || dialog == Dialog::export_as;
  if (dialog == Dialog::open) {
    question.title = "Open a model, a project or a session";
    question.filters = filters_of(opened_kinds());
  } else if (dialog == Dialog::save) {
    question.title = "Save the project";
    question.name = name_to_save(parts_.files, question.folder);
    question.filters = {{"Projects", {".glb"}}};
  } else if (dialog == Dialog::export_as) {
    question.title = "Export for other programs";
    question.name = name_to_export(parts_.files, question.folder);
    question.filters = filters_to_export();
  } else if (dialog == Dialog::backdrop) {
    question.title = "A picture or a film to animate after";
    question.filters = filters_of(reference_kinds());
  } else {
    question.title = "Sound on the timeline";
    question.filters = filters_of(sound_kinds());
  }
  return question;
}

bool SystemDialogs::takes(Dialog dialog) {
  if (!portal_ || std::find(k_of_files.begin(), k_of_files.end(), dialog) == k_of_files.end()) return false;
  if (open()) return true;
  // A sound that is there can be taken away in ours.
  if (!parts_.preferences.settings().system_dialogs || (dialog == Dialog::sound && parts_.sound.sound() != nullptr))
    return false;
  asked_ = dialog;
  asked_us_ = parts_.clock();
  portal_->ask(question_for(dialog));
  return true;
}

void SystemDialogs::use(Dialog dialog, const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  if (dialog == Dialog::open) return parts_.leaving.ask_to_open(path);
  if (dialog == Dialog::save) {
    parts_.dialogs.state<FileChoice>().folder = folder;
    const std::string written = project_path(path);
    // What the system's dialog did not ask about is asked in ours.
    if (written != path && !parts_.files.lost_by_writing(written).empty()) {
      parts_.dialogs.state<FileChoice>().name = fs::path(path).filename().string();
      return parts_.dialogs.show_ours(dialog);
    }
    return parts_.leaving.save_from_dialog(path);
  }
  if (dialog == Dialog::export_as) {
    if (const auto written = parts_.files.export_to(path); !written)
      parts_.notices.tell(written.error().line(path), true);
    return;
  }
  parts_.dialogs.state<FileChoice>().folder = folder;
  if (dialog == Dialog::backdrop) {
    parts_.references.open(path);
  } else {
    parts_.sound.open(path);
  }
}

void SystemDialogs::follow() {
  if (!portal_ || !open()) return;
  const portal::FileAnswer answer = portal_->take();
  using Kind = portal::FileAnswer::Kind;
  if (answer.kind == Kind::waits) return;
  const Dialog dialog = std::exchange(asked_, Dialog::none);
  if (answer.kind == Kind::chosen) {
    use(dialog, answer.path);
  } else if (answer.kind == Kind::unavailable && !parts_.dialogs.any()) {
    return parts_.dialogs.show_ours(dialog);
  }
  // What waited for the saving is given up with it.
  if (dialog == Dialog::save && !parts_.dialogs.any()) parts_.dialogs.state<UnsavedWork>().saves_first = false;
}

int SystemDialogs::next_frame_ms() const {
  return open() && parts_.clock() - asked_us_ < k_look_for_us ? k_look_ms : -1;
}

}  // namespace penpose::app
