#pragma once

#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"

namespace penpose::app {

/// Returns the commands, to be performed as one step, that exchange left and right of keys: values and how they go on.
/// A control of the other side that has no key at that moment gets one. Keys of controls without another side stay.
/// Empty: nothing changes. Precondition: keys of the document.
[[nodiscard]] std::vector<document::Command> mirrored_keys(const document::Document& document,
                                                           const document::OfKeys& keys);

}  // namespace penpose::app
