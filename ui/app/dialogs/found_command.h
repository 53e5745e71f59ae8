#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/words/control_words.h"
#include "ui/app/key_map.h"

namespace penpose::app {

/// Something that can be done, found by its name.
struct FoundCommand {
  enum class Kind : std::uint8_t { action, control, pose, file };
  Kind kind = Kind::action;
  std::string text;    ///< what it is called
  std::string detail;  ///< its key, its value, where it lies
  Action action = Action::tool_pose;
  double time_s = 0;         ///< of a pose
  std::string control = {};  ///< its name in files
};

inline constexpr std::size_t k_most_found = 200;

/// Where things are looked for, besides among actions.
struct SearchedIn {
  const document::Document& document;
  const KeyMap& keys;
  int rate = 24;  ///< frames a second
  std::span<const std::string> recent_files;
  std::span<const document::ControlWords> words = {};  ///< one a parameter; empty: controls are called by their names
};

/// Actions, controls, keyed poses and recent files with all words of the text in their names or in what is said of
/// them, the best first; without any text the actions as they are listed.
[[nodiscard]] std::vector<FoundCommand> find_commands(const SearchedIn& in, std::string_view text);

}  // namespace penpose::app
