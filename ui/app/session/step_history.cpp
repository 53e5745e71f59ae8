#include "ui/app/session/step_history.h"

#include "ui/app/session/editing_session.h"

namespace penpose::app {

std::size_t StepHistory::can_undo() const { return commands_to_undo(editing_.editor().history(), joined_); }

std::size_t StepHistory::can_redo() const { return commands_to_redo(editing_.editor().history(), joined_); }

std::vector<ListedStep> StepHistory::list() const { return listed_steps(editing_.editor().history(), joined_); }

void StepHistory::undo() {
  for (std::size_t n = can_undo(); n > 0; --n) editing_.act(replay::Undone{});
}

void StepHistory::redo() {
  for (std::size_t n = can_redo(); n > 0; --n) editing_.act(replay::Redone{});
}

void StepHistory::go_to(std::size_t commands) {
  const document::History& history = editing_.editor().history();
  while (history.undo_count() > commands && editing_.act(replay::Undone{})) {
  }
  while (history.undo_count() < commands && history.redo_count() > 0 && editing_.act(replay::Redone{})) {
  }
}

}  // namespace penpose::app
