#include "ui/app/cast/cast_actions.h"

#include <array>

#include "ui/app/owners.h"

namespace penpose::app {
namespace {

bool are_several(App& app) { return app.of<Cast>().several(); }

/// Works on the character after the one that is worked on, or before it.
void step_character(Cast& cast, int by) {
  const auto count = static_cast<int>(cast.size());
  cast.ask_for(static_cast<std::size_t>((static_cast<int>(cast.active()) + by + count) % count));
}

/// Hides all that are not worked on, or shows them where they are hidden.
void show_or_hide_others(Cast& cast) {
  bool any = false;
  for (std::size_t i = 0; i < cast.size(); ++i) any = any || (i != cast.active() && cast.at(i).shown);
  for (std::size_t i = 0; i < cast.size(); ++i) {
    if (i != cast.active()) cast.show(i, !any);
  }
}

// clang-format off
constexpr std::array k_cast_actions{
    ActionInfo{{"add_character"}, "Add a character", {'a', true, true}, {},
     "Open a model or a project beside what is open; both are drawn and saved as one project",
     "C9 8 4M2 20A9 20 7 180 360M19 8L19 16M15 12L23 12",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"add character"}); })},
    ActionInfo{{"next_character"}, "Next character", {k_key_tab, true, false}, {}, "Work on the next character of the scene",
     "C7 9 3M2 19A7 19 5 180 360M13 12L22 12M18 8L22 12L18 16",
     does([](Cast& cast) { step_character(cast, 1); }), are_several},
    ActionInfo{{"previous_character"}, "Character before", {k_key_tab, true, true}, {},
     "Work on the character before in the list", "C17 9 3M12 19A17 19 5 180 360M11 12L2 12M6 8L2 12L6 16",
     does([](Cast& cast) { step_character(cast, -1); }), are_several},
    ActionInfo{{"characters"}, "Characters", {}, {}, "Names of the characters, where they stand, which are shown",
     "C8 8 3.5M2 19A8 19 6 180 360C17 9 2.5M15 19A18 19 4 200 360",
     does([](Dialogs& dialogs) { dialogs.show(Dialog{"characters"}); })},
    ActionInfo{{"frame_characters"}, "All characters", {k_key_home, true, false}, {}, "Show all characters of the scene",
     "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15C9 12 2.5C15 12 2.5",
     does([](Cast& cast) { cast.frame_all(); }), are_several},
    ActionInfo{{"other_characters"}, "Hide the others", {'h', false, true}, {},
     "Hide the characters that are not worked on; again: show them",
     "M2 12L7 7L12 6L17 7L22 12L17 17L12 18L7 17ZM4 4L20 20", does<show_or_hide_others>, are_several},
    ActionInfo{{"stand_beside"}, "Stand beside", {}, {}, "Put the character beside the others again",
     "C7 9 3M2 19A7 19 5 180 360C17 9 3M12 19A17 19 5 180 360M12 3L12 7",
     does([](Cast& cast) { if (cast.several()) cast.place_beside(cast.active()); }), are_several},
    ActionInfo{{"remove_character"}, "Take the character away", {}, {},
     "Take the character that is worked on out of the project", "C9 8 4M2 20A9 20 7 180 360M15 12L23 12",
     does([](Files& files, Cast& cast) { files.remove(cast.active()); }), are_several},
    ActionInfo{{"bring_back_character"}, "Bring back the character", {}, {},
     "The character that was taken away last stands where it stood", "C9 8 4M2 20A9 20 7 180 360M22 9L16 9M19 6L16 9L19 12",
     does([](Cast& cast) { cast.bring_back(); }), does([](Cast& cast) { return cast.can_bring_back(); })},
};
// clang-format on

}  // namespace

std::span<const ActionInfo> cast_actions() { return k_cast_actions; }

}  // namespace penpose::app
