#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/history.h"

namespace penpose::app {

// The steps of a history as an animator counts them: moving in time is none, and what one touch did (a stroke with its
// key, a pose on both sides) is one.

/// Which commands of a history belong to the one before them, by their number in it.
class JoinedCommands {
 public:
  /// A command was performed as number `command`: what was redone after it is gone.
  void performed(std::size_t command, bool joined);
  [[nodiscard]] bool holds(std::size_t command) const { return joined_.contains(command); }
  void clear() { joined_.clear(); }

 private:
  std::set<std::size_t> joined_;
};

/// One step of the list.
struct ListedStep {
  std::string text;     ///< what was done, in an animator's words
  std::size_t end = 0;  ///< how many commands are done when it is
  bool undone = false;
};

/// All steps, the oldest first.
[[nodiscard]] std::vector<ListedStep> listed_steps(const document::History& history, const JoinedCommands& joined);

/// How many commands undo takes back, and redo brings back, for one step; 0: there is none.
[[nodiscard]] std::size_t commands_to_undo(const document::History& history, const JoinedCommands& joined);
[[nodiscard]] std::size_t commands_to_redo(const document::History& history, const JoinedCommands& joined);

}  // namespace penpose::app
