#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/files/recording.h"
#include "ui/app/files/system_dialogs.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/poses/pose_shelf.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/widgets.h"

// All that is chosen once and kept, in one place.

namespace penpose::app {
namespace {

enum class Tab : std::uint8_t { view, pen, keys, time, folders };

/// The tab that is shown.
struct PreferencesShown {
  Tab tab = Tab::view;
  std::string pose_folder;  ///< being typed
};

/// What is shown and changed here.
struct PreferencesDialogOwners {
  const EditingSession& editing;
  Playback& playback;
  Preferences& preferences;
  const Recording& recording;
  const SystemDialogs& system;
  Dialogs& dialogs;
  PanelState& panels;
  PoseShelf& shelf;
};

/// Equal buttons in a row, of which one is chosen; gives the one that was pressed, or -1.
template <std::size_t count>
int one_of(PanelContext& context, const std::array<std::string, count>& labels, int chosen) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * spacing) / count;
  int pressed = -1;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) ImGui::SameLine();
    if (wide_button(context, labels[i].c_str(), width, static_cast<int>(i) == chosen)) pressed = static_cast<int>(i);
  }
  return pressed;
}

/// A dialog of its own, which this one makes room for.
void leads_to(PanelContext& context, const PreferencesDialogOwners& with, const char* label, Dialog dialog,
              const char* tip) {
  if (!wide_button(context, label, -1, false, tip)) return;
  with.dialogs.state<SearchEntry>() = {};
  with.dialogs.show(dialog);
}

void show_view(PanelContext& context, const PreferencesDialogOwners& with) {
  Settings& settings = with.preferences.settings();
  ImGui::TextUnformatted("Colours");
  if (const int to = one_of<2>(context, {"Dark##colours", "Light##colours"}, settings.light ? 1 : 0); to >= 0) {
    settings.light = to == 1;
    with.preferences.changed();
  }
  ImGui::TextUnformatted("Soft shadows, in cavities and on the ground: a slow computer does without");
  const int shadows = one_of<2>(context, {"On##shadows", "Off##shadows"}, settings.soft_shadows ? 0 : 1);
  if (shadows >= 0) {
    settings.soft_shadows = shadows == 0;
    with.preferences.changed();
  }
  std::array<char, 80> size{};
  std::snprintf(size.data(), size.size(), "Size: %.0f %% of what the screen has by itself", 100 * settings.scale);
  ImGui::TextUnformatted(size.data());
  const int step = one_of<2>(context, {"Smaller##size", "Larger##size"}, -1);
  if (step >= 0) context.actions.run(step == 0 ? Action::smaller : Action::larger);
  ImGui::TextUnformatted("Density");
  const int density =
      one_of<3>(context, {"Compact##density", "Usual##density", "Touch##density"}, static_cast<int>(settings.density));
  if (density >= 0) {
    settings.density = static_cast<Density>(density);
    with.preferences.changed();
  }
}

void show_pen(PanelContext& context, const PreferencesDialogOwners& with) {
  Settings& settings = with.preferences.settings();
  ImGui::TextUnformatted("Steady line: smooth drawn lines on screen");
  const int steady =
      one_of<3>(context, {"Off##steady", "Light##steady", "Strong##steady"}, static_cast<int>(settings.stabiliser));
  if (steady >= 0) {
    settings.stabiliser = static_cast<Stabiliser>(steady);
    with.preferences.changed();
  }
  leads_to(context, with, "Tablet: area and pressure##preferences", Dialog::tablet, "Area and pressure");
}

void show_keys(PanelContext& context, const PreferencesDialogOwners& with) {
  leads_to(context, with, "Keys of the keyboard##preferences", Dialog{"keyboard"},
           "What each key does, and other keys");
  leads_to(context, with, "Keys and rings of the tablet##preferences", Dialog::pad,
           "What tablet keys, rings and pen buttons do");
  leads_to(context, with, "Menu around the pen##preferences", Dialog::radial, "What it offers");
  bool& keyboard = with.panels.has_keyboard;
  if (wide_button(context, "Keys on the screen while a name is typed##preferences", -1, !keyboard,
                  "For use without a keyboard; a real key turns it off"))
    keyboard = !keyboard;
}

