#pragma once

#include <span>
#include <string>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"

namespace penpose::app {

/// The folder of FileChoice with its parent, its folders, and its files with some extensions (".wav"), `height` px
/// high. Gives the file that was chosen; empty: none was.
[[nodiscard]] std::string browse(PanelContext& context, Dialogs& dialogs, float height,
                                 std::span<const std::string> extensions);

}  // namespace penpose::app
