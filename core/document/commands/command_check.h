#pragma once

#include "core/base/result.h"
#include "core/document/commands/command.h"

namespace penpose::document {

/// Whether a session could hold the command: the text of one that passes reads back as it was. Commands that come from
/// another program's memory may hold anything. Errors (place: the member): a number that is not finite or above 1e15, a
/// place beyond a million px, a picture of no size or of more than 32768 px a side, more than 100000 entries in a list,
/// a text that is not UTF-8.
[[nodiscard]] base::Status check_command(const Command& command);

}  // namespace penpose::document
