#include <utility>

#include "ui/app/files/player.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/widgets.h"

// A recording that is played in place of tablets.

namespace penpose::app {

void show_player(PanelContext& context, const Area& area, Player& player) {
  auto& trace = player.trace;
  if (!trace) return;
  if (begin_panel(context, "player", area)) {
    if (wide_button(context, trace->playing() ? "Pause" : "Go on", 2.4F * context.unit))
      trace->set_playing(!trace->playing());
    for (const auto& [speed, label] :
         {std::pair{0.5, "x1/2"}, std::pair{1.0, "x1"}, std::pair{4.0, "x4"}, std::pair{16.0, "x16"}}) {
      ImGui::SameLine();
      if (wide_button(context, label, 0, trace->speed() == speed)) trace->set_speed(speed);
    }
    ImGui::SameLine();
    const bool close = wide_button(context, "Close##player");
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(trace->progress()), {-1, context.unit},
                       trace->finished() ? "finished" : "playing a recording");
    if (close) trace.reset();
  }
  end_panel();
}

}  // namespace penpose::app
