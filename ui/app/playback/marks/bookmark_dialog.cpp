#include <string>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"
#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/marks/bookmark_steps.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

void show_bookmark_dialog(PanelContext& context, EditingSession& editing, const Playback& playback, Dialogs& dialogs) {
  BookmarkEntry& entry = dialogs.state<BookmarkEntry>();
  const std::string title = "Bookmark at frame " + frame_text(entry.time_s, playback.rate()) + "###bookmark";
  if (begin_dialog(context, title.c_str(), 11)) {
    dialog_field(context, "##bookmark name", entry.name, "hit");
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    constexpr auto k_colors = static_cast<float>(document::k_bookmark_colors);
    const float width = (ImGui::GetContentRegionAvail().x - (k_colors - 1) * spacing) / k_colors;
    for (std::uint32_t color = 0; color < document::k_bookmark_colors; ++color) {
      if (color > 0) ImGui::SameLine();
      const std::string label = "##bookmark color " + std::to_string(color);
      if (wide_button(context, label.c_str(), width, entry.color == color, "The colour of its flag"))
        entry.color = color;
      const ImVec2 least = ImGui::GetItemRectMin();
      const ImVec2 most = ImGui::GetItemRectMax();
      ImGui::GetWindowDrawList()->AddRectFilled({least.x + scaled(6), least.y + scaled(6)},
                                                {most.x - scaled(6), most.y - scaled(6)}, bookmark_color(color), 4);
    }
    ImGui::Dummy({1, context.gap});
    if (wide_button(context, "Keep##bookmark", 3.4F * context.unit) || context.accepts) {
      entry.name.resize(std::min(entry.name.size(), document::k_longest_bookmark));
      if (editing.perform(document::SetBookmark{entry.time_s, entry.name, entry.color})) dialogs.show(Dialog::none);
    }
    ImGui::SameLine();
    if (wide_button(context, "Delete##bookmark", 3.4F * context.unit)) {
      if (bookmark_at(editing.document(), entry.time_s) != nullptr)
        editing.perform(document::DeleteBookmark{{entry.time_s}});
      dialogs.show(Dialog::none);
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
