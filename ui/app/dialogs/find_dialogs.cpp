#include <algorithm>

#include "ui/app/dialogs/found_command.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs in which something is looked up: the search, the list of keys, the list of what was done.

namespace penpose::app {
namespace {

constexpr float k_wide = 17;

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
  return std::min(9 * context.unit, static_cast<float>(context.app.canvas().window().height) - 5 * context.unit);
}

}  // namespace

void show_search_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Search", k_wide)) {
    const std::string before = app.dialogs().state<SearchEntry>().text;
    dialog_field(context, "##find", app.dialogs().state<SearchEntry>().text, "an action, a control, a pose, a file");
    if (app.dialogs().state<SearchEntry>().text != before) app.dialogs().state<SearchEntry>().chosen = 0;
    const auto found = find_commands(app, app.dialogs().state<SearchEntry>().text);
    move_choice(app.dialogs().state<SearchEntry>().chosen, found.size());
    std::optional<FoundCommand> done;
    ImGui::BeginChild("found", {0, list_height(context)}, true);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const FoundCommand& one = found[i];
      const std::string label = one.text + "##found " + std::to_string(static_cast<int>(one.kind)) + one.detail;
      if (row(context, label, icon_of(one), one.detail, i == app.dialogs().state<SearchEntry>().chosen)) done = one;
      if (i == app.dialogs().state<SearchEntry>().chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    if (found.empty()) ImGui::TextWrapped("Nothing is called that.");
    ImGui::EndChild();
    if (context.accepts && !found.empty()) done = found[app.dialogs().state<SearchEntry>().chosen];
    if (done) do_found(app, *done);
  }
  end_dialog();
}

void show_shortcuts_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "Keys", k_wide)) {
    dialog_field(context, "##key search", app.dialogs().state<SearchEntry>().text, "search");
    std::optional<FoundCommand> done;
    ImGui::BeginChild("keys", {0, list_height(context)}, true);
    for (const FoundCommand& one : find_commands(app, app.dialogs().state<SearchEntry>().text)) {
      if (one.kind != FoundCommand::Kind::action) continue;
      const ActionInfo& action = info(one.action);
      const std::string second = shortcut_text(action.other);
      const std::string keys = one.detail + (second.empty() ? "" : "  or  " + second);
      if (keys.empty()) continue;
      if (row(context, one.text + "##shortcut", icon_of(one), keys, false, std::string(action.tip).c_str())) done = one;
    }
    ImGui::EndChild();
    ImGui::TextDisabled("The pen's button or the middle mouse button turns the view; with Shift it moves it.");
    if (wide_button(context, "Close") || context.accepts) app.dialogs().show(Dialog::none);
    if (done) do_found(app, *done);
  }
  end_dialog();
}

void show_history_dialog(PanelContext& context) {
  App& app = context.app;
  if (begin_dialog(context, "What was done", 12)) {
    const auto steps = app.editing().steps();
    const std::size_t done = app.editing().editor().history().undo_count();
    ImGui::BeginChild("steps", {0, list_height(context)}, true);
    std::optional<std::size_t> to;
    const bool nothing = steps.empty() || steps.front().undone;
    if (row(context, "As it was opened##step 0", app::icon_of(Action::open), {}, nothing)) to = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool now = !steps[i].undone && (i + 1 == steps.size() || steps[i + 1].undone);
      const std::string label = steps[i].text + "##step " + std::to_string(i + 1);
      const std::string detail = steps[i].undone ? "undone" : std::to_string(i + 1);
      if (row(context, label, {}, detail, now)) to = steps[i].end;
      if (now && context.dialog_opens) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    if (to && *to != done) app.playback().go_to_step(*to);
    if (wide_button(context, "Close") || context.accepts) app.dialogs().show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
