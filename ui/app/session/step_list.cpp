#include "ui/app/session/step_list.h"

#include <utility>

namespace penpose::app {
namespace {

using document::History;

bool moves_in_time(const History& history, std::size_t step) {
  return history.called_step(step).name == document::GoToTime::k_called.name;
}

}  // namespace

void JoinedCommands::performed(std::size_t command, bool joined) {
  joined_.erase(joined_.lower_bound(command), joined_.end());
  if (joined) joined_.insert(command);
}

std::vector<ListedStep> listed_steps(const History& history, const JoinedCommands& joined) {
  std::vector<ListedStep> steps;
  const std::size_t count = history.undo_count() + history.redo_count();
  for (std::size_t i = 0; i < count; ++i) {
    if (moves_in_time(history, i)) continue;
    if (joined.holds(i) && !steps.empty()) {
      steps.back().end = i + 1;
    } else {
      steps.push_back({std::string(history.called_step(i).words), i + 1, false});
    }
    steps.back().undone = steps.back().end > history.undo_count();
  }
  return steps;
}

std::size_t commands_to_undo(const History& history, const JoinedCommands& joined) {
  std::size_t at = history.undo_count();
  while (at > 0 && (moves_in_time(history, at - 1) || joined.holds(at - 1))) --at;
  return at == 0 ? 0 : history.undo_count() - (at - 1);
}

std::size_t commands_to_redo(const History& history, const JoinedCommands& joined) {
  const std::size_t done = history.undo_count();
  const std::size_t count = done + history.redo_count();
  std::size_t at = done;
  while (at < count && moves_in_time(history, at)) ++at;
  if (at == count) return 0;
  ++at;
  // What belongs to it, with the moves in time before that.
  for (std::size_t next = at; next < count; ++next) {
    if (joined.holds(next)) at = next + 1;
    if (!joined.holds(next) && !moves_in_time(history, next)) break;
  }
  return at - done;
}

}  // namespace penpose::app
