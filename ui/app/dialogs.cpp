#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr float k_wide = 17;

bool opens(const fs::path& path) {
  constexpr std::array k_extensions{".glb", ".gltf", ".obj", ".ply", ".off", ".stl", ".session", ".hid", ".trace"};
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return std::find(k_extensions.begin(), k_extensions.end(), extension) != k_extensions.end();
}

/// Folders first, then what can be opened, by name.
std::vector<fs::directory_entry> entries_of(const std::string& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->path().filename().string().starts_with('.')) continue;
    std::error_code ignored;
    if (it->is_directory(ignored) || opens(it->path())) entries.push_back(*it);
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    std::error_code ignored;
    const bool a_folder = a.is_directory(ignored);
    const bool b_folder = b.is_directory(ignored);
    return a_folder != b_folder ? a_folder : a.path().filename() < b.path().filename();
  });
  return entries;
}

/// The folder with its parent and what is in it. Gives the file that was chosen.
std::string browse(PanelContext& context, float height) {
  std::string& folder = context.app.panels().folder;
  std::string chosen;
  ImGui::TextUnformatted(folder.c_str());
  ImGui::BeginChild("files", {0, height}, true);
  if (wide_button(context, "..##parent", -1)) folder = fs::path(folder).parent_path().string();
  for (const auto& entry : entries_of(folder)) {
    std::error_code ignored;
    const bool is_folder = entry.is_directory(ignored);
    const std::string name = entry.path().filename().string() + (is_folder ? "/" : "");
    if (!wide_button(context, name.c_str(), -1)) continue;
    if (is_folder) {
      folder = entry.path().string();
      break;
    }
    chosen = entry.path().string();
  }
  ImGui::EndChild();
  return chosen;
}

void open_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Open", k_wide)) {
    std::string chosen;
    if (wide_button(context, "The built-in head with its controls", -1)) chosen = "builtin:demo";
    if (wide_button(context, "The built-in head alone, to sketch controls on", -1)) chosen = "builtin:head";
    const auto recent = app.settings().recent;
    constexpr std::size_t k_shown = 3;
    for (std::size_t i = 0; i < std::min(k_shown, recent.size()); ++i) {
      if (wide_button(context, recent[i].c_str(), -1, false, "Opened before")) chosen = recent[i];
    }
    if (const std::string file = browse(context, 7 * context.unit); !file.empty()) chosen = file;
    if (wide_button(context, "Cancel")) app.panels().dialog = Dialog::none;
    if (!chosen.empty()) app.ask_to_open(chosen);
  }
  end_dialog();
}

void save_dialog(PanelContext& context) {
  App& app = context.app;
  PanelState& panels = app.panels();
  if (panels.file_name.empty()) {
    const std::string from = !app.project().empty() ? app.project() : app.path();
    const std::string stem = from.starts_with("builtin:") ? "head" : fs::path(from).stem().string();
    // A free name, so that Save alone is enough for whoever has no keyboard at hand.
    panels.file_name = app.project().empty() ? fs::path(free_path(panels.folder, stem, ".glb")).filename().string()
                                             : fs::path(app.project()).filename().string();
  }
  if (begin_dialog(context, "Save", k_wide)) {
    text_field(context, "##name", panels.file_name, -1, "name.glb");
    ImGui::TextDisabled(".glb keeps the whole project and plays in any viewer; .obj keeps the pose alone");
    if (const std::string file = browse(context, 6 * context.unit); !file.empty()) {
      panels.file_name = fs::path(file).filename().string();
    }
    if (wide_button(context, "Save##now", 4 * context.unit) && !panels.file_name.empty()) {
      const std::string path = (fs::path(panels.folder) / panels.file_name).string();
      if (const auto saved = app.save(path); !saved) {
        app.tell(saved.error().line(path), true);
      } else {
        panels.dialog = Dialog::none;
        panels.file_name.clear();
      }
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) {
      panels.dialog = Dialog::none;
      panels.file_name.clear();
    }
  }
  end_dialog();
}

