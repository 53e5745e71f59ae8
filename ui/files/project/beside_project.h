#pragma once

#include <filesystem>
#include <string>

namespace penpose::files {

// How a project names files that belong to it: relative where they lie beside or below it, else by their whole path.

/// The folder that a project lies in.
[[nodiscard]] std::filesystem::path project_folder(const std::string& project);

/// What a project calls a file. `project`: its path; empty: there is none yet.
[[nodiscard]] std::string name_beside(const std::string& path, const std::string& project);

/// The path of a file that a project names; empty: it is relative, and no project is known.
[[nodiscard]] std::string path_beside(const std::string& name, const std::string& project);

/// What a project that is saved at `project` calls a file that the document of `before` (a path; empty: none) calls
/// `name`.
[[nodiscard]] std::string renamed_beside(const std::string& name, const std::string& before,
                                         const std::string& project);

}  // namespace penpose::files
