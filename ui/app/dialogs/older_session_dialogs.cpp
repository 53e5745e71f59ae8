#include <string>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/files/files.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/widgets.h"

// The question before a session of an older edition is opened, and what came of it.

namespace penpose::app {

void show_older_session_dialog(PanelContext& context, Files& files, Notices& notices, Dialogs& dialogs) {
  const OlderSession asked = dialogs.state<OlderSession>();
  if (begin_dialog(context, "A session of an older edition", 14)) {
    ImGui::TextWrapped("This session was drawn in edition %u. Draw it again with today's reading?", asked.edition);
    ImGui::TextWrapped(
        "Some strokes may mean something else today; you will see which. The session itself stays as it "
        "is, and a new one goes on from it.");
    if (primary_button(context, "Draw it again", 5 * context.unit) || context.accepts) {
      dialogs.close();
      if (const auto drawn = files.draw_again(asked.path); !drawn) notices.tell(drawn.error().line(asked.path), true);
    } else {
      ImGui::SameLine();
      if (wide_button(context, "Cancel", 4 * context.unit)) context.actions.run(Action::cancel);
    }
  }
  end_dialog();
}

void show_drawn_again_dialog(PanelContext& context, Dialogs& dialogs) {
  constexpr std::size_t k_most_rows = 1000;
  const DrawnAgain& drawn = dialogs.state<DrawnAgain>();
  if (begin_dialog(context, "Drawn again", 17)) {
    ImGui::TextWrapped("%s, %s.", drawn.name.c_str(), replay::summary_of(drawn.redrawn).c_str());
    if (drawn.redrawn.other_model) ImGui::TextWrapped("The model is not in the state in which the session began.");
    begin_list(context, "steps", {0, 7 * context.unit}, true);
    std::size_t rows = 0;
    for (const replay::RedrawnStep& step : drawn.redrawn.steps) {
      const std::string text = replay::text_of(step);
      if (!text.empty() && ++rows <= k_most_rows) ImGui::TextWrapped("%s", text.c_str());
    }
    if (rows > k_most_rows) ImGui::TextWrapped("and %zu more", rows - k_most_rows);
    ImGui::EndChild();
    if (wide_button(context, "Close") || context.accepts) dialogs.close();
  }
  end_dialog();
}

}  // namespace penpose::app
