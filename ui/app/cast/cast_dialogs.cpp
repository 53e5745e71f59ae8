#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "ui/app/cast/cast.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/file_browser.h"
#include "ui/app/files/files.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs of several characters: which one is added, and how they are called and stand.

namespace penpose::app {
namespace {

constexpr float k_add_dialog_wide = 22, k_cast_dialog_wide = 16;
/// Sliders go so far, in sizes of the scene.
constexpr double k_far_sizes = 2;
constexpr double k_least_size = 0.1, k_largest_size = 10;
constexpr const char* k_eye = "M3 12A12 15 9.5 200 340M3 12A12 9 9.5 20 160C12 12 3";

/// What is being typed as a name.
struct CharacterNameEntry {
  std::string text;
  std::size_t of = 0;
  std::uint64_t revision = 0;
};

geometry::Box box_of_all(const Cast& cast) {
  geometry::Box all;
  for (std::size_t i = 0; i < cast.size(); ++i) {
    const geometry::Box one = cast.box(i);
    all.add(one.minimum);
    all.add(one.maximum);
  }
  return all;
}

/// A character's name, whether it is shown, and away with it.
void show_row(PanelContext& context, Cast& cast, Files& files, std::size_t i) {
  const Character& one = cast.at(i);
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x - 2 * (context.unit + spacing);
  ButtonLook look{width, i == cast.active(), "Work on this character"};
  look.left_aligned = true;
  const std::string name = one.name;
  if (icon_button(context, (name + "##in list").c_str(), look)) cast.ask_for(i);
  ImGui::SameLine();
  ImGui::BeginDisabled(i == cast.active());
  if (icon_button(context, ("Shown##" + name).c_str(),
                  {context.unit, one.shown && i != cast.active(), one.shown ? "Hide it" : "Show it", k_eye, false}))
    cast.show(i, !one.shown);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!cast.several());
  if (icon_button(context, ("Away##" + name).c_str(),
                  {context.unit, false, "Take it away; it can be brought back", icon::k_cross, false}))
    files.remove(i);
  ImGui::EndDisabled();
}

/// Where the one stands that is worked on.
void show_place(PanelContext& context, Cast& cast) {
  geometry::Placement to = cast.at(cast.active()).placement;
  const double far = k_far_sizes * std::max(box_of_all(cast).diagonal(), 1e-6);
  const float width = ImGui::GetContentRegionAvail().x;
  bool released = false;
  double size = std::log10(to.scale);
  bool moved = tall_slider(context, "##aside", to.at.x, -far, far, width, "Aside", released);
  moved = tall_slider(context, "##up", to.at.y, -far, far, width, "Up", released) || moved;
  moved = tall_slider(context, "##forth", to.at.z, -far, far, width, "Forth", released) || moved;
  moved = tall_slider(context, "##turned", to.turn_degrees, -180, 180, width, "Turn", released) || moved;
  const bool sized = tall_slider(context, "##size", size, std::log10(k_least_size), std::log10(k_largest_size), width,
                                 "Size (powers of ten)", released);
  if (sized) to.scale = std::pow(10.0, size);
  if (moved || sized) cast.place(cast.active(), to);
}

}  // namespace

void show_add_character_dialog(PanelContext& context, Files& files, Notices& notices, Preferences& preferences,
                               Dialogs& dialogs) {
  const BrowsedWith with{files, preferences, dialogs};
  if (begin_dialog(context, "Add a character", k_add_dialog_wide)) {
    ImGui::TextDisabled("It stands beside what is open; both are saved as one project");
    std::string chosen = browse(context, with, {opened_kinds(), 8});
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
    ImGui::SameLine();
    if (wide_button(context, "Head with controls", 0, false, "The built-in head with its controls"))
      chosen = "builtin:demo";
    ImGui::SameLine();
    if (wide_button(context, "Head alone", 0, false, "The built-in head, to sketch controls on"))
      chosen = "builtin:head";
    if (!chosen.empty()) {
      if (const auto added = files.add(chosen); !added) {
        notices.tell(added.error().line(chosen), true);
      } else {
        dialogs.close();
      }
    }
  }
  end_dialog();
}

void show_characters_dialog(PanelContext& context, Cast& cast, Files& files, Dialogs& dialogs) {
  if (begin_dialog(context, "Characters", k_cast_dialog_wide)) {
    const auto rows = static_cast<float>(std::min<std::size_t>(cast.size(), 6));
    begin_list(context, "cast", {0, (rows + 0.5F) * (context.unit + ImGui::GetStyle().ItemSpacing.y)}, true);
    for (std::size_t i = 0; i < cast.size(); ++i) show_row(context, cast, files, i);
    ImGui::EndChild();
    auto& entry = dialogs.state<CharacterNameEntry>();
    const std::pair now(cast.active(), cast.revision());
    if (context.dialog_opens || std::pair(entry.of, entry.revision) != now)
      entry = {cast.at(cast.active()).name, cast.active(), cast.revision()};
    bool accepted = false;
    text_field(context, "##character name", entry.text, -1, "its name", &accepted);
    if (accepted || (!ImGui::IsItemActive() && entry.text != cast.at(cast.active()).name))
      cast.rename(cast.active(), entry.text);
    if (cast.several()) show_place(context, cast);
    if (wide_button(context, "Add##character", 0, false, "Open a model or a project beside what is open"))
      dialogs.show(Dialog{"add character"});
    if (cast.several()) {
      ImGui::SameLine();
      if (wide_button(context, "Stand beside##character", 0, false, "Put it beside the others again"))
        cast.place_beside(cast.active());
    }
    ImGui::SameLine();
    if (wide_button(context, "Done##characters", -1, true)) dialogs.close();
  }
  end_dialog();
}

}  // namespace penpose::app
