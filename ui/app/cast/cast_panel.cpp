#include <algorithm>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/cast/cast.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The characters of the scene by their names, at the top of the canvas, where there are several.

namespace penpose::app {
namespace {

/// A longer name is cut off.
constexpr float k_widest_name_units = 5;
constexpr const char* k_eye_closed = "M3 11A12 11 9 180 360M6 15L4 17M12 17L12 20M18 15L20 17";

}  // namespace

void show_cast(PanelContext& context, const Area& /*area*/, Canvas& canvas, Cast& cast, ToolInHand& tool,
               PanelState& panels) {
  auto& bar = context.own.of<CanvasBars>().cast;
  bar.reset();
  if (!cast.several() || !panels.shown) return;
  const auto gap = static_cast<double>(context.gap);
  const Area free = canvas.free_area();
  const auto& film = context.own.of<FilmPlace>().area;
  const double top = (film ? film->bottom : free.top) + gap;
  ButtonRow row(context, "more characters");
  float wide = 0;
  const auto add = [&](ButtonRow::Button button) {
    wide += button_width(context, button.label.c_str(), button.icon, button.text) + ImGui::GetStyle().ItemSpacing.x;
    row.add(std::move(button));
  };
  for (std::size_t i = 0; i < cast.size(); ++i) {
    const Character& one = cast.at(i);
    const bool active = i == cast.active();
    add({.label = fitted_text(one.name, k_widest_name_units * context.unit) + "##character " + one.name,
         .icon = one.shown ? std::string_view() : std::string_view(k_eye_closed),
         .tip = active ? one.name + " is worked on" : "Work on " + one.name + (one.shown ? "" : ", which is hidden"),
         .chosen = active,
         .does = [&cast, i] { cast.ask_for(i); }});
  }
  const Action adds{"add_character"};
  const Action lists{"characters"};
  const Action places{"tool_place"};
  for (const Action action : {adds, places, lists}) {
    wide += context.unit + ImGui::GetStyle().ItemSpacing.x;
    row.add(action, action == places && tool.now().places, true, false);
  }
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  // The axes have the other corner.
  const double room = std::max(free.width() - 4.5 * static_cast<double>(context.unit), 2.0 * context.unit);
  const double width = std::min(static_cast<double>(wide + 2 * padding.x), room);
  const double height = static_cast<double>(context.unit + 2 * padding.y);
  bar = Area{free.left + gap, top, free.left + gap + width + 1, top + height};
  if (begin_panel(context, "characters", *bar)) row.show(ImGui::GetContentRegionAvail().x);
  end_panel();
}

}  // namespace penpose::app
