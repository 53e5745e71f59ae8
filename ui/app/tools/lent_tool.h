#pragma once

#include <cstdint>
#include <optional>

#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A tool that is taken for one line, such as a line of a control or of a target drawn again: after it, or when it is
/// given up, the tool from before is in hand again.
class LentTool {
 public:
  explicit LentTool(EditingSession& editing) : editing_(editing) {}

  void lend(const drawing::Tool& tool);
  [[nodiscard]] bool lent() const { return before_ && editing_.editor().tool() == tool_; }
  void give_back();

  // The pen on the canvas. A line that did nothing is tried again.
  void press() { pressed_revision_ = editing_.revision(); }
  void release();
  /// Another document was opened.
  void forget() { before_.reset(); }

 private:
  EditingSession& editing_;
  drawing::Tool tool_;
  std::optional<drawing::Tool> before_;
  std::uint64_t pressed_revision_ = 0;
};

}  // namespace penpose::app
