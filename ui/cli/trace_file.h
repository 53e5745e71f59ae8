#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "replay/trace_reader.h"

namespace penpose::cli {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Opens a trace or a session for reading. Errors: it does not exist, may not be read, is a folder.
[[nodiscard]] base::Result<File> open_trace(const std::string& path);

/// Reads an open file from where it stands; the file must outlive what is returned.
[[nodiscard]] replay::ReadBytes read_from_file(std::FILE* file);

}  // namespace penpose::cli
