#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/widgets.h"

// The menu around the pen.

namespace penpose::app {

void show_radial_menu(PanelContext& context, const Area& /*area*/, Canvas& canvas, Preferences& preferences,
                      PanelState& panels) {
  auto& middle = panels.radial;
  if (!middle) return;
  const auto window = context.window;
  context.hits.all = true;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(window.width), static_cast<float>(window.height)});
  ImGui::SetNextWindowBgAlpha(0.25F);
  ImGui::SetNextWindowFocus();
  const float width = 2.4F * context.unit;
  const float reach = 2.9F * context.unit;
  // All of it stays on the canvas, or at least in the window where that is too small.
  const auto within = [](double at, double margin, double least, double most, double all) {
    const bool fits = most - least >= 2 * margin;
    const double from = (fits ? least : 0) + margin;
    return static_cast<float>(std::clamp(at, from, std::max(from, (fits ? most : all) - margin)));
  };
  const Area free = canvas.free_area();
  const double margin_x = static_cast<double>(reach + 0.5F * width + context.gap);
  const double margin_y = static_cast<double>(reach + 0.5F * context.unit + context.gap);
  const float x = within(middle->x, margin_x, free.left, free.right, window.width);
  const float y = within(middle->y, margin_y, free.top, free.bottom, window.height);
  bool close = false;
  if (ImGui::Begin("radial", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    constexpr float k_places[8][2] = {{0, -1}, {0.8F, -0.55F}, {1, 0},  {0.8F, 0.55F},
                                      {0, 1},  {-0.8F, 0.55F}, {-1, 0}, {-0.8F, -0.55F}};
    for (int i = 0; i < 8; ++i) {
      ImGui::SetCursorPos(
          {x + reach * k_places[i][0] - 0.5F * width, y + reach * k_places[i][1] - 0.5F * context.unit});
      ImGui::PushID(i);
      const Action action = preferences.settings().radial[static_cast<std::size_t>(i)];
      const std::string label = std::string(info(action).label) + "##radial";
      if (wide_button(context, label.c_str(), width)) {
        context.actions.run(action);
        close = true;
      }
      ImGui::PopID();
    }
    if (!close && ImGui::IsMouseClicked(0) && !ImGui::IsAnyItemHovered()) close = true;
  }
  ImGui::End();
  if (close) middle.reset();
}

}  // namespace penpose::app
