#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ui/app/action.h"

namespace penpose::app {

class App;

/// Something that can be done, found by its name.
struct FoundCommand {
  enum class Kind : std::uint8_t { action, control, pose, file };
  Kind kind = Kind::action;
  std::string text;    ///< what it is called
  std::string detail;  ///< its key, its value, where it lies
  Action action = Action::tool_pose;
  double time_s = 0;  ///< of a pose
};

inline constexpr std::size_t k_most_found = 60;

/// Actions, controls, keyed poses and recent files with all words of the text in their names or in what is said of
/// them, the best first; without any text the actions as they are listed.
[[nodiscard]] std::vector<FoundCommand> find_commands(App& app, std::string_view text);

/// Does it: an action; a control is shown alone in the panel; the playhead goes to a pose; a file is opened.
void do_found(App& app, const FoundCommand& found);

}  // namespace penpose::app
