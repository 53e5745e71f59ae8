#pragma once

#include <string>

namespace penpose::app {

/// Where films go that nobody names: the folder of the project; before the first save the user's folder of films, as
/// the desktop has it (XDG_VIDEOS_DIR), or else the home folder.
[[nodiscard]] std::string film_folder(const std::string& project);

/// What films of a project, or of the model that was opened, are called, without an ending.
[[nodiscard]] std::string film_stem(const std::string& project, const std::string& opened);

}  // namespace penpose::app
