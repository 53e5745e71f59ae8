#include <algorithm>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/dialogs/found_command.h"
#include "ui/app/files/leaving.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs in which something is looked up: the search, the list of keys, the list of what was done.

namespace penpose::app {
namespace {

constexpr float k_find_dialog_wide = 17;

/// What is looked through, and changed by what is found.
struct FindDialogsOwners {
  EditingSession& editing;
  Playback& playback;
  const Preferences& preferences;
  Leaving& leaving;
  Dialogs& dialogs;
  PanelState& panels;
};

SearchedIn searched_in(const FindDialogsOwners& with) {
  return {with.editing.document(), with.preferences.settings().keys, with.playback.rate(),
          with.preferences.settings().recent, with.editing.words()};
}

std::string_view icon_of(const FoundCommand& found) {
  switch (found.kind) {
    case FoundCommand::Kind::action:
      return app::icon_of(found.action);
    case FoundCommand::Kind::control:
      return icon::k_radial;
    case FoundCommand::Kind::pose:
      return app::icon_of(Action::key_pose);
    case FoundCommand::Kind::file:
      return app::icon_of(Action::open);
  }
  return {};
}

/// A row of a list, as wide as it. `label`: with what tells it from others behind "##".
bool row(PanelContext& context, const std::string& label, std::string_view drawn, const std::string& detail,
         bool chosen, const char* tip = nullptr) {
  ButtonLook look{-1, chosen, tip, drawn};
  look.width = ImGui::GetContentRegionAvail().x;
  look.left_aligned = true;
  look.key = detail;
  return icon_button(context, label.c_str(), look);
}

void move_choice(std::size_t& chosen, std::size_t count) {
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++chosen;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) && chosen > 0) --chosen;
  chosen = count == 0 ? 0 : std::min(chosen, count - 1);
}

/// Px that a list may have.
float list_height(const PanelContext& context) {
  return std::min(9 * context.unit, static_cast<float>(context.window.height) - 5 * context.unit);
}

/// Does it: an action; a control is shown alone in the panel; the playhead goes to a pose; a file is opened.
void do_found(PanelContext& context, const FindDialogsOwners& with, const FoundCommand& found) {
  with.dialogs.show(Dialog::none);
  switch (found.kind) {
    case FoundCommand::Kind::action:
      context.actions.run(found.action);
      break;
    case FoundCommand::Kind::control:
      with.panels.open_side();
      with.panels.controls_tab = false;
      with.panels.own.of<ParameterList>().moved_only = false;
      with.panels.own.of<ParameterList>().filter = found.control;
      break;
    case FoundCommand::Kind::pose:
      with.playback.go_to(found.time_s);
      break;
    case FoundCommand::Kind::file:
      with.leaving.ask_to_open(found.detail);
      break;
  }
}

}  // namespace

void show_search_dialog(PanelContext& context, EditingSession& editing, Playback& playback, Preferences& preferences,
                        Leaving& leaving, Dialogs& dialogs, PanelState& panels) {
  const FindDialogsOwners with{editing, playback, preferences, leaving, dialogs, panels};
  if (begin_dialog(context, "Search", k_find_dialog_wide)) {
    const std::string before = dialogs.state<SearchEntry>().text;
    dialog_field(context, "##find", dialogs.state<SearchEntry>().text, "an action, a control, a pose, a file");
    if (dialogs.state<SearchEntry>().text != before) dialogs.state<SearchEntry>().chosen = 0;
    const auto found = find_commands(searched_in(with), dialogs.state<SearchEntry>().text);
    move_choice(dialogs.state<SearchEntry>().chosen, found.size());
    std::optional<FoundCommand> done;
    begin_list(context, "found", {0, list_height(context)}, true);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const FoundCommand& one = found[i];
      const std::string label = one.text + "##found " + std::to_string(static_cast<int>(one.kind)) + one.detail;
      if (row(context, label, icon_of(one), one.detail, i == dialogs.state<SearchEntry>().chosen, one.control.c_str()))
        done = one;
      if (i == dialogs.state<SearchEntry>().chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    if (found.empty()) ImGui::TextWrapped("Nothing is called that.");
    ImGui::EndChild();
    if (context.accepts && !found.empty()) done = found[dialogs.state<SearchEntry>().chosen];
    if (done) do_found(context, with, *done);
  }
  end_dialog();
}

void show_shortcuts_dialog(PanelContext& context, EditingSession& editing, Playback& playback, Preferences& preferences,
                           Leaving& leaving, Dialogs& dialogs, PanelState& panels) {
  const FindDialogsOwners with{editing, playback, preferences, leaving, dialogs, panels};
  if (begin_dialog(context, "Keys", k_find_dialog_wide)) {
    dialog_field(context, "##key search", dialogs.state<SearchEntry>().text, "search");
    std::optional<FoundCommand> done;
    begin_list(context, "keys", {0, list_height(context)}, true);
    for (const FoundCommand& one : find_commands(searched_in(with), dialogs.state<SearchEntry>().text)) {
      if (one.kind != FoundCommand::Kind::action) continue;
      const ActionInfo& action = info(one.action);
      const std::string second = shortcut_text(context.actions.keys().keys_of(one.action)[1]);
      const std::string keys = one.detail + (second.empty() ? "" : "  or  " + second);
      if (keys.empty()) continue;
      if (row(context, one.text + "##shortcut", icon_of(one), keys, false, std::string(action.tip).c_str())) done = one;
    }
    ImGui::EndChild();
    ImGui::TextDisabled("The pen's button or the middle mouse button turns the view; with Shift it moves it.");
    if (wide_button(context, "Other keys##shortcuts", 0, false, "Choose which key does what")) {
      dialogs.state<SearchEntry>() = {};
      dialogs.show(Dialog{"keyboard"});
    }
    ImGui::SameLine();
    if (wide_button(context, "Close") || context.accepts) dialogs.show(Dialog::none);
    if (done) do_found(context, with, *done);
  }
  end_dialog();
}

void show_history_dialog(PanelContext& context, EditingSession& editing, Playback& playback, Dialogs& dialogs) {
  if (begin_dialog(context, "What was done", 12)) {
    const auto steps = editing.steps().list();
    const std::size_t done = editing.editor().history().undo_count();
    begin_list(context, "steps", {0, list_height(context)}, true);
    std::optional<std::size_t> to;
    const bool nothing = steps.empty() || steps.front().undone;
    if (row(context, "Opened##step 0", app::icon_of(Action::open), {}, nothing)) to = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool now = !steps[i].undone && (i + 1 == steps.size() || steps[i + 1].undone);
      const std::string label = steps[i].text + "##step " + std::to_string(i + 1);
      const std::string detail = steps[i].undone ? "undone" : std::to_string(i + 1);
      if (row(context, label, {}, detail, now)) to = steps[i].end;
      if (now && context.dialog_opens) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    if (to && *to != done) playback.go_to_step(*to);
    if (wide_button(context, "Close") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
