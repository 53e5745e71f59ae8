#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/app/dialogs/file_browser.h"

namespace penpose::app {

/// The rows of what is listed, with pictures of what has some. Gives the one that was pressed. `follows`: the one that
/// was chosen comes into sight.
[[nodiscard]] std::optional<FileEntry> show_file_rows(PanelContext& context, const FileBrowser& browser, bool follows);
/// A line that says which folder it is, of which the end is seen where not all fits.
void show_folder_line(PanelContext& context, const std::string& text);
/// The icon of a place.
[[nodiscard]] std::string_view icon_of(FilePlace::Kind kind);

}  // namespace penpose::app
