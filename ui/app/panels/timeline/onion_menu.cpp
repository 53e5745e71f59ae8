#include <algorithm>
#include <string>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// A number with a button on each side of it, a step each.
void show_count(PanelContext& context, const std::string& name, const std::string& shown, int& count, int least,
                int most) {
  const float button = 1.2F * context.unit;
  const auto step = [&](const char* sign, std::string_view drawn, int by, const char* tip) {
    const std::string label = std::string(sign) + "##" + name;
    ImGui::BeginDisabled(count + by < least || count + by > most);
    if (icon_button(context, label.c_str(), {button, false, tip, drawn, false})) count += by;
    ImGui::EndDisabled();
  };
  step("Fewer", icon::k_minus, -1, "One less");
  ImGui::SameLine();
  step("More", icon::k_plus, 1, "One more");
  ImGui::SameLine();
  text_beside(context, shown.c_str());
}

/// Two buttons of which one is chosen.
template <typename Choice>
void show_choice(PanelContext& context, Choice& chosen, const std::array<std::pair<Choice, const char*>, 2>& choices,
                 const std::array<const char*, 2>& tips) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const bool now = chosen == choices[i].first;
    if (wide_button(context, choices[i].second, 4.2F * context.unit, now, tips[i])) chosen = choices[i].first;
  }
}

void show_onion_menu(PanelContext& context, CanvasLook& look) {
  using render::GhostSteps;
  using render::GhostStyle;
  render::GhostLook& ghosts = look.ghosts;
  const bool frames = ghosts.steps == GhostSteps::frames;
  show_choice<GhostStyle>(
      context, ghosts.style, {{{GhostStyle::contours, "Contours"}, {GhostStyle::faces, "Faces"}}},
      {"The lines of each face: the least to draw", "Translucent faces, with their lines: more to draw"});
  show_choice<GhostSteps>(context, ghosts.steps, {{{GhostSteps::keys, "At keys"}, {GhostSteps::frames, "At frames"}}},
                          {"The keys before and after", "Every so many frames before and after"});
  const auto counted = [&](int count, const char* side) {
    const char* what = frames ? "" : count == 1 ? " key" : " keys";
    return std::to_string(count) + what + " " + side;
  };
  show_count(context, "before", counted(ghosts.before, "before"), ghosts.before, 0, render::k_most_ghosts);
  show_count(context, "after", counted(ghosts.after, "after"), ghosts.after, 0, render::k_most_ghosts);
  if (frames) {
    const std::string each =
        ghosts.every == 1 ? std::string("each frame") : "every " + std::to_string(ghosts.every) + " frames";
    show_count(context, "frames", each, ghosts.every, 1, render::k_most_ghost_frames);
  }
  if (wide_button(context, "In films, too", 8.4F * context.unit + context.gap, look.ghosts_in_films,
                  "Films and playblasts show them as the canvas does"))
    look.ghosts_in_films = !look.ghosts_in_films;
}

}  // namespace

void show_onion_button(PanelContext& context, CanvasLook& look, float width) {
  // How many are seen on each side, as they are seen: "-1 +1", in their colours' order.
  const std::string label =
      "-" + std::to_string(look.ghosts.before) + " +" + std::to_string(look.ghosts.after) + "##onion";
  if (wide_button(context, label.c_str(), width, false, "How many faces before and after are shown, and how"))
    ImGui::OpenPopup("onion options");
  if (!begin_menu(context, "onion options")) return;
  show_onion_menu(context, look);
  ImGui::EndPopup();
}

}  // namespace penpose::app
