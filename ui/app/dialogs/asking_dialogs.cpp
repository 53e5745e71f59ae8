#include <filesystem>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/files/files.h"
#include "ui/app/files/leaving.h"
#include "ui/app/files/recording.h"
#include "ui/app/files/recovery.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/tour/tour_panel.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs that tell and ask.

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

}  // namespace

void show_recover_dialog(PanelContext& context, Recovery& recovery) {
  if (begin_dialog(context, "There is work that was not saved", 13)) {
    const std::string path = recovery.abandoned().empty() ? "" : recovery.abandoned().front();
    const std::string file = work_of_session(path);
    const std::string name = fs::path(path).stem().string();
    ImGui::TextWrapped("Your work on %s is safe, to the last stroke (session %s).",
                       file.empty() ? "the built-in head" : file.c_str(), name.c_str());
    if (primary_button(context, "Bring it back", 5 * context.unit) || context.accepts) {
      recovery.recover(true);
    } else {
      ImGui::SameLine();
      if (wide_button(context, "Start fresh", 5 * context.unit, false, "The session stays in the list of sessions"))
        recovery.recover(false);
    }
  }
  end_dialog();
}

void show_steps_dialog(PanelContext& context) {
  if (begin_dialog(context, "Draw, and the face follows", 14)) {
    ImGui::TextWrapped(
        "1   Draw the face you want over the one you see: a mouth, a brow, a lid. Each line finds its feature, and the "
        "face follows while you draw.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped(
        "2   Anything else with Pose, in two lines: draw along what should move, then where it should go.");
    ImGui::Dummy({1, context.gap});
    ImGui::TextWrapped("3   Press Key to keep the pose on the timeline, and Save. Undo takes back anything.");
    ImGui::Dummy({1, context.gap});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped(
        "Turn the view with the pen's button, the middle mouse button or two fingers. A click of the pen's button "
        "opens "
        "a menu around the pen.");
    ImGui::PopStyleColor();
    ImGui::TextWrapped("Or take a tour, step by step:");
    show_tour_buttons(context);
    if (primary_button(context, "Begin", -1) || context.accepts) context.actions.run(Action::cancel);
  }
  end_dialog();
}

void show_sessions_dialog(PanelContext& context, Files& files, Recording& recording, Notices& notices,
                          Dialogs& dialogs) {
  if (begin_dialog(context, "Sessions", 17)) {
    const std::string now = recording.path();
    ImGui::TextWrapped("Every stroke is saved as you draw. This session: %s",
                       now.empty() ? "not recorded" : now.c_str());
    begin_list(context, "sessions", {0, 8 * context.unit}, true);
    for (const std::string& path : recording.past()) {
      if (path == now) continue;
      ImGui::PushID(path.c_str());
      if (wide_button(context, "Play##session", 2.4F * context.unit, false, "Watch it in this window")) {
        if (const auto played = files.play_trace(path); !played) notices.tell(played.error().line(path), true);
      }
      ImGui::SameLine();
      if (wide_button(context, "Go on##session", 2.4F * context.unit, false, "Open where it ended"))
        files.try_open(path);
      ImGui::SameLine();
      text_beside(context, fs::path(path).stem().string().c_str());
      ImGui::PopID();
    }
    ImGui::EndChild();
    if (wide_button(context, "Close") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

void show_unsaved_dialog(PanelContext& context, Leaving& leaving, Dialogs& dialogs) {
  if (begin_dialog(context, "There is unsaved work", 13)) {
    ImGui::TextWrapped("The session list keeps it in any case.");
    if (primary_button(context, "Save first") || context.accepts) leaving.save_first();
    ImGui::SameLine();
    const char* without =
        dialogs.state<UnsavedWork>().then_opens.empty() ? "Quit without saving" : "Open without saving";
    if (wide_button(context, without)) leaving.go_on_without_saving();
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
  }
  end_dialog();
}

}  // namespace penpose::app