void recover_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "There is work that was not saved", 13)) {
    const std::string name = app.abandoned().empty() ? "" : fs::path(app.abandoned().front()).stem().string();
    ImGui::TextWrapped("What was drawn in the session %s is kept, to the last stroke.", name.c_str());
    if (wide_button(context, "Bring it back", 5 * context.unit)) {
      app.recover(true);
    } else {
      ImGui::SameLine();
      if (wide_button(context, "Start anew", 5 * context.unit, false, "The session stays in the list of sessions"))
        app.recover(false);
    }
  }
  end_dialog();
}

void steps_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Draw, and the face follows", 14)) {
    ImGui::TextWrapped("1   Draw along a feature as it is: the line of the mouth, a brow, an eyelid.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped(
        "2   Draw where it should go. The face follows while you draw and settles when you lift the pen.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped("3   Press Key to keep the pose on the timeline, and Save. Undo takes back anything.");
    ImGui::Dummy({1, context.gap});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped(
        "Turn the view with the pen's button, the middle mouse button or two fingers. A click of the pen's button "
        "opens "
        "a menu around the pen.");
    ImGui::PopStyleColor();
    if (wide_button(context, "Begin", -1)) {
      app.panels().dialog = Dialog::none;
      app.settings().steps_seen = true;
      app.settings_changed();
    }
  }
  end_dialog();
}

void sessions_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Sessions", k_wide)) {
    const std::string now = app.session_path();
    ImGui::TextWrapped("Everything that is drawn is recorded. This session: %s",
                       now.empty() ? "not recorded" : now.c_str());
    ImGui::BeginChild("sessions", {0, 8 * context.unit}, true);
    for (const std::string& path : past_sessions(app.options().folders.state + "/sessions")) {
      if (path == now) continue;
      ImGui::PushID(path.c_str());
      if (wide_button(context, "Play##session", 2.4F * context.unit, false, "Watch it in this window")) {
        if (const auto played = app.play_trace(path); !played) app.tell(played.error().line(path), true);
      }
      ImGui::SameLine();
      if (wide_button(context, "Go on##session", 2.4F * context.unit, false, "Open where it ended")) app.try_open(path);
      ImGui::SameLine();
      text_beside(context, fs::path(path).stem().string().c_str());
      ImGui::PopID();
    }
    ImGui::EndChild();
    if (wide_button(context, "Close")) app.panels().dialog = Dialog::none;
  }
  end_dialog();
}

void unsaved_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "There is unsaved work", 13)) {
    ImGui::TextWrapped("It is kept in the list of sessions in any case.");
    const std::string next = app.panels().after_unsaved;
    if (wide_button(context, "Save first")) app.panels().dialog = Dialog::save;
    ImGui::SameLine();
    if (wide_button(context, "Go on without saving")) {
      app.panels().dialog = Dialog::none;
      if (next.empty()) {
        app.quit();
      } else {
        app.try_open(next);
      }
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) app.panels().dialog = Dialog::none;
  }
  end_dialog();
}

}  // namespace

void show_dialog(PanelContext& context) {
  switch (context.app.panels().dialog) {
    case Dialog::none:
      break;
    case Dialog::open:
      open_dialog(context);
      break;
    case Dialog::save:
      save_dialog(context);
      break;
    case Dialog::recover:
      recover_dialog(context);
      break;
    case Dialog::steps:
      steps_dialog(context);
      break;
    case Dialog::tablet:
      show_tablet_dialog(context);
      break;
    case Dialog::number:
      show_number_dialog(context);
      break;
    case Dialog::key_name:
      show_key_dialog(context);
      break;
    case Dialog::radial:
      show_radial_dialog(context);
      break;
    case Dialog::sessions:
      sessions_dialog(context);
      break;
    case Dialog::unsaved:
      unsaved_dialog(context);
      break;
  }
}

}  // namespace penpose::app