void show_time(PanelContext& context, const PreferencesDialogOwners& with) {
  ImGui::TextWrapped("Frames a second of what has none of its own: a file opens with the rate that fits its keys.");
  std::array<std::string, k_frame_rates.size()> labels;
  int chosen = -1;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i] = std::to_string(k_frame_rates[i]) + "##rate";
    if (k_frame_rates[i] == with.preferences.settings().rate) chosen = static_cast<int>(i);
  }
  const int to = one_of(context, labels, chosen);
  if (to < 0) return;
  const int rate = k_frame_rates[static_cast<std::size_t>(to)];
  // What is keyed keeps its frames.
  if (with.editing.document().timeline->keys.empty()) return with.playback.set_rate(rate);
  with.preferences.settings().rate = rate;
  with.preferences.changed();
}

/// Where the library of poses is.
void show_pose_folder(PanelContext& context, const PreferencesDialogOwners& with) {
  std::string& typed = with.dialogs.state<PreferencesShown>().pose_folder;
  ImGui::TextWrapped("Library of poses: %s", with.shelf.folder().c_str());
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float use = button_width(context, "Use it", {}, true);
  const float usual = button_width(context, "Usual", {}, true);
  text_field(context, "##pose folder", typed, ImGui::GetContentRegionAvail().x - use - usual - 2 * spacing,
             "another folder, from /");
  const bool fits = std::filesystem::path(typed).is_absolute();
  ImGui::SameLine();
  ImGui::BeginDisabled(!fits);
  if (wide_button(context, "Use it##pose folder", use, false, "Use this folder for the library")) {
    with.shelf.choose_folder(typed);
    typed.clear();
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(with.shelf.folder() == with.shelf.usual_folder());
  if (wide_button(context, "Usual##pose folder", usual, false, with.shelf.usual_folder().c_str()))
    with.shelf.choose_folder({});
  ImGui::EndDisabled();
}

void show_folders(PanelContext& context, const PreferencesDialogOwners& with) {
  const std::string session = with.recording.path();
  if (with.system.available()) {
    ImGui::TextUnformatted("Dialogs of files");
    Settings& settings = with.preferences.settings();
    const int to = one_of<2>(context, {"The system's##files", "penpose's own##files"}, settings.system_dialogs ? 0 : 1);
    if (to >= 0) {
      settings.system_dialogs = to == 0;
      with.preferences.changed();
    }
  }
  ImGui::TextWrapped("Autosave: every stroke is saved as you draw. After a crash the next start continues.");
  ImGui::TextWrapped("Session: %s", session.empty() ? "not recorded" : session.c_str());
  ImGui::TextWrapped("Settings: %s", standard_folders().config.c_str());
  show_pose_folder(context, with);
  leads_to(context, with, "Sessions##preferences", Dialog::sessions, "Earlier sessions, to play or continue");
  auto& recent = with.preferences.settings().recent;
  const std::string label = "Forget the list of recent files (" + std::to_string(recent.size()) + ")##recent";
  ImGui::BeginDisabled(recent.empty());
  if (wide_button(context, label.c_str(), -1, false, "Clear the list; the files stay")) {
    recent.clear();
    with.preferences.changed();
  }
  ImGui::EndDisabled();
}

}  // namespace

void show_preferences_dialog(PanelContext& context, const EditingSession& editing, Playback& playback,
                             Preferences& preferences, const Recording& recording, const SystemDialogs& system,
                             Dialogs& dialogs, PanelState& panels, PoseShelf& shelf) {
  const PreferencesDialogOwners with{editing, playback, preferences, recording, system, dialogs, panels, shelf};
  Tab& tab = dialogs.state<PreferencesShown>().tab;
  if (begin_dialog(context, "Preferences", 16)) {
    const int to =
        one_of<5>(context, {"View##tab", "Pen##tab", "Keys##tab", "Time##tab", "Folders##tab"}, static_cast<int>(tab));
    if (to >= 0) tab = static_cast<Tab>(to);
    constexpr float k_rows = 6;
    begin_list(context, "preferences", {0, k_rows * (context.unit + ImGui::GetStyle().ItemSpacing.y)});
    constexpr std::array k_shown{show_view, show_pen, show_keys, show_time, show_folders};
    k_shown[static_cast<std::size_t>(tab)](context, with);
    ImGui::EndChild();
    if (primary_button(context, "Done") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
