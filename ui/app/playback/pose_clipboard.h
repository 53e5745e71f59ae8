#pragma once

#include <string>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A pose that was copied, by the names of its controls: it can be put on the same model later, and on another one that
/// has them.
struct PoseClipboard {
  std::vector<document::NamedValue> values;
  std::string name;  ///< of the key that it was copied from; empty: of none
};

/// The pose as it stands, with the name of the key at that moment.
[[nodiscard]] PoseClipboard copied_pose(const document::Document& document, double time_s);
/// The values of the clipboard that a document's model has and that differ from its pose, within their ranges.
[[nodiscard]] document::SetParameters pasted_values(const document::Document& document, const PoseClipboard& clipboard);
/// The same pose with left and right exchanged, for a document's model; where the model has no such controls it stays.
[[nodiscard]] PoseClipboard mirrored(const document::Document& document, const PoseClipboard& clipboard);
/// Keys it at a moment, in one step.
void paste_pose(EditingSession& editing, const PoseClipboard& clipboard, double time_s);

}  // namespace penpose::app
