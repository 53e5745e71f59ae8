#pragma once

#include <string>
#include <vector>

#include "ui/app/files/files.h"

namespace penpose::app {

/// Files of some extensions, as a dialog offers them; without any: every file.
struct FileKind {
  const char* label;
  std::vector<std::string> extensions;
};

/// What opens: models, and what a session or a trace is kept in; each alone; every file.
[[nodiscard]] const std::vector<FileKind>& opened_kinds();
[[nodiscard]] const std::vector<FileKind>& picture_kinds();
/// Pictures and films that one animates after.
[[nodiscard]] const std::vector<FileKind>& reference_kinds();
[[nodiscard]] const std::vector<FileKind>& sound_kinds();

/// What is offered to save under: the project's own name, or a free one that is never that of the model that was
/// opened.
[[nodiscard]] std::string name_to_save(const Files& files, const std::string& folder);
/// A free name for a copy for other programs.
[[nodiscard]] std::string name_to_export(const Files& files, const std::string& folder);

}  // namespace penpose::app
