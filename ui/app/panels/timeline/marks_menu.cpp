#include <algorithm>
#include <string>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

void show_marks_menu(PanelContext& context, const TimelineOwners& with, const char* name) {
  if (!begin_menu(context, name)) return;
  const auto entry = [&](Action action) {
    const std::string label(info(action).label);
    const std::string key = context.actions.keys().shortcut_of(action);
    ImGui::BeginDisabled(!context.actions.usable(action));
    if (menu_entry(context, label.c_str(), icon_of(action), key, std::string(info(action).tip).c_str())) {
      ImGui::CloseCurrentPopup();
      context.actions.run(action);
    }
    ImGui::EndDisabled();
  };
  for (const Action action : {Action{"bookmark"}, Action{"previous_bookmark"}, Action{"next_bookmark"}}) entry(action);
  const auto held = with.editing.document().bookmarks;
  constexpr std::size_t k_most_listed = 12;
  for (std::size_t i = 0; held && i < std::min(held->size(), k_most_listed); ++i) {
    const document::Bookmark& one = (*held)[i];
    const std::string frame = frame_text(one.time_s, with.playback.rate());
    const std::string label = (one.name.empty() ? "Frame " + frame : one.name) + "##bookmark " + frame;
    if (menu_entry(context, label.c_str(), icon_of(Action{"bookmark"}), frame, "Go there")) {
      ImGui::CloseCurrentPopup();
      with.playback.go_to(one.time_s);
    }
    const ImVec2 least = ImGui::GetItemRectMin();
    const ImVec2 most = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({least.x, least.y + scaled(4)}, {least.x + scaled(4), most.y - scaled(4)},
                                              bookmark_color(one.color), 2);
  }
  ImGui::Separator();
  for (const Action action : {Action::loop_from, Action::loop_to, Action::loop_off}) entry(action);
  ImGui::EndPopup();
}

}  // namespace penpose::app
