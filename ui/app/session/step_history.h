#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ui/app/session/step_list.h"

namespace penpose::app {

class EditingSession;

/// The steps of a session as an animator counts them (step_list.h), back and forth.
class StepHistory {
 public:
  explicit StepHistory(EditingSession& editing) : editing_(editing) {}

  /// Takes back one step, and the moves in time on the way.
  void undo();
  void redo();
  /// Undoes or redoes until so many commands are done.
  void go_to(std::size_t commands);
  /// How many commands `undo` takes back, and `redo` brings back; 0: there is no such step.
  [[nodiscard]] std::size_t can_undo() const;
  [[nodiscard]] std::size_t can_redo() const;
  [[nodiscard]] std::vector<ListedStep> list() const;

  /// A command was performed as number `command`; `joined`: as a part of the one before it.
  void performed(std::size_t command, bool joined) { joined_.performed(command, joined); }
  void forget() { joined_.clear(); }
  /// Which commands belong together, while another document is worked on, and afterwards.
  [[nodiscard]] JoinedCommands take_joined() { return std::exchange(joined_, {}); }
  void give_joined(JoinedCommands joined) { joined_ = std::move(joined); }

 private:
  EditingSession& editing_;
  JoinedCommands joined_;
};

}  // namespace penpose::app
