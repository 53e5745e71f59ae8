#include <filesystem>
#include <vector>

#include "core/io/model/model_formats.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/file_browser.h"
#include "ui/app/dialogs/first_pass_entry.h"
#include "ui/app/files/files.h"
#include "ui/app/files/leaving.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/reference/reference_desk.h"
#include "ui/app/sound/sound_track.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs that choose a file to open or a name to write to.

namespace penpose::app {
namespace {

using FileDialogsOwners = BrowsedWith;

namespace fs = std::filesystem;

constexpr float k_file_dialog_wide = 22;

/// A name for what is written, and a place. True when it is to be written; the full path is in `path`. Before a file
/// that is there is lost that is said, and pressed for once more.
bool choose_name(PanelContext& context, const FileDialogsOwners& with, const char* does, std::string& path,
                 std::string (*written_to)(const std::string& chosen) = nullptr) {
  FileChoice& choice = with.dialogs.state<FileChoice>();
  if (context.dialog_opens) choice.asked_of.clear();
  const TextCompleter complete = [&](const std::string& text) {
    return completed_path(choice.folder, text, home_folder(), {});
  };
  dialog_field(context, "##name", choice.name, "name.glb", &complete);
  if (const std::string file = browse(context, with, {opened_kinds(), 6, 1, false}); !file.empty()) {
    choice.name = fs::path(file).filename().string();
  }
  const TypedPath typed = typed_path(choice.folder, choice.name, home_folder());
  path = (fs::path(typed.folder) / typed.name).string();
  if (written_to != nullptr) path = written_to(path);
  if (choice.asked_of != path) choice.asked_of.clear();
  const bool asked = !choice.asked_of.empty();
  if (asked) ImGui::TextWrapped("%s", choice.lost.c_str());
  bool pressed = context.accepts;
  const auto cancel = [&] {
    if (wide_button(context, "Cancel", 4 * context.unit)) context.actions.run(Action::cancel);
  };
  // Where the first press was, a second one that came by itself does no harm.
  if (asked) {
    cancel();
    ImGui::SameLine();
    pressed = primary_button(context, "Write over it##now", 4 * context.unit) || pressed;
  } else {
    pressed = primary_button(context, does, 4 * context.unit) || pressed;
    ImGui::SameLine();
    cancel();
  }
  if (!pressed || typed.name.empty()) return false;
  if (asked) return true;
  choice.lost = with.files.lost_by_writing(path);
  choice.asked_of = choice.lost.empty() ? std::string() : path;
  return choice.lost.empty();
}

}  // namespace

void show_open_dialog(PanelContext& context, Files& files, Leaving& leaving, Preferences& preferences,
                      Dialogs& dialogs) {
  const FileDialogsOwners with{files, preferences, dialogs};
  if (begin_dialog(context, "Open", k_file_dialog_wide)) {
    std::string chosen;
    if (const std::string file = browse(context, with, {opened_kinds(), 8}); !file.empty()) chosen = file;
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
    ImGui::SameLine();
    if (wide_button(context, "Head with controls", 0, false, "The built-in head with its controls"))
      chosen = "builtin:demo";
    ImGui::SameLine();
    if (wide_button(context, "Head alone", 0, false, "The built-in head, to sketch controls on"))
      chosen = "builtin:head";
    if (!chosen.empty()) leaving.ask_to_open(chosen);
  }
  end_dialog();
}

void show_backdrop_dialog(PanelContext& context, ReferenceDesk& references, Files& files, Preferences& preferences,
                          Dialogs& dialogs) {
  const FileDialogsOwners with{files, preferences, dialogs};
  if (begin_dialog(context, "A picture or a film to animate after", k_file_dialog_wide)) {
    ImGui::TextDisabled("PNG, JPEG, or a film through ffmpeg; of numbered pictures all are taken, one a frame");
    const std::string chosen = browse(context, with, {reference_kinds(), 8});
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
    if (!chosen.empty() && references.open(chosen)) {
      dialogs.close();
      dialogs.state<FileChoice>().folder = fs::path(chosen).parent_path().string();
    }
  }
  end_dialog();
}

void show_sound_dialog(PanelContext& context, EditingSession& editing, SoundTrack& track, Files& files,
                       Preferences& preferences, Dialogs& dialogs) {
  const FileDialogsOwners with{files, preferences, dialogs};
  if (begin_dialog(context, "Sound on the timeline", k_file_dialog_wide)) {
    ImGui::TextDisabled("WAV, FLAC, OGG, MP3 or AIFF");
    // Also one whose file is gone.
    const bool has = editing.document().sound != nullptr;
    const std::string chosen = browse(context, with, {sound_kinds(), 8, has ? 2.0F : 1.0F});
    if (has && wide_button(context, "Take the sound away")) {
      track.remove();
      dialogs.close();
    }
    bool& for_speech = dialogs.state<FirstPassEntry>().wants_sound;
    if (wide_button(context, "Cancel")) context.cancels = true;
    if (context.cancels) for_speech = false;
    if (!chosen.empty()) {
      dialogs.close();
      dialogs.state<FileChoice>().folder = fs::path(chosen).parent_path().string();
      track.open(chosen);
      if (for_speech) dialogs.show(Dialog{"first pass"});
    }
  }
  end_dialog();
}

void show_recent_dialog(PanelContext& context, Leaving& leaving, Preferences& preferences) {
  if (begin_dialog(context, "Opened and saved before", k_file_dialog_wide)) {
    std::string chosen;
    const auto recent = preferences.settings().recent;
    if (recent.empty()) ImGui::TextUnformatted("Nothing yet.");
    begin_list(context, "recent", {0, 8 * context.unit}, true);
    for (const std::string& path : recent) {
      const std::string label = fs::path(path).filename().string() + "##recent " + path;
      if (wide_button(context, label.c_str(), -1, false, path.c_str())) chosen = path;
    }
    ImGui::EndChild();
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
    if (!chosen.empty()) leaving.ask_to_open(chosen);
  }
  end_dialog();
}

void show_save_dialog(PanelContext& context, Files& files, Leaving& leaving, Preferences& preferences,
                      Dialogs& dialogs) {
  const FileDialogsOwners with{files, preferences, dialogs};
  if (dialogs.state<FileChoice>().name.empty() && context.dialog_opens) {
    // A free name, so that Save alone is enough for whoever has no keyboard at hand.
    dialogs.state<FileChoice>().name = name_to_save(files, dialogs.state<FileChoice>().folder);
  }
  if (begin_dialog(context, "Save", k_file_dialog_wide)) {
    ImGui::TextDisabled("The whole project, as a .glb file that any viewer plays");
    std::string path;
    if (choose_name(context, with, "Save##now", path, project_path)) leaving.save_from_dialog(path);
  }
  end_dialog();
}

void show_export_dialog(PanelContext& context, Files& files, Notices& notices, Preferences& preferences,
                        Dialogs& dialogs) {
  const FileDialogsOwners with{files, preferences, dialogs};
  std::string& name = dialogs.state<FileChoice>().name;
  if (name.empty() && context.dialog_opens) {
    name = name_to_export(files, dialogs.state<FileChoice>().folder);
  }
  if (begin_dialog(context, "Export", k_file_dialog_wide)) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    const io::ModelFormat* chosen = io::format_of_name(name);
    bool starts_row = true;
    for (const io::ModelFormat& format : io::model_formats()) {
      if (format.holds.empty()) continue;
      const std::string label = std::string(format.holds) + " (" + std::string(format.extension) + ")";
      if (!starts_row) ImGui::SameLine();
      starts_row = !starts_row;
      if (wide_button(context, label.c_str(), half, &format == chosen, std::string(format.detail).c_str()))
        name = fs::path(name).replace_extension(format.extension).string();
    }
    std::string path;
    if (choose_name(context, with, "Export##now", path)) {
      if (const auto written = files.export_to(path); !written) {
        notices.tell(written.error().line(path), true);
      } else {
        context.actions.run(Action::cancel);
      }
    }
    if (files.has_several() && !path.empty() &&
        wide_button(context, "Each character##now", 0, false, "Write every character into a file of its own")) {
      if (const auto written = files.export_each(path); !written) {
        notices.tell(written.error().line(), true);
      } else {
        context.actions.run(Action::cancel);
      }
    }
  }
  end_dialog();
}

}  // namespace penpose::app
