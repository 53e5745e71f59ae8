#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace penpose::files {

/// The plain files of a folder that are wanted, in the order of their names, numbers as numbers; nothing where `path`
/// is no folder. Errors: it cannot be looked at or read.
[[nodiscard]] base::Result<std::optional<std::vector<std::string>>> folder_files(
    const std::string& path, const std::function<bool(const std::filesystem::path&)>& wanted);

}  // namespace penpose::files
