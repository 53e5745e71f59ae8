#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "core/base/result.h"

namespace penpose::files {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The name that stands for standard input, or for standard output where something is written.
inline constexpr const char* k_standard_stream = "-";

/// Opens what the user names for reading: a plain file, a pipe, or "-" for standard input. Errors: it does not exist,
/// may not be read, is a folder or a device.
[[nodiscard]] base::Result<File> open_input(const std::string& path);

/// Opens a plain file and nothing else, and never waits: a path that stands in a file may name anything. Errors: as of
/// open_input, and pipes.
[[nodiscard]] base::Result<File> open_plain(const std::string& path);

/// Opens a plain file that another file names: it has to lie in `folder` or below, also where links lead to. Errors: as
/// of open_plain, and a name that leads out of the folder.
[[nodiscard]] base::Result<File> open_beside(const std::string& folder, const std::string& name);

}  // namespace penpose::files
